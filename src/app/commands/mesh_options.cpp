// Declares the names of the choices; see mesh_options.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/mesh_options.hpp"

#include <map>
#include <stdexcept>
#include <string>

#include "app/option_checks.hpp"
#include "base/error.hpp"

namespace keyblock {

void add_mesh_options(CLI::App& app, MeshOptions& options) {
  auto* rows = app.add_option("--mesh", options.plan.half_rows,
                              "cut a regular triangular mesh of 2 N rows by the drawing into elements and physical "
                              "covers; joints that end inside a block cut too")
                   ->check(CLI::Range(1, kMostHalfRows));
  auto* side = app.add_option("--mesh-side", options.plan.side, "same with an unstructured mesh, longest side NUMBER")
                   ->check(above_zero())
                   ->excludes(rows);
  app.add_option("--mesh-refine", options.refined,
                 "X Y SIDE: longest side near the point (X, Y); sides grow with distance; may be repeated")
      ->type_size(3)
      ->needs(side);
  app.add_option("--mesh-shape", options.plan.shape,
                 "equilateral triangles, or old: 1.3 times as wide as high, as in Shi's manifold program")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, MeshShape>{{"equilateral", MeshShape::equilateral}, {"old", MeshShape::old}}))
      ->needs(rows);
  app.add_option("--mesh-angle", options.plan.angle_deg, "rotation of the regular mesh, degrees")
      ->check(CLI::Range(-180.0, 180.0))
      ->needs(rows);
  app.add_option(
         "--mesh-placement", options.plan.placement,
         "free: rows centred, 10 % beyond the larger extent, as in Shi's program; aligned: rows on the lower and "
         "upper edge (unstructured mesh: sides along all lines)")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, MeshPlacement>{{"free", MeshPlacement::free}, {"aligned", MeshPlacement::aligned}}));
  app.add_option("--mesh-snap", options.plan.snap_ratio,
                 "move mesh nodes onto lines nearer than this share of max(H/2, W/2.6); Shi's program: 0.0015 in most "
                 "samples")
      ->check(CLI::Range(0.0, 0.1));
}

bool is_asked_for(const MeshOptions& options) {
  if (options.plan.half_rows > 0 || options.plan.side != 0) return true;
  if (options.plan.placement != MeshPlacement::free || options.plan.snap_ratio > 0)
    throw UsageError("--mesh-placement and --mesh-snap require --mesh or --mesh-side");
  return false;
}

FittedMesh mesh_asked_for(const MeshOptions& options, const BodyGraph& graph) {
  MeshPlan plan = options.plan;
  plan.kind = plan.half_rows > 0 ? MeshKind::regular : MeshKind::unstructured;
  for (std::size_t k = 0; k + 2 < options.refined.size(); k += 3)
    plan.refined.push_back({{options.refined[k], options.refined[k + 1]}, options.refined[k + 2]});
  try {
    return fitted_mesh(plan, graph);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

}  // namespace keyblock
