// Holds the NMM bodies of a case file: mesh, functions, supports, loads and excavations.
// Theory: docs/theory/08-manifold-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "geometry/point.hpp"
#include "problem/analysis.hpp"
#include "problem/formula.hpp"
#include "problem/limits.hpp"
#include "problem/load_list.hpp"

namespace keyblock {

/// Functions P_i(x) of a physical cover i for the displacement around it. The weights λ_i of the triangle join the
/// three covers of an element, u = Σ λ_i P_i.
enum class CoverFunctions {
  constant,  ///< P_i = d_i: first order as in Shi's programs, 2 unknowns per cover
  derived,   ///< P_i = d_i + ½ g_i · (x - x_i), g_i from the covers around (derived_gradients): quadratic, 2 unknowns
  linear,    ///< with 1, x, y: quadratic, 6 unknowns per cover, some of them dependent
  quadratic,  ///< with 1 to y²: cubic, 12 unknowns, some of them dependent
};

enum class MeshKind { regular, unstructured };

enum class MeshShape {
  equilateral,  ///< dx = 2/√3 dy
  old,          ///< dx = 1.3 dy, as in Shi's manifold cutter (legacy-formats 2.4; one of its samples differs)
};

enum class MeshPlacement {
  free,     ///< no alignment
  aligned,  ///< rows on the lower and the upper edge; unstructured: sides along all lines
};

/// Point at which sides of triangles may be no longer than `side`.
struct RefinedPoint {
  Point at;
  double side = 0;
};

/// Functions that covers near the tips of cracks have besides those of all covers.
enum class TipFunctions {
  none,
  williams,  ///< leading fields of a crack tip (Williams 1957): eight unknowns per cover; covers around them get
             ///< gradients of their own
};

/// Applies to covers whose nodes are nearer to a tip than `radius`; 0: three sides of the triangles at the tip.
struct TipFunctionPlan {
  TipFunctions kind = TipFunctions::none;
  double radius = 0;

  bool are_asked() const { return kind != TipFunctions::none; }
};

/// Blocks of this material are given covers.
struct MeshedMaterial {
  int material = 0;  ///< block material, index from 0
};

/// felt: bodies, and the two sides of a joint, have contact as blocks do, and each step includes its forces. ignored:
/// they pass through each other, and each load step is one linear solve.
enum class CoverContact { felt, ignored };

// Ranges of file keys and command settings for mesh refinement by error.
inline constexpr Range kMeshErrorRange{0, false, 1, true};
inline constexpr const char* kMeshErrorExpected = "a number from 0 to below 1";
inline constexpr Range kMeshLimitRange{1, false, 1e6};
inline constexpr const char* kMeshLimitExpected = "a whole number from 1 to 1000000";

/// Plan of the mesh: a regular mesh has `half_rows` or `side`, an unstructured one `side`. Without either there is no
/// mesh.
struct MeshPlan {
  MeshKind kind = MeshKind::regular;
  int half_rows = 0;  ///< n rows of Shi's density rule to either side of the middle
  double side = 0;    ///< of the triangles; in an unstructured mesh the longest
  MeshShape shape = MeshShape::equilateral;
  double angle_deg = 0;  ///< of the rows to the x axis
  MeshPlacement placement = MeshPlacement::free;
  std::optional<double> through_x;  ///< place of a node of a regular mesh; else the placement decides
  std::optional<double> through_y;
  std::vector<RefinedPoint> refined;
  double error = 0;           ///< allowed error of stresses, as a share of the energy norm; 0: no refinement
  int most_unknowns = 50000;  ///< limit at which refinement by error stops
  double tip_side = 0;        ///< at the tips of cracks; 0: as elsewhere
  TipFunctionPlan tip_functions = {};
  bool has_nodes_at_tips =
      false;              ///< independent of sides or functions at tips; no file sets it, only refinement by error
  double snap_ratio = 0;  ///< nodes nearer to lines than this share of the mesh's scale move onto them
  std::vector<MeshedMaterial>
      materials;  ///< of the blocks that are given covers, the others stay blocks; empty: all are
  Place place;
};

struct ForcePlan {
  Point at;
  Point force;
  Place place;
};

struct SpringPlan {
  Point at;
  Point direction;
  double stiffness = 0;
  Place place;
};

struct BodyForcePlan {
  Formula x, y;
};

/// Stress, tension positive. Without `zz` the stress across the plane, under plane strain, is ν (xx + yy).
struct StressPlan {
  Formula xx, yy, xy;
  std::optional<Formula> zz = {};
};

/// Excavation: rock within the outline is removed from load step `step` (the first is 1) on.
struct ExcavationPlan {
  int step = 1;
  std::vector<Point> outline;
  Place place;
  int joint_material = 0;  ///< of the edges that it makes, index from 0
};

/// Crack, drawn in the undeformed bodies; both faces have this joint material, index from 0. An end on a boundary, a
/// joint or another crack is no tip.
struct CrackPlan {
  std::vector<Point> along;
  Place place;
  int joint_material = 0;
  bool is_shear = false;  ///< it started in shear during the run
};

/// Criterion for the direction in which a tip propagates.
enum class GrowthCriterion {
  hoop_stress,     ///< greatest hoop stress (Erdogan & Sih 1963)
  strain_energy,   ///< least strain energy density (Sih 1974)
  energy_release,  ///< greatest energy release rate (Amestoy & Leblond 1992)
};

/// Loads under which tips propagate.
enum class GrowthLoads {
  automatic,  ///< scaled in statics with NMM bodies only, else given
  scaled,     ///< all loads times one factor per load step, at which one tip reaches its toughness
  given,      ///< those of the file, dynamic or static: tips propagate that have reached their toughness
};

/// Plan of crack growth; tips propagate by `increment`.
struct GrowthPlan {
  GrowthCriterion criterion = GrowthCriterion::hoop_stress;
  GrowthLoads loads = GrowthLoads::automatic;
  double increment = 0;
  bool has_corrector =
      true;  ///< under scaled loads: the kink is the mean of those before and after a trial of the step
  Place place;
};

struct CoverPlan {
  std::optional<CoverFunctions> functions;  ///< empty: chosen by `functions_of`
  CoverContact contact = CoverContact::felt;
  MeshPlan mesh;
  std::vector<TractionPlan> tractions;
  std::vector<DisplacementPlan> displacements;
  std::vector<ForcePlan> forces;
  std::vector<SpringPlan> springs;
  BodyForcePlan body_force;   ///< added to the weight of the materials
  StressPlan initial_stress;  ///< added to that of the materials
  std::vector<ExcavationPlan> excavations;
  std::vector<CrackPlan> cracks = {};
  std::optional<GrowthPlan> growth = {};
  Place place;
};

/// Returns the functions of the plan. Without any it returns constant ones if rock may yield, because others lock in
/// flow at constant volume; otherwise derived ones.
inline CoverFunctions functions_of(const CoverPlan& plan, const std::vector<BlockMaterial>& materials) {
  if (plan.functions) return *plan.functions;
  for (const BlockMaterial& material : materials)
    if (material.strength) return CoverFunctions::constant;
  return CoverFunctions::derived;
}

/// Adds loads that act on all bodies to those of the plan. NMM bodies have no displacements that change over time.
inline void add(CoverPlan& plan, const LoadList& loads) {
  const auto put = [](auto& list, auto part) {
    part.acts_on_all = true;
    list.push_back(std::move(part));
  };
  for (const TractionPlan& part : loads.tractions) put(plan.tractions, part);
  for (const DisplacementPlan& part : loads.displacements)
    if (!part.changes_over_time()) put(plan.displacements, part);
}

}  // namespace keyblock
