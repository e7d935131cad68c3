// Chooses whose strength a search reduces: joints, rock or both, without exempt materials and regions.
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

/// Whose strength is divided.
enum class Reduced { joints, rock, both };

/// A word for tables: "joints", "rock", "both".
std::string name_of(Reduced what);

/// Throws std::invalid_argument for a word that is none.
Reduced reduced_of(const std::string& name);

/// A search for the factor of safety as somebody asks for it; what is left open is taken from `case.json`, else usual.
struct ReductionAsked {
  std::optional<Reduced> what;
  std::optional<double> from, to;
  std::optional<double> within;          ///< width of the bracket
  std::vector<std::string> exempt = {};  ///< as `exempt_of` reads them

  static constexpr double kWithin = 0.01;  ///< unless asked otherwise
};

/// What `given` leaves open is that of `of_case`; then joints, and the usual width.
ReductionAsked completed(ReductionAsked given, const std::optional<ReductionAsked>& of_case);

/// A polygon in the undeformed scene, in its unit of length.
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

/// Numbers of parts that a region holds.
struct ExemptCount {
  std::size_t elements = 0;  ///< blocks or elements of NMM bodies whose centroid it holds
  std::size_t edges = 0;     ///< edges with a joint material whose middle it holds
};

/// Gives the elements and joint edges inside the regions other materials: number n becomes n + `block_materials`, or
/// n + `joint_materials` for edges. `prepared` must hold materials of these numbers.
ExemptCount exempt_regions(Prepared& prepared, const Exempt& exempt, int block_materials, int joint_materials);

}  // namespace keyblock
