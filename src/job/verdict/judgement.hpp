// Defines the judgement of a completed run, and how a finding enters it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <utility>

#include "base/error.hpp"
#include "base/sentences/sentences.hpp"
#include "geometry/point.hpp"

namespace keyblock {

struct Judgement {
  Warnings doubts;   ///< why the results are not to be trusted
  Warnings remarks;  ///< checks that could not be made
};

inline void add(Warnings& list, const Place& place, Finding finding) {
  list.push_back(warning_of(std::move(finding), place));
}

inline std::array<double, 2> spot(Point at) {
  return {at.x, at.y};
}

}  // namespace keyblock
