// Reads a text in a test and returns the error of a failed reading.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "formats/format.hpp"
#include "formats/registry.hpp"

namespace keyblock::formats {

/// Returns the message of the InputError; empty if the text was read.
inline std::string error_of(const std::string& text, const ReadHint& hint = {}) {
  try {
    read({"f", text}, hint);
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

inline std::vector<std::string> names(const Warnings& warnings) {
  std::vector<std::string> all;
  for (const Warning& warning : warnings) all.push_back(warning.name);
  return all;
}

}  // namespace keyblock::formats
