// Lists the loads and supports of a case that act along edges, on DDA blocks and NMM bodies alike.
//
// A load has a place, a kind, a value and the stages in which it acts:
//   place   chain of points along edges: of an outline, or of a joint, on both of its sides
//   kind    traction, pressure (along the outward normal), prescribed displacement of both components, of x, of y or
//           of the normal one
//   value   number, or expression of x, y and the outward normal, all in the undeformed position; of tractions also of
//           the time t, but on NMM bodies only in steps with contact; times a factor over time
//   stages  all of them, or those from a first to a last one
// A list passes through five places, each once:
//   read       formats/case_file: `loads`, in the words of `covers`; `covers` itself lists those of NMM bodies only
//   gathered   problem/checks hands the list to the plan of NMM bodies; run/bodies/edge_loads finds the edges of blocks
//   checked    run/bodies/look_at_plan: chains off all edges, formulas that are not finite
//   assembled  tractions of blocks by `loads_at` (step/scene/standard_scene), as forces on the ends of an edge, of NMM
//              bodies by terms/cover_loads; supports of blocks as rows of `held_pairs` (contact/rows/constraints)
//   booked     as work of the loads on the unknowns: `external` of the energy balance
// Still outside: loads and fixed points of a drawing, accelerations, forces and springs of `covers`, stage forces.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "geometry/point.hpp"
#include "problem/formula.hpp"

namespace keyblock {

/// Prescribed component of the displacement; `normal` with the value 0 is a line of symmetry.
enum class Held { both, normal, x, y };

/// Row of a table of factors over time: linear between rows; before the first and after the last row that of the
/// nearest.
struct FactorAt {
  double time = 0;  ///< times increase strictly
  double factor = 1;

  bool operator==(const FactorAt&) const = default;
};

/// Stages in which a load acts, from 0; without a first from the start, without a last to the end.
struct ActiveStages {
  std::optional<int> first;
  std::optional<int> last;

  bool hold(int stage) const { return stage >= first.value_or(stage) && stage <= last.value_or(stage); }
};

/// Force per length of the boundary along a chain: (x, y) - pressure n, n the normal out of the body.
struct TractionPlan {
  std::vector<Point> along;
  Formula x, y, pressure;
  Place place;
  bool acts_on_all = false;              ///< on every body; else on NMM bodies only
  std::vector<FactorAt> over_time = {};  ///< empty: 1
  ActiveStages stages = {};

  bool uses_time() const { return uses(x, "t") || uses(y, "t") || uses(pressure, "t"); }
  bool changes_over_time() const { return !over_time.empty() || uses_time(); }
};

struct DisplacementPlan {
  std::vector<Point> along;
  Held held = Held::both;
  Formula x, y;
  Formula normal;  ///< outward; if `held` is normal
  Place place;
  bool acts_on_all = false;              ///< on every body; else on NMM bodies only
  std::vector<FactorAt> over_time = {};  ///< empty: 1; on blocks only
  ActiveStages stages = {};

  bool changes_over_time() const { return !over_time.empty(); }
};

struct LoadList {
  std::vector<TractionPlan> tractions;
  std::vector<DisplacementPlan> displacements;
  Place place;

  bool empty() const { return tractions.empty() && displacements.empty(); }
};

/// Returns the list, or the plan of NMM bodies, without the loads that do not act in this stage.
template <class Loads>
Loads acting_in(Loads loads, int stage) {
  const auto is_off = [stage](const auto& part) { return !part.stages.hold(stage); };
  std::erase_if(loads.tractions, is_off);
  std::erase_if(loads.displacements, is_off);
  return loads;
}

}  // namespace keyblock
