// Cuts blocks and bodies, joins them in one model, and assigns points to the elements that hold them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/bodies/cover_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

#include "base/sentences/sentences.hpp"
#include "cut/bodies/cracks.hpp"
#include "cut/bodies/place_points.hpp"
#include "cut/bodies/treat_slivers.hpp"
#include "cut/covers/cut_cover.hpp"
#include "cut/covers/from_cover.hpp"
#include "cut/covers/to_cover.hpp"
#include "geometry/segment.hpp"
#include "model/continuum.hpp"
#include "model/setup/from_blocks.hpp"
#include "model/setup/from_manifold.hpp"
#include "run/bodies/cover_plan_parts.hpp"
#include "run/bodies/linear_case.hpp"
#include "run/bodies/mixed_model.hpp"
#include "run/bodies/planned_bodies.hpp"

namespace keyblock {
namespace {

Model with_continuum(Model model, Continuum continuum) {
  model.continuum = std::make_shared<Continuum>(std::move(continuum));
  return model;
}

std::string point_of(int block) {
  return fmt::format("a point of block {}", block + 1);
}

Continuum planned(Manifold manifold, const Problem& problem, const Settings& settings) {
  Continuum continuum = continuum_of(std::move(manifold), problem.analysis->block_materials, settings,
                                     functions_of(*problem.covers, problem.analysis->block_materials));
  put_loads(continuum, *problem.covers);
  put_points(continuum, *problem.covers);
  continuum.cracks = problem.covers->cracks;
  continuum.tip_functions = problem.covers->mesh.tip_functions;
  continuum.faces_touch = faces_touch(problem);
  return continuum;
}

// Puts all bodies on one mesh, with the joints that end inside them.
CoverModel all_on_covers(const Problem& problem, const Settings& settings) {
  const PlannedBodies bodies(problem);
  const Manifold manifold = bodies.at(0);
  for (const std::vector<BlockPoint>* points :
       {&bodies.blocks().fixed_points, &bodies.blocks().loading_points, &bodies.blocks().measured_points})
    for (const BlockPoint& point : *points)
      element_holding(manifold, point.block, point.position, point_of(point.block).c_str(), point.place);
  Model model = model_from_manifold(manifold, points_in_elements(manifold, bodies.blocks()), *problem.analysis);
  for (const BlockBolt& bolt : bodies.blocks().bolts) {
    const auto holding = [&](int body, Point end) {
      return ElementIndex{element_holding(manifold, body, end, "a bolt end", bolt.place)};
    };
    model.bolts.push_back(bolt_between(bolt, holding(bolt.first_block, bolt.segment.start),
                                       holding(bolt.second_block, bolt.segment.end)));
  }
  return {with_continuum(std::move(model), planned(manifold, problem, settings)), bodies.warnings()};
}

CoverModel of_cover_file(const Cover& cover, const Analysis& analysis, const Settings& settings) {
  const Manifold manifold = manifold_of(cover);
  for (std::size_t c = 0; c < manifold.covers.size(); ++c)
    if (manifold.covers[c].elements.size == 0)
      throw InputError(cover.place,
                       fmt::format("expected an element on every physical cover, found none on {}", c + 1));
  return {with_continuum(model_from_manifold(manifold, points_of(cover), analysis),
                         continuum_of(manifold, analysis.block_materials, settings, settings.standard.cover_functions)),
          {}};
}

std::vector<BodyGraph> graphs_of_meshed_blocks(const Blocks& blocks, const CoverPlan& plan) {
  std::vector<BodyGraph> graphs;
  for (const BlockPolygon& block : blocks.blocks)
    if (std::ranges::count(plan.mesh.materials, block.material, &MeshedMaterial::material) > 0)
      graphs.push_back(graph_of(block));
  return graphs;
}

/// Cuts the drawing, with joints that end inside bodies, or returns the given blocks.
BodyCut bodies_of(const Problem& problem, const Settings& settings) {
  const auto* drawing = std::get_if<Drawing>(&problem.geometry);
  BodyCut cut = drawing != nullptr ? cut_bodies(*drawing, settings.node_merging, settings.near_pieces)
                                   : BodyCut{{std::get<Blocks>(problem.geometry), {}, {}, {}}, {}};
  cut.blocks = with_slivers_treated(std::move(cut.blocks), settings.slivers);
  return cut;
}

// Tolerances relative to the scale of cutting. Vertices left out as straight lie up to 1e-6 off the edges of their
// block, and so does a joint that began there. It is extended beyond by ten times as much.
constexpr double kOnOutline = 1e-6;
constexpr double kBeyondOutline = 1e-5;

bool is_on_outline(const BodyGraph& body, Point p, double near) {
  return std::ranges::any_of(body.pieces, [&](const BodyPiece& piece) {
    const Segment side{body.nodes[static_cast<std::size_t>(piece.from)],
                       body.nodes[static_cast<std::size_t>(piece.to)]};
    return distance(side, p) <= near;
  });
}

Warnings joints_removed(std::size_t pieces, const Place& place) {
  if (pieces == 0) return {};
  Facts facts{{{"count", pieces}}, {{"are", pieces == 1 ? "is" : "are"}}};
  return {warning_of({"dangling_lines_removed:of_joints", std::move(facts)}, place)};
}

/// Turns joints that end inside blocks into cracks of NMM bodies; DDA blocks ignore them. Ends on an edge of the block
/// are extended slightly beyond it.
std::vector<CrackPlan> joints_inside(const BodyCut& cut, const std::vector<BodyGraph>& meshed, Warnings& warnings) {
  const BodyGraph& graph = cut.graph;
  const Blocks& blocks = cut.blocks.blocks;
  const double scale = cut.blocks.report.tolerances.scale;
  const auto end = [&](Point at, Point other, const BodyGraph& body) {
    const bool is_corner = std::ranges::find(body.nodes, at) != body.nodes.end();
    if (is_corner || !is_on_outline(body, at, kOnOutline * scale)) return at;
    return at + (kBeyondOutline * scale / distance(other, at)) * (at - other);
  };
  std::vector<CrackPlan> joints;
  std::size_t lost = 0;
  for (const BodyPiece& piece : graph.pieces) {
    if (!piece.is_slit) continue;
    const Point from = graph.nodes[static_cast<std::size_t>(piece.from)];
    const Point to = graph.nodes[static_cast<std::size_t>(piece.to)];
    const Point middle = 0.5 * (from + to);
    const auto holder = std::ranges::find_if(meshed, [&](const BodyGraph& body) { return is_in_a_body(body, middle); });
    if (holder != meshed.end())
      joints.push_back({{end(from, to, *holder), end(to, from, *holder)}, blocks.place, piece.joint_material});
    else if (block_at(blocks.blocks, middle, 0))
      ++lost;
  }
  warnings = joined(std::move(warnings), joints_removed(lost, blocks.place));
  return joints;
}

}  // namespace

CutResult blocks_of(const Problem& problem, const Settings& settings) {
  const auto* drawing = std::get_if<Drawing>(&problem.geometry);
  CutResult cut = drawing != nullptr ? cut_blocks(*drawing, settings.node_merging, settings.near_pieces)
                                     : CutResult{std::get<Blocks>(problem.geometry), {}, {}, {}};
  return with_slivers_treated(std::move(cut), settings.slivers);
}

CoverModel cover_model(const Problem& problem, const Settings& settings) {
  if (const auto* cover = std::get_if<Cover>(&problem.geometry))
    return problem.covers ? all_on_covers(problem, settings) : of_cover_file(*cover, *problem.analysis, settings);
  if (problem.covers->mesh.materials.empty()) return all_on_covers(problem, settings);
  BodyCut cut = bodies_of(problem, settings);
  Warnings warnings = std::move(cut.blocks.warnings);
  std::vector<BodyGraph> meshed = graphs_of_meshed_blocks(cut.blocks.blocks, *problem.covers);
  const std::vector<CrackPlan> joints = joints_inside(cut, meshed, warnings);
  add_cracks(meshed, problem.covers->cracks, CracksOutside::are_refused);
  Model model = mixed_model(cut.blocks.blocks, *problem.analysis, *problem.covers, settings, joints);
  if (!model.continuum)
    throw InputError(problem.covers->mesh.place, "expected a block of the materials that covers name, found none");
  return {std::move(model), std::move(warnings)};
}

}  // namespace keyblock
