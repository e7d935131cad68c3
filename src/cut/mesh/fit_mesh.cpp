// Turns plans into meshes; see fit_mesh.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/mesh/fit_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "cut/mesh/bisect_mesh.hpp"
#include "cut/mesh/snap_nodes.hpp"

namespace keyblock {
namespace {

constexpr double kLeastSide = 1e-12;  // per farthest coordinate: some thousand units of its last digit
constexpr double kMostSidesAway = 1e6;

void require_fewer(double triangles, double side) {
  if (!(triangles <= kMostTriangles))
    throw std::invalid_argument(
        fmt::format("a mesh of sides of {}: some {:.0e} triangles, more than {:.0e}", side, triangles, kMostTriangles));
}

/// Rows that are counted from a node farther away than this lose their places to round-off.
void require_near(const char* key, const std::optional<double>& value, double low, double high, double side) {
  const double reach = kMostSidesAway * side;
  if (!value || (*value >= low - reach && *value <= high + reach)) return;
  throw std::invalid_argument(
      fmt::format("expected {} of the mesh within {:g} sides of the bodies, {:g} to {:g}, found {:g}", key,
                  kMostSidesAway, low - reach, high + reach, *value));
}

TriangleMesh regular(const MeshPlan& plan, const Box& box) {
  const bool is_aligned = plan.placement == MeshPlacement::aligned;
  const int rows = std::max(plan.half_rows, 1);
  if (plan.half_rows <= 0 && !(plan.side > 0))
    throw std::invalid_argument(
        "expected half_rows or side of the mesh, which a drawing or blocks need, found neither");
  RegularMesh mesh = is_aligned ? aligned_mesh(box, rows, plan.shape) : centred_mesh(box, rows, plan.shape);
  if (plan.half_rows == 0) {
    const double high = mesh.dy / mesh.dx;
    mesh.dx = plan.side;
    mesh.dy = plan.side * high;
    if (!is_aligned) mesh.through = box.middle();
    require_fewer(4 * (box.size().x / mesh.dx + 2) * (box.size().y / mesh.dy + 2), plan.side);
  }
  require_near("through_x", plan.through_x, box.low.x, box.high.x, mesh.dx);
  require_near("through_y", plan.through_y, box.low.y, box.high.y, mesh.dy);
  mesh.through = {plan.through_x.value_or(mesh.through.x), plan.through_y.value_or(mesh.through.y)};
  mesh.angle = plan.angle_deg * std::numbers::pi / 180;
  return regular_triangles(box, mesh);
}

void require_length(double length, const char* what) {
  if (!(length > 0) || !std::isfinite(length))
    throw std::invalid_argument(fmt::format("{}: expected a finite length above 0, found {}", what, length));
}

/// Corners of shorter sides would coincide by rounding, and refinement would not end.
void require_resolved(double side, const Box& box, const char* what) {
  const double least = least_side(box);
  if (side < least)
    throw std::invalid_argument(
        fmt::format("expected {} of at least {:.3g}, which coordinates still resolve, found {}", what, least, side));
}

/// Returns the refined points of the plan, and the tips.
std::vector<RefinedPoint> refined_points(const MeshPlan& plan, const Box& box, std::span<const Point> tips) {
  std::vector<RefinedPoint> points = plan.refined;
  if (plan.tip_side > 0)
    for (const Point tip : tips) points.push_back({tip, plan.tip_side});
  for (const RefinedPoint& point : points) {
    require_length(point.side, "the side at a refined point of the mesh");
    require_resolved(point.side, box, "the side at a refined point of the mesh");
    if (!std::isfinite(point.at.x) || !std::isfinite(point.at.y))
      throw std::invalid_argument("a refined point of the mesh: expected finite coordinates");
  }
  return points;
}

Point direction_of_rows(const MeshPlan& plan) {
  const double angle = plan.angle_deg * std::numbers::pi / 180;
  return {std::cos(angle), std::sin(angle)};
}

TriangleMesh bisected(TriangleMesh mesh, const MeshPlan& plan, std::vector<RefinedPoint> refined) {
  if (refined.empty()) return mesh;
  bisect(mesh, {std::numeric_limits<double>::infinity(), std::move(refined), kMeshGrowth}, direction_of_rows(plan));
  return mesh;
}

/// Estimates the number of triangles of the required sizes in a box. It counts cells that are no wider than two sides
/// at their middle, up to `kMostTriangles`.
double triangles_in(const Box& box, const MeshSize& size) {
  std::vector<Box> cells{box};
  double count = 0;
  while (!cells.empty() && count <= kMostTriangles) {
    const Box cell = cells.back();
    cells.pop_back();
    const Point middle = cell.middle(), extent = cell.size();
    const double side = size.at(middle);
    if (std::max(extent.x, extent.y) <= 2 * side) {
      count += 2 * extent.x * extent.y / (side * side);
      continue;
    }
    const Point half = 0.5 * extent;
    for (const Point low : {cell.low, Point{middle.x, cell.low.y}, Point{cell.low.x, middle.y}, middle})
      cells.push_back({low, low + half});
  }
  return count;
}

TriangleMesh unstructured(const MeshPlan& plan, const BodyGraph& graph, const Box& box, std::span<const Point> tips) {
  require_length(plan.side, "the side of the mesh");
  require_resolved(plan.side, box, "the side of the mesh");
  const MeshSize size(plan.side, refined_points(plan, box, tips), kUnstructuredGrowth);
  require_fewer((box.size().x / plan.side + 1) * (box.size().y / plan.side + 1), plan.side);
  require_fewer(triangles_in(box, size), size.least());
  std::vector<Segment> along;
  if (plan.placement == MeshPlacement::aligned) {
    for (const BodyPiece& piece : graph.pieces)
      along.push_back(
          {graph.nodes[static_cast<std::size_t>(piece.from)], graph.nodes[static_cast<std::size_t>(piece.to)]});
  }
  return unstructured_mesh(box, size, along);
}

FittedMesh with_nodes_at_lines(TriangleMesh mesh, const MeshPlan& plan, const BodyGraph& graph,
                               std::span<const Point> tips) {
  FittedMesh fitted{std::move(mesh)};
  if (plan.snap_ratio > 0) fitted.snapped = snap_nodes(fitted.mesh, graph, plan.snap_ratio * mesh_scale(box_of(graph)));
  // Without tip settings meshes stay as they are.
  if (plan.has_nodes_at_tips || plan.tip_side > 0 || plan.tip_functions.are_asked()) place_nodes(fitted.mesh, tips);
  // Sides grow from a tip on, and a node that moved has lengthened its sides.
  if (plan.tip_side > 0) bisect_at(fitted.mesh, tips, plan.tip_side, direction_of_rows(plan));
  return fitted;
}

}  // namespace

double least_side(const Box& box) {
  return kLeastSide * std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
}

Box box_of(const BodyGraph& graph) {
  Box box;
  for (const BodyPiece& piece : graph.pieces) {
    if (piece.left < 0 && piece.right < 0) continue;
    box.add(graph.nodes[static_cast<std::size_t>(piece.from)]);
    box.add(graph.nodes[static_cast<std::size_t>(piece.to)]);
  }
  return box;
}

FittedMesh fitted_mesh(const MeshPlan& plan, const BodyGraph& graph, std::span<const Point> tips) {
  const Box box = box_of(graph);
  if (plan.kind == MeshKind::regular) return refitted_mesh(regular(plan, box), plan, graph, tips);
  return with_nodes_at_lines(unstructured(plan, graph, box, tips), plan, graph, tips);
}

FittedMesh refitted_mesh(TriangleMesh mesh, const MeshPlan& plan, const BodyGraph& graph, std::span<const Point> tips) {
  mesh = bisected(std::move(mesh), plan, refined_points(plan, box_of(graph), tips));
  return with_nodes_at_lines(std::move(mesh), plan, graph, tips);
}

}  // namespace keyblock
