// Reads the cover and analysis files of Shi's manifold program, which may be used here but not shipped.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <variant>

#include "formats/case.hpp"
#include "problem/cover.hpp"
#include "tests/support/shared_folder.hpp"

namespace keyblock {

inline constexpr std::array<const char*, 12> kSampleNumbers = {"01", "02", "03", "04", "06", "07",
                                                               "09", "10", "12", "13", "14", "15"};

inline std::filesystem::path sample_covers() {
  return shared_folder() / "legacy_samples" / "pythonwithnmm";
}

inline bool has_sample_covers() {
  return std::filesystem::exists(sample_covers());
}

/// `cvNN` with `mfNN`.
inline Problem sample_pair(const std::string& number) {
  return formats::load_case(
             {(sample_covers() / ("cv" + number)).string(), (sample_covers() / ("mf" + number)).string()})
      .problem;
}

/// Reads `cvNN` alone, with material numbers as in the file.
inline Cover sample_cover(const std::string& number) {
  return std::get<Cover>(formats::load_case({(sample_covers() / ("cv" + number)).string()}).problem.geometry);
}

}  // namespace keyblock
