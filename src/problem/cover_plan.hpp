// What a case file says of its bodies on covers: the mesh, the functions, what holds and loads the bodies, what is dug
// out.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "base/error.hpp"
#include "geometry/point.hpp"
#include "problem/analysis.hpp"
#include "problem/formula.hpp"

namespace keyblock {

/// What a physical cover i says of the displacement about it, P_i(x); the weights of the triangle λ_i join the three
/// covers of an element, u = Σ λ_i P_i.
enum class CoverFunctions {
  constant,   ///< P_i = d_i: the old programs' first order, 2 unknowns a cover
  derived,    ///< P_i = d_i + ½ g_i · (x - x_i), g_i from the covers about (derived_gradients): quadratic, 2 unknowns
  linear,     ///< with 1, x, y: quadratic, 6 unknowns a cover of which some depend on the others
  quadratic,  ///< with 1 to y²: cubic, 12 unknowns, likewise
};

/// Which component of the displacement is prescribed; `normal` with the value 0 is a line of symmetry.
enum class Held { both, normal, x, y };

enum class MeshKind { regular, unstructured };

enum class MeshShape {
  equilateral,  ///< dx = 2/√3 dy
  old,          ///< dx = 1.3 dy, as the old manifold cutter (legacy-formats 2.4; one of its samples is otherwise)
};

enum class MeshPlacement {
  free,     ///< wherever the mesh comes to stand
  aligned,  ///< rows on the lower and the upper edge; unstructured: sides along all lines
};

/// Sides at this point are to be no longer than `side`.
struct RefinedPoint {
  Point at;
  double side = 0;
};

/// What covers about the tips of cracks say beside the functions of all.
enum class TipFunctions {
  none,
  williams,  ///< the leading fields of a crack tip (Williams 1957): eight unknowns a cover; those around get gradients
             ///< of their own
};

/// On covers whose nodes are nearer to a tip than `radius`; 0: three sides of the triangles at the tip.
struct TipFunctionPlan {
  TipFunctions kind = TipFunctions::none;
  double radius = 0;

  bool are_asked() const { return kind != TipFunctions::none; }
};

/// Blocks of this material are given covers.
struct MeshedMaterial {
  int material = 0;  ///< block material, index from 0
};

/// felt: bodies, and the two sides of a joint, touch as blocks do, and each step is found with their forces; ignored:
/// each load step is one linear solution in which they pass through each other.
enum class CoverContact { felt, ignored };

// What keys of a file and settings of a command may say of a mesh by error.
constexpr bool is_mesh_error(double v) {
  return v >= 0 && v < 1;
}
inline constexpr const char* kMeshErrorExpected = "a number from 0 to below 1";
constexpr bool is_mesh_limit(double v) {
  return v >= 1 && v <= 1e6 && v == static_cast<int>(v);
}
inline constexpr const char* kMeshLimitExpected = "a whole number from 1 to 1000000";

/// A regular mesh has `half_rows` or `side`, an unstructured one `side`; with neither there is none.
struct MeshPlan {
  MeshKind kind = MeshKind::regular;
  int half_rows = 0;  ///< n rows of the old density rule to either side of the middle
  double side = 0;    ///< of the triangles; of an unstructured mesh the longest
  MeshShape shape = MeshShape::equilateral;
  double angle_deg = 0;  ///< of the rows to the x axis
  MeshPlacement placement = MeshPlacement::free;
  std::optional<double> through_x;  ///< where a node of a regular mesh stands; else the placement decides
  std::optional<double> through_y;
  std::vector<RefinedPoint> refined;
  double error = 0;  ///< the share of the energy norm that stresses may be off by; 0: the mesh is as it is said
  int most_unknowns = 50000;  ///< of meshes that are refined until they reach it
  double tip_side = 0;        ///< at the tips of cracks; 0: as elsewhere
  TipFunctionPlan tip_functions = {};
  bool has_nodes_at_tips =
      false;              ///< whether or not tips have a side or functions: no key of a file, of meshes by error
  double snap_ratio = 0;  ///< nodes nearer to lines than this share of the mesh's scale are moved onto them
  std::vector<MeshedMaterial>
      materials;  ///< of the blocks that are given covers, the others stay blocks; none: all are
  Place place;
};

/// Force per length of the boundary along a chain: (x, y) - pressure n, n the normal out of the body.
struct TractionPlan {
  std::vector<Point> along;
  Formula x, y, pressure;
  Place place;
};

struct DisplacementPlan {
  std::vector<Point> along;
  Held held = Held::both;
  Formula x, y;
  Formula normal;  ///< outward; where `held` is normal
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

/// Tension positive. Across the plane, under plane strain: ν (xx + yy) where nothing is given.
struct StressPlan {
  Formula xx, yy, xy;
  std::optional<Formula> zz = {};
};

/// From load step `step` (the first is 1) on, what lies within the outline is gone.
struct ExcavationPlan {
  int step = 1;
  std::vector<Point> outline;
  Place place;
  int joint_material = 0;  ///< of the edges that it makes, index from 0
};

/// A crack, drawn in the undeformed bodies: both of its faces are of this joint material, index from 0. An end on a
/// boundary, a joint or another crack is no tip.
struct CrackPlan {
  std::vector<Point> along;
  Place place;
  int joint_material = 0;
  bool is_shear = false;  ///< it started in shear as cracks grew
};

/// In which direction a tip goes on.
enum class GrowthCriterion {
  hoop_stress,     ///< of the greatest hoop stress (Erdogan & Sih 1963)
  strain_energy,   ///< of the least strain energy density (Sih 1974)
  energy_release,  ///< of the greatest energy release rate (Amestoy & Leblond 1992)
};

/// Under which loads tips go on.
enum class GrowthLoads {
  automatic,  ///< scaled at rest where all bodies are on covers, else given
  scaled,     ///< in each load step those under which one tip reaches its toughness: all loads by one factor
  given,      ///< those of the file, in time or at rest: tips go on that have reached their toughness
};

/// Tips go on by `increment`.
struct GrowthPlan {
  GrowthCriterion criterion = GrowthCriterion::hoop_stress;
  GrowthLoads loads = GrowthLoads::automatic;
  double increment = 0;
  bool has_corrector =
      true;  ///< under scaled loads: the kink is the mean of those before and after a trial of the step
  Place place;
};

struct CoverPlan {
  std::optional<CoverFunctions> functions;  ///< none: `functions_of`
  CoverContact contact = CoverContact::felt;
  MeshPlan mesh;
  std::vector<TractionPlan> tractions;
  std::vector<DisplacementPlan> displacements;
  std::vector<ForcePlan> forces;
  std::vector<SpringPlan> springs;
  BodyForcePlan body_force;   ///< beside the weight of the materials
  StressPlan initial_stress;  ///< beside that of the materials
  std::vector<ExcavationPlan> excavations;
  std::vector<CrackPlan> cracks = {};
  std::optional<GrowthPlan> growth = {};
  Place place;
};

/// Those of the plan; where it names none, constant ones where rock may yield, for the others lock when it flows at
/// constant volume, else derived ones.
inline CoverFunctions functions_of(const CoverPlan& plan, const std::vector<BlockMaterial>& materials) {
  if (plan.functions) return *plan.functions;
  for (const BlockMaterial& material : materials)
    if (material.strength) return CoverFunctions::constant;
  return CoverFunctions::derived;
}

}  // namespace keyblock
