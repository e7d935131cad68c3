// Blocks and bodies cut apart, joined in one model, points handed to whoever carries them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/bodies/cover_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

#include "cut/bodies/cracks.hpp"
#include "cut/bodies/treat_slivers.hpp"
#include "cut/covers/cut_cover.hpp"
#include "cut/covers/from_cover.hpp"
#include "cut/covers/to_cover.hpp"
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

// All bodies on one mesh, with the joints that end inside them.
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

void require_cracks_in_meshed_blocks(const Blocks& blocks, const CoverPlan& plan) {
  if (plan.cracks.empty()) return;
  std::vector<BodyGraph> graphs;
  for (const BlockPolygon& block : blocks.blocks)
    if (std::ranges::count(plan.mesh.materials, block.material, &MeshedMaterial::material) > 0)
      graphs.push_back(graph_of(block));
  add_cracks(graphs, plan.cracks, CracksOutside::are_refused);
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
  // Joints that end inside blocks are pruned, as they are in blocks.
  CutResult cut = blocks_of(problem, settings);
  require_cracks_in_meshed_blocks(cut.blocks, *problem.covers);
  Model model = mixed_model(cut.blocks, *problem.analysis, *problem.covers, settings);
  if (!model.continuum)
    throw InputError(problem.covers->mesh.place, "expected a block of the materials that covers name, found none");
  return {std::move(model), std::move(cut.warnings)};
}

}  // namespace keyblock
