// Uses one mesh for all load steps; see planned_bodies.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/bodies/planned_bodies.hpp"

#include <algorithm>
#include <stdexcept>

#include "cut/bodies/cracks.hpp"
#include "cut/bodies/excavate.hpp"
#include "cut/covers/cut_cover.hpp"
#include "cut/covers/from_cover.hpp"
#include "cut/covers/join_manifolds.hpp"
#include "cut/mesh/fit_mesh.hpp"

namespace keyblock {
namespace {

constexpr const char* kNoBodies = "expected a drawing, blocks or a cover file for covers, found none";

/// Merges all bodies into one graph, only to lay the mesh over them: pieces may overlap.
BodyGraph together(const std::vector<BodyGraph>& graphs) {
  BodyGraph all;
  for (const BodyGraph& graph : graphs) {
    const int first = static_cast<int>(all.nodes.size());
    all.nodes.insert(all.nodes.end(), graph.nodes.begin(), graph.nodes.end());
    for (BodyPiece piece : graph.pieces) {
      piece.from += first;
      piece.to += first;
      all.pieces.push_back(piece);
    }
  }
  return all;
}

void require_no_mesh(const MeshPlan& mesh, const Place& covers) {
  if (mesh.half_rows > 0 || mesh.side > 0 || mesh.kind != MeshKind::regular || !mesh.materials.empty())
    throw InputError(mesh.place.line > 0 ? mesh.place : covers,
                     "expected only tip_side, refined, error, tip_functions and snap_ratio of a mesh for a cover file, "
                     "which has its own, found another mesh");
}

/// Returns the points of a cover file by body.
Blocks points_by_bodies(const Cover& cover, const Manifold& manifold) {
  Blocks blocks;
  blocks.place = cover.place;
  const auto add = [&](const std::vector<CoverPoint>& from, std::vector<BlockPoint>& to) {
    for (const CoverPoint& point : from)
      to.push_back({point.position, manifold.elements[static_cast<std::size_t>(point.element)].body, point.place});
  };
  add(cover.fixed_points, blocks.fixed_points);
  add(cover.loading_points, blocks.loading_points);
  add(cover.measured_points, blocks.measured_points);
  return blocks;
}

// Sides per increment of growth: the last kink is one increment behind a tip, and the J domain must lie between them.
constexpr double kSidesOfIncrement = 16;

BodyGraph drawn_graph(const Problem& problem) {
  if (const auto* cover = std::get_if<Cover>(&problem.geometry)) return body_graph_of(manifold_of(*cover));
  const auto* drawing = std::get_if<Drawing>(&problem.geometry);
  if (drawing == nullptr) throw InputError(problem.covers->place, kNoBodies);
  return cut_bodies(*drawing).graph;
}

}  // namespace

double tip_side_of(const CoverPlan& plan) {
  if (plan.mesh.tip_side > 0 || !plan.growth) return plan.mesh.tip_side;
  return plan.growth->increment / kSidesOfIncrement;
}

bool bodies_touch(const Problem& problem) {
  if (!problem.covers->cracks.empty()) return true;
  if (const auto* blocks = std::get_if<Blocks>(&problem.geometry)) return blocks->blocks.size() > 1;
  const BodyGraph graph = drawn_graph(problem);
  return graph.materials.size() > 1 || std::ranges::any_of(graph.pieces, &BodyPiece::is_slit);
}

bool only_faces_touch(const Problem& problem) {
  if (const auto* blocks = std::get_if<Blocks>(&problem.geometry)) return blocks->blocks.size() == 1;
  return drawn_graph(problem).materials.size() == 1;
}

PlannedBodies::PlannedBodies(const Problem& problem) : problem_(problem) {
  std::optional<TriangleMesh> given;
  if (const auto* drawing = std::get_if<Drawing>(&problem.geometry)) {
    BodyCut cut = cut_bodies(*drawing);
    blocks_ = std::move(cut.blocks.blocks);
    warnings_ = std::move(cut.blocks.warnings);
    graphs_.push_back(std::move(cut.graph));
  } else if (const auto* blocks = std::get_if<Blocks>(&problem.geometry)) {
    for (const BlockPolygon& block : blocks->blocks) graphs_.push_back(graph_of(block));
    blocks_ = *blocks;
  } else if (const auto* cover = std::get_if<Cover>(&problem.geometry)) {
    require_no_mesh(problem.covers->mesh, problem.covers->place);
    Manifold manifold = manifold_of(*cover);
    blocks_ = points_by_bodies(*cover, manifold);
    graphs_.push_back(body_graph_of(manifold));
    given = std::move(manifold.mesh);
  } else {
    throw InputError(problem.covers->place, kNoBodies);
  }
  if (graphs_.empty()) throw InputError(problem.covers->place, "expected at least one body, found none");
  add_cracks(graphs_, problem.covers->cracks, CracksOutside::are_refused);
  std::vector<Point> tips;
  for (const BodyGraph& graph : graphs_)
    for (const CrackTip& tip : tips_of(graph)) tips.push_back(tip.at);
  try {
    MeshPlan plan = problem.covers->mesh;
    plan.tip_side = tip_side_of(*problem.covers);
    const BodyGraph all = together(graphs_);
    mesh_ = given ? refitted_mesh(std::move(*given), plan, all, tips).mesh : fitted_mesh(plan, all, tips).mesh;
  } catch (const std::invalid_argument& error) {
    const Place& mesh = problem.covers->mesh.place;
    throw InputError(mesh.line > 0 ? mesh : problem.covers->place, error.what());
  }
}

Manifold PlannedBodies::at(int step) const {
  try {
    return cut_at(step);
  } catch (const std::invalid_argument&) {
    if (!std::holds_alternative<Cover>(problem_.geometry)) throw;
    throw InputError(problem_.covers->place,
                     "expected a cover file whose triangles hold all of its bodies, found some outside them, as Shi's "
                     "cutter leaves small pieces: cut its drawing anew");
  }
}

Manifold PlannedBodies::cut_at(int step) const {
  std::vector<Region> regions;
  for (const ExcavationPlan& excavation : problem_.covers->excavations)
    if (excavation.step <= step) regions.push_back({excavation.outline, excavation.joint_material});
  if (!regions.empty()) {
    if (std::holds_alternative<Cover>(problem_.geometry))
      throw InputError(problem_.covers->excavations.front().place,
                       "expected excavations of a drawing or of blocks, found them of a cover file");
    const auto* blocks = std::get_if<Blocks>(&problem_.geometry);
    const Drawing drawing = blocks != nullptr ? lines_of(*blocks) : std::get<Drawing>(problem_.geometry);
    BodyGraph left = excavated(drawing, regions, NodeMerging::nearest_first, blocks);
    add_cracks({&left, 1}, problem_.covers->cracks, CracksOutside::are_gone);
    return cut_cover(left, mesh_, EmptyBodies::are_left_out);
  }
  Manifold all = cut_cover(graphs_.front(), mesh_);
  for (std::size_t g = 1; g < graphs_.size(); ++g) join(all, cut_cover(graphs_[g], mesh_));
  return all;
}

}  // namespace keyblock
