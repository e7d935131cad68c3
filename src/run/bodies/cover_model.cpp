// Blocks and bodies cut apart, joined in one model, points handed to whoever carries them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/bodies/cover_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

#include "cut/covers/cut_cover.hpp"
#include "cut/covers/from_cover.hpp"
#include "cut/covers/mesh_blocks.hpp"
#include "cut/covers/to_cover.hpp"
#include "cut/mesh/fit_mesh.hpp"
#include "model/continuum.hpp"
#include "model/setup/from_blocks.hpp"
#include "model/setup/from_manifold.hpp"
#include "model/setup/join.hpp"
#include "run/bodies/cover_plan_parts.hpp"
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
  Continuum continuum =
      continuum_of(std::move(manifold), problem.analysis->block_materials, settings, problem.covers->functions);
  put_loads(continuum, *problem.covers);
  put_points(continuum, *problem.covers);
  return continuum;
}

// Some blocks on covers: joints that end inside them are pruned, as they are in blocks.
class Mixed {
 public:
  Mixed(const Problem& problem, const Settings& settings)
      : problem_(problem), cut_(blocks_of(problem, settings)), parts_(meshed()) {
    if (parts_.manifold.elements.empty())
      throw InputError(problem.covers->mesh.place, "expected a block of the materials that covers name, found none");
    const Analysis& analysis = *problem.analysis;
    const Blocks& rest = parts_.rest;
    Model bodies =
        with_continuum(model_from_manifold(parts_.manifold, {}, analysis), planned(parts_.manifold, problem, settings));
    model_ = rest.blocks.empty() ? std::move(bodies) : joined(model_from_blocks(rest, analysis), bodies);
    model_.fixed_points = carried(cut_.blocks.fixed_points, analysis.fixed_point_motions);
    model_.loading_points = carried(cut_.blocks.loading_points, analysis.point_loads);
    model_.measured_points = carried(cut_.blocks.measured_points, {});
    for (const BlockBolt& bolt : cut_.blocks.bolts)
      model_.bolts.push_back(bolt_between(bolt, holding(bolt.first_block, bolt.segment.start, "a bolt end", bolt.place),
                                          holding(bolt.second_block, bolt.segment.end, "a bolt end", bolt.place)));
  }

  CoverModel result() && { return {std::move(model_), std::move(cut_.warnings)}; }

 private:
  MeshedBlocks meshed() const {
    const std::vector<MeshedMaterial>& materials = problem_.covers->mesh.materials;
    const auto is_meshed = [&](const BlockPolygon& block) {
      return std::ranges::count(materials, block.material, &MeshedMaterial::material) > 0;
    };
    try {
      return mesh_blocks(cut_.blocks, is_meshed,
                         [&](const BodyGraph& graph) { return fitted_mesh(problem_.covers->mesh, graph).mesh; });
    } catch (const std::invalid_argument& error) {
      throw InputError(problem_.covers->mesh.place, error.what());
    }
  }

  const Whereabouts& at(int block) const { return parts_.blocks[static_cast<std::size_t>(block)]; }

  /// The element of the joined model at a place of a block as it was cut.
  ElementIndex holding(int block, Point position, const char* what, const Place& place) const {
    const Whereabouts& where = at(block);
    if (where.block >= 0) return {where.block};
    const auto blocks = static_cast<int>(parts_.rest.blocks.size());
    return {blocks + element_holding(parts_.manifold, where.body, position, what, place)};
  }

  std::vector<CarriedPoint> carried(const std::vector<BlockPoint>& points, const std::vector<TimeCurve>& curves) const {
    std::vector<CarriedPoint> result;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const ElementIndex element =
          holding(points[i].block, points[i].position, point_of(points[i].block).c_str(), points[i].place);
      result.push_back({points[i].position, element, i < curves.size() ? curves[i] : TimeCurve{}});
    }
    return result;
  }

  const Problem& problem_;
  CutResult cut_;
  MeshedBlocks parts_;
  Model model_;
};

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

}  // namespace

CutResult blocks_of(const Problem& problem, const Settings& settings) {
  if (const auto* drawing = std::get_if<Drawing>(&problem.geometry))
    return cut_blocks(*drawing, settings.node_merging, settings.near_pieces);
  return {std::get<Blocks>(problem.geometry), {}, {}, {}};
}

CoverModel cover_model(const Problem& problem, const Settings& settings) {
  if (const auto* cover = std::get_if<Cover>(&problem.geometry))
    return of_cover_file(*cover, *problem.analysis, settings);
  return problem.covers->mesh.materials.empty() ? all_on_covers(problem, settings) : Mixed(problem, settings).result();
}

}  // namespace keyblock
