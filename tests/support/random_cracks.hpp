// Builds a square of rock with random cracks, under static load and in flight, and measures the errors of cutting,
// solving and transfer.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace keyblock::support {

/// Arrangement of the cracks of a scene.
enum class CrackKind {
  anywhere,        ///< a chain of two to four points
  through_nodes,   ///< of the mesh
  along_sides,     ///< of the mesh, from node to node, or 1e-12 to 1e-3 beside them
  nearly_closed,   ///< back to 1e-12 to 1e-3 from its beginning, or a second crack as near beside the first
  near_boundary,   ///< ending 1e-12 to 1e-6 before a side of the square
  meeting,         ///< a second one that begins on the first, crosses it or shares its end
  cutting_in_two,  ///< from side to side, straight or kinked, by one or two cracks
};
inline constexpr int kCrackKinds = 7;
const char* name_of(CrackKind kind);

/// A square of side 1 on one mesh, fixed at its lower edge, moved at its upper one and pulled at its sides.
Problem random_cracks(CrackKind kind, unsigned seed);

struct CracksTold {
  std::string refused;              ///< reason for a refusal of the cracks; the rest is then empty
  std::vector<std::string> failed;  ///< error; empty if there is none
  double area = 0;                  ///< difference between the areas of elements and square
  bool has_free_piece = false;      ///< the cracks cut off a free piece: no statics, and a message names it
  double residual = 0;              ///< of the static solution
  int tips = 0;
  int domains = 0;
  int refused_domains = 0;  ///< messages that name the obstacle
  /// Covers with gradients of their own lose their mass in round-off on thin pieces; such scenes are refused.
  bool unfit_to_fly = false;
  double carried = 0;  ///< linear and angular momentum that the flying square loses when it gets its cracks
  // Closures over the steps before and after. Angular momentum closes as well as the search of a step, which ends when
  // increments change by 1e-12 of the size of a body.
  double linear = 0;
  double angular = 0;
  double energy = 0;
};
CracksTold told_of_cracks(const Problem& problem);

}  // namespace keyblock::support
