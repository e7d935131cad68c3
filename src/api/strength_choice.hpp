// Selects the strengths that a search reduces: joints, rock or both, without exempt materials and regions. Theory:
// docs/theory/11-strength-reduction.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geometry/point.hpp"
#include "problem/problem.hpp"
#include "run/prepare.hpp"

namespace keyblock {

/// Parts whose strength is divided.
enum class Reduced { joints, rock, both };

/// Returns a word for tables: "joints", "rock", "both".
std::string name_of(Reduced what);

/// Throws std::invalid_argument for another word.
Reduced reduced_of(const std::string& name);

/// Requested search for the factor of safety. Missing values are taken from `case.json`, otherwise from the defaults.
struct ReductionAsked {
  std::optional<Reduced> what;
  std::optional<double> from, to;
  std::optional<double> within;          ///< width of the bracket
  std::vector<std::string> exempt = {};  ///< in the form that `exempt_of` reads

  static constexpr double kWithin = 0.01;  ///< default
};

/// Completes `given` from `of_case`, then with joints and the default width.
ReductionAsked completed(ReductionAsked given, const std::optional<ReductionAsked>& of_case);

/// Polygon in the undeformed scene, in its unit of length.
struct ExemptRegion {
  std::string words;  ///< as the user wrote it
  std::vector<Point> outline;
};

struct Exempt {
  std::set<int> block_materials;  ///< numbers, from 0
  std::set<int> joint_materials;  ///< numbers, from 0
  std::vector<ExemptRegion> regions;
  std::vector<std::string> words;  ///< of all, as the user wrote them

  bool is_empty() const { return words.empty(); }
};

/// Reads "material:2", "joint_material:3" (numbers from 1), "box:x1,y1,x2,y2" and "polygon:x1,y1,x2,y2,x3,y3,…". Throws
/// std::invalid_argument that names the word.
Exempt exempt_of(const std::vector<std::string>& words);

/// Throws InputError if a material does not exist, or if a region is given for a case with stages.
void require_exempt(const Exempt& exempt, const Problem& problem);

/// Number of parts inside a region.
struct ExemptCount {
  std::size_t elements = 0;  ///< blocks or elements of NMM bodies with centroid inside
  std::size_t edges = 0;     ///< edges with a joint material and middle inside
};

/// Gives the elements and joint edges inside the regions other materials: number n becomes n + `block_materials`, or
/// n + `joint_materials` for edges. `prepared` must hold materials of these numbers.
ExemptCount exempt_regions(Prepared& prepared, const Exempt& exempt, int block_materials, int joint_materials);

}  // namespace keyblock
