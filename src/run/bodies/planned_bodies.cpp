// One mesh for all load steps; see planned_bodies.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/bodies/planned_bodies.hpp"

#include <algorithm>
#include <stdexcept>

#include "cut/bodies/cracks.hpp"
#include "cut/bodies/excavate.hpp"
#include "cut/covers/cut_cover.hpp"
#include "cut/covers/join_manifolds.hpp"
#include "cut/mesh/fit_mesh.hpp"

namespace keyblock {
namespace {

constexpr const char* kNoBodies = "expected a drawing or blocks beside covers, found neither";

/// All bodies in one graph, only to lay the mesh over them: pieces may lie on one another.
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

// The last kink is one increment behind a tip, and its domain has to lie between them.
constexpr double kSidesOfIncrement = 16;

}  // namespace

double tip_side_of(const CoverPlan& plan) {
  if (plan.mesh.tip_side > 0 || !plan.growth) return plan.mesh.tip_side;
  return plan.growth->increment / kSidesOfIncrement;
}

bool bodies_touch(const Problem& problem) {
  if (!problem.covers->cracks.empty()) return true;
  if (const auto* blocks = std::get_if<Blocks>(&problem.geometry)) return blocks->blocks.size() > 1;
  const auto* drawing = std::get_if<Drawing>(&problem.geometry);
  if (drawing == nullptr) throw InputError(problem.covers->place, kNoBodies);
  const BodyGraph graph = cut_bodies(*drawing).graph;
  return graph.materials.size() > 1 || std::ranges::any_of(graph.pieces, &BodyPiece::is_slit);
}

PlannedBodies::PlannedBodies(const Problem& problem) : problem_(problem) {
  if (const auto* drawing = std::get_if<Drawing>(&problem.geometry)) {
    BodyCut cut = cut_bodies(*drawing);
    blocks_ = std::move(cut.blocks.blocks);
    warnings_ = std::move(cut.blocks.warnings);
    graphs_.push_back(std::move(cut.graph));
  } else if (const auto* blocks = std::get_if<Blocks>(&problem.geometry)) {
    for (const BlockPolygon& block : blocks->blocks) graphs_.push_back(graph_of(block));
    blocks_ = *blocks;
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
    mesh_ = fitted_mesh(plan, together(graphs_), tips).mesh;
  } catch (const std::invalid_argument& error) {
    const Place& mesh = problem.covers->mesh.place;
    throw InputError(mesh.line > 0 ? mesh : problem.covers->place, error.what());
  }
}

bool PlannedBodies::changes_at(int step) const {
  return std::ranges::any_of(problem_.covers->excavations, [&](const ExcavationPlan& e) { return e.step == step; });
}

Manifold PlannedBodies::at(int step) const {
  std::vector<Region> regions;
  for (const ExcavationPlan& excavation : problem_.covers->excavations)
    if (excavation.step <= step) regions.push_back({excavation.outline, excavation.joint_material});
  if (!regions.empty()) {
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
