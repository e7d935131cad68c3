// Looks up the quantity of a number in the table of meanings.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/case_measures.hpp"

#include <string>

#include "formats/case_file/case_meanings.hpp"

namespace keyblock::formats {

std::optional<Measure> measure_of(std::string_view parent, std::string_view key) {
  const std::string full = std::string(parent) + '.' + std::string(key);
  for (const std::string_view wanted : {std::string_view(full), key}) {
    for (const CaseMeaning& row : case_meanings())
      if (row.measure && row.key == wanted) return row.measure;
  }
  return std::nullopt;
}

bool takes_unit(std::string_view parent, std::string_view key) {
  return measure_of(parent, key).value_or(measures::kNumber) != measures::kNumber;
}

bool takes_per_cent(std::string_view parent, std::string_view key) {
  return parent == "initial_strain" || key == "plastic_strain" || key == "closure_strain";
}

}  // namespace keyblock::formats
