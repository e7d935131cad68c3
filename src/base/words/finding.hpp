// Holds failures, doubts and warnings as values: code, measured numbers, blocks and points. Words are made of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace keyblock {

/// Values behind a sentence. Decisions read these, never the sentence.
struct Facts {
  std::vector<std::pair<std::string, double>> numbers = {};     ///< by name
  std::vector<std::pair<std::string, std::string>> texts = {};  ///< other parts of the sentence
  std::vector<int> elements = {};                               ///< numbers of blocks or elements, from 1
  std::vector<std::array<double, 2>> points = {};
  std::vector<std::pair<std::string, std::string>> names = {};  ///< by kind: "layer", "setting"; parts of the sentence

  bool operator==(const Facts&) const = default;
};

/// A failure or a doubt. `form` is its code, with `:variant` if the code has several sentences.
struct Finding {
  std::string form = {};
  Facts facts = {};

  bool empty() const { return form.empty(); }
  /// Returns the form without its variant.
  std::string code() const { return form.substr(0, form.find(':')); }
};

}  // namespace keyblock
