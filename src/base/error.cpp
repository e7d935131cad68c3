// Formats places, input errors and warnings, so that every message of the program has one form.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/error.hpp"

#include <fmt/format.h>

#include "base/words/diagnostics.hpp"

namespace keyblock {

std::string to_string(const Place& place) {
  if (place.line == 0) return place.file.text();
  if (place.column == 0) return fmt::format("{}:{}", place.file.text(), place.line);
  return fmt::format("{}:{}:{}", place.file.text(), place.line, place.column);
}

InputError::InputError(Place place, const std::string& sentence)
    : std::runtime_error(fmt::format("{}: error: {}", to_string(place), sentence)),
      place_(std::move(place)),
      sentence_(sentence) {}

void add_warning(Warnings& warnings, Warning warning) {
  if (warnings.size() < kMostWarnings)
    warnings.push_back(std::move(warning));
  else if (warnings.size() == kMostWarnings)
    warnings.push_back({"more_warnings", warning.place, "further warnings are not listed"});
}

std::string to_string(const Warning& warning) {
  const DiagnosticLevel level = level_of(warning.name);
  const std::string_view word = level == DiagnosticLevel::silent ? "note" : word_of(level);
  return fmt::format("{}: {}: {} [{}]", to_string(warning.place), word, warning.sentence, warning.name);
}

}  // namespace keyblock
