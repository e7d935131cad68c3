// Answers about texts that the browser edits and has not saved: check, blocks as cut, rows of joint sets.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "serve/child.hpp"

namespace keyblock::serve {

/// Texts go by files in the folder of drafts. A text that names other files finds none of them there.
class Unsaved {
 public:
  /// Refers to both.
  Unsaved(const Drafts& drafts, const Program& program) : drafts_(drafts), program_(program) {}

  /// Returns blocks and points in them, cut from "text", or of the blocks or the cover that it holds. "path" names the
  /// text and tells its format. Without blocks, the reply has the errors.
  nlohmann::ordered_json blocks(const nlohmann::ordered_json& body) const;

  /// Returns the drawing that `keyblock joints` makes of "spec", in the layout of a case file; or its
  /// errors.
  nlohmann::ordered_json joints(const nlohmann::ordered_json& body) const;

  /// Runs `keyblock check` on "text", with more arguments. Messages name "path" and not the draft.
  Answer check(const nlohmann::ordered_json& body, const std::vector<std::string>& arguments) const;

 private:
  std::filesystem::path draft_of(const nlohmann::ordered_json& body) const;

  const Drafts& drafts_;
  const Program& program_;
};

}  // namespace keyblock::serve
