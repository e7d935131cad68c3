// Makes the rows of a sweep: all combinations, values side by side, or a Latin hypercube.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "study/sweep/varied_key.hpp"

namespace keyblock::study {

/// Value of every key for one run: an object with the same keys, in the same order, in all rows.
using SweepRow = nlohmann::ordered_json;

enum class Design {
  grid,    ///< all combinations; the last key varies fastest
  zipped,  ///< first values of all keys, then second ones
  random,  ///< Latin hypercube: of each key, every part of equal probability is used once
};

struct DesignAsked {
  Design design = Design::grid;
  std::size_t count = 0;   ///< of a random design
  std::uint64_t seed = 1;  ///< of a random design; the same seed gives the same rows
};

/// Returns the rows. A random design takes each value of a list with the same probability. Throws
/// std::invalid_argument for a key that comes twice, a distribution in a design that is not random, lists of different
/// lengths in a zipped design, and more than `kMostRows` rows.
std::vector<SweepRow> sweep_rows(const std::vector<VariedKey>& keys, const DesignAsked& asked);

inline constexpr std::size_t kMostRows = 1'000'000;

/// Reads rows from a JSON list of objects. Throws InputError, with the name of the file, for another content.
std::vector<SweepRow> rows_of_file(const std::string& name, const std::string& text);

/// Returns the name of a job: letters and digits that depend on the values of the row alone. 20.0 is the value 20.
std::string job_name(const SweepRow& row);
bool is_job_name(std::string_view name);

}  // namespace keyblock::study
