// Brings numbers of materials into the range of those that exist.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "problem/problem.hpp"

namespace keyblock {

/// A number out of range, at the place where it is first.
struct NumberOutOfRange {
  Finding finding;  ///< of the warning: "joint material 3 of 14 edges is outside 1 to 1; taken as 1"
  Place place;
  std::string error;  ///< "expected a joint material from 1 to 1, found 3 (of 14 edges)"
};

/// Replaces numbers out of range by the nearest, as the old programs do, and counts them.
class NumberRange {
 public:
  /// `noun`: of what is numbered. `count`: of such things; without any, numbers stay as they are.
  NumberRange(std::string noun, std::size_t count);

  /// Returns the number in range, from 0.
  int operator()(int number, const Place& place);

  /// Returns the numbers that were replaced. `carriers`: what they are numbers of.
  std::vector<NumberOutOfRange> replaced(const std::string& code, std::string_view carriers) const;

 private:
  struct Met {
    Place place;
    int times = 0;
  };
  std::string noun_;
  int last_;
  std::map<int, Met> met_;
};

/// Bring the numbers of joint and block materials into the range of those of the analysis, and return the others.
std::vector<NumberOutOfRange> clamp_materials(Drawing& drawing, const Analysis& analysis);
std::vector<NumberOutOfRange> clamp_materials(Blocks& blocks, const Analysis& analysis);
std::vector<NumberOutOfRange> clamp_materials(Cover& cover, const Analysis& analysis);

}  // namespace keyblock
