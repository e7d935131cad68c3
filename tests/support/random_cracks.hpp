// A square of rock with random cracks, at rest under load and flying: what cutting, solving and carrying leave of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace keyblock::support {

/// How the cracks of a scene lie.
enum class CrackKind {
  anywhere,        ///< a chain of two to four points
  through_nodes,   ///< of the mesh
  along_sides,     ///< of the mesh, from node to node, or 1e-12 to 1e-3 beside them
  nearly_closed,   ///< back to 1e-12 to 1e-3 from where it began, or a second crack as near beside the first
  near_boundary,   ///< ending 1e-12 to 1e-6 before a side of the square
  meeting,         ///< a second one that begins on the first, crosses it or shares its end
  cutting_in_two,  ///< from side to side, straight or kinked, by one or two cracks
};
inline constexpr int kCrackKinds = 7;
const char* name_of(CrackKind kind);

/// A square of side 1 on one mesh, held at its lower edge, moved at its upper one and pulled at its sides.
Problem random_cracks(CrackKind kind, unsigned seed);

struct CracksTold {
  std::string refused;              ///< why the cracks were not accepted; the rest is empty then
  std::vector<std::string> failed;  ///< what went wrong; empty: nothing
  double area = 0;                  ///< of the elements, off the square's
  bool has_free_piece = false;      ///< the cracks cut off what nothing holds: no statics, and it is named
  double residual = 0;              ///< of the static solution
  int tips = 0;
  int domains = 0;
  int refused_domains = 0;  ///< which name what is in their way
  /// Covers with gradients of their own lose their mass in round-off on thin pieces; such scenes are refused.
  bool unfit_to_fly = false;
  double carried = 0;  ///< linear and angular momentum that the flying square loses as it gets its cracks
  // Closures over the steps before and after. Angular momentum closes as well as the search of a step, which ends where
  // increments change by 1e-12 of the size of a body.
  double linear = 0;
  double angular = 0;
  double energy = 0;
};
CracksTold told_of_cracks(const Problem& problem);

}  // namespace keyblock::support
