// Names of the choices, and the mesh made of them; see mesh_options.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mesh_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "app/usage_error.hpp"
#include "cut/snap_nodes.hpp"

namespace keyblock {
namespace {

constexpr int kMostHalfRows = 1000;     // some four million triangles
constexpr double kMostTriangles = 4e6;  // of an unstructured mesh: minutes and gigabytes

Box box_of(const BodyGraph& graph) {
  Box box;
  for (const BodyPiece& piece : graph.pieces) {
    if (piece.left < 0 && piece.right < 0) continue;
    box.add(graph.nodes[static_cast<std::size_t>(piece.from)]);
    box.add(graph.nodes[static_cast<std::size_t>(piece.to)]);
  }
  return box;
}

TriangleMesh regular(const MeshOptions& options, const Box& box) {
  RegularMesh mesh = options.placement == MeshPlacement::aligned ? aligned_mesh(box, options.half_rows, options.shape)
                                                                 : centred_mesh(box, options.half_rows, options.shape);
  mesh.angle = options.angle_deg * std::acos(-1.0) / 180;
  return regular_triangles(box, mesh);
}

bool is_finite(double value) {
  return std::isfinite(value);
}

TriangleMesh unstructured(const MeshOptions& options, const BodyGraph& graph, const Box& box) {
  if (!std::isfinite(options.side) || !std::all_of(options.refined.begin(), options.refined.end(), is_finite))
    throw UsageError("--mesh-side, --mesh-refine: expected finite numbers");
  MeshSize size;
  size.side = options.side;
  for (std::size_t k = 0; k + 2 < options.refined.size(); k += 3)
    size.refined.push_back({{options.refined[k], options.refined[k + 1]}, options.refined[k + 2]});
  double triangles = box.size().x * box.size().y / (options.side * options.side);
  for (const RefinedPoint& point : size.refined) {
    if (!(point.side > 0))
      throw UsageError(fmt::format("--mesh-refine: expected a side above 0, found {}", point.side));
    triangles += std::log(std::max(1.0, options.side / point.side)) / (size.growth * size.growth);
  }
  if (triangles > kMostTriangles)
    throw UsageError(fmt::format("--mesh-side {}: some {:.0e} triangles, more than {:.0e}", options.side, triangles,
                                 kMostTriangles));
  std::vector<Segment> along;
  if (options.placement == MeshPlacement::aligned) {
    for (const BodyPiece& piece : graph.pieces)
      along.push_back(
          {graph.nodes[static_cast<std::size_t>(piece.from)], graph.nodes[static_cast<std::size_t>(piece.to)]});
  }
  return unstructured_mesh(box, size, along);
}

}  // namespace

void add_mesh_options(CLI::App& app, MeshOptions& options) {
  auto* rows = app.add_option("--mesh", options.half_rows,
                              "cut a regular triangular mesh with this half number of rows by the drawing, joints that "
                              "end inside included: elements and physical covers")
                   ->check(CLI::Range(1, kMostHalfRows));
  auto* side =
      app.add_option("--mesh-side", options.side, "the same with an unstructured mesh of sides no longer than this")
          ->check(CLI::PositiveNumber)
          ->excludes(rows);
  app.add_option("--mesh-refine", options.refined,
                 "X Y SIDE: near this point sides no longer than this, growing with the distance; may be repeated")
      ->type_size(3)
      ->needs(side);
  app.add_option("--mesh-shape", options.shape,
                 "equilateral triangles, or those of the old manifold cutter (old: 1.3 times as wide as high)")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, MeshShape>{{"equilateral", MeshShape::equilateral}, {"old", MeshShape::old}}))
      ->needs(rows);
  app.add_option("--mesh-angle", options.angle_deg, "degrees by which the regular mesh is turned")
      ->check(CLI::Range(-180.0, 180.0))
      ->needs(rows);
  app.add_option(
         "--mesh-placement", options.placement,
         "free: rows about the middle and 10 % beyond the greater extent, the old density rule; aligned: rows on "
         "the lower and the upper edge, of an unstructured mesh sides along all lines")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, MeshPlacement>{{"free", MeshPlacement::free}, {"aligned", MeshPlacement::aligned}}));
  app.add_option(
         "--mesh-snap", options.snap_ratio,
         "move mesh nodes onto lines nearer than this ratio of max(H/2, W/2.6), as the old manifold cutter does: "
         "0.0015 in most of its samples")
      ->check(CLI::Range(0.0, 0.1));
}

bool is_asked_for(const MeshOptions& options) {
  if (options.half_rows > 0 || options.side != 0) return true;
  if (options.placement != MeshPlacement::free || options.snap_ratio > 0)
    throw UsageError("--mesh-placement and --mesh-snap require --mesh or --mesh-side");
  return false;
}

FittedMesh fitted_mesh(const MeshOptions& options, const BodyGraph& graph) {
  const Box box = box_of(graph);
  FittedMesh fitted;
  fitted.mesh = options.half_rows > 0 ? regular(options, box) : unstructured(options, graph, box);
  if (options.snap_ratio > 0) fitted.snapped = snap_nodes(fitted.mesh, graph, options.snap_ratio * mesh_scale(box));
  return fitted;
}

}  // namespace keyblock
