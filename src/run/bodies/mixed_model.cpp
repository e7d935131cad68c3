// Cuts blocks and bodies, joins them in one model, and assigns points to the elements that hold them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/bodies/mixed_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include "cut/bodies/block_shape.hpp"
#include "cut/bodies/cracks.hpp"
#include "cut/covers/mesh_blocks.hpp"
#include "cut/mesh/fit_mesh.hpp"
#include "model/continuum.hpp"
#include "model/setup/from_blocks.hpp"
#include "model/setup/from_manifold.hpp"
#include "model/setup/join.hpp"
#include "run/bodies/cover_plan_parts.hpp"
#include "run/bodies/planned_bodies.hpp"

namespace keyblock {
namespace {

/// Returns the joints whose middle lies in the body: their ends may reach into its neighbours.
std::vector<CrackPlan> inside(const BodyGraph& body, std::vector<CrackPlan> joints) {
  std::erase_if(joints, [&](const CrackPlan& joint) {
    return !is_in_a_body(body, 0.5 * (joint.along.front() + joint.along.back()));
  });
  return joints;
}

class Mixed {
 public:
  Mixed(const Blocks& blocks, const Analysis& analysis, const CoverPlan& plan, const Settings& settings,
        const std::vector<CrackPlan>& joints_inside)
      : blocks_(blocks), plan_(plan), parts_(meshed(joints_inside)) {
    const Blocks& rest = parts_.rest;
    if (parts_.manifold.elements.empty()) {
      model_ = model_from_blocks(rest, analysis);
    } else {
      Model bodies = model_from_manifold(parts_.manifold, {}, analysis);
      Continuum continuum = continuum_of(parts_.manifold, analysis.block_materials, settings,
                                         functions_of(plan, analysis.block_materials));
      put_loads(continuum, plan);
      put_points(continuum, plan);
      continuum.cracks = plan.cracks;
      bodies.continuum = std::make_shared<Continuum>(std::move(continuum));
      model_ = rest.blocks.empty() ? std::move(bodies) : joined(model_from_blocks(rest, analysis), bodies);
    }
    model_.fixed_points = carried(blocks.fixed_points, analysis.fixed_point_motions);
    model_.loading_points = carried(blocks.loading_points, analysis.point_loads);
    model_.measured_points = carried(blocks.measured_points, {});
    for (const BlockBolt& bolt : blocks.bolts)
      model_.bolts.push_back(bolt_between(bolt, holding(bolt.first_block, bolt.segment.start, "a bolt end", bolt.place),
                                          holding(bolt.second_block, bolt.segment.end, "a bolt end", bolt.place)));
    model_.identities.blocks = blocks_of_elements();
  }

  Model result() && { return std::move(model_); }

 private:
  MeshedBlocks meshed(const std::vector<CrackPlan>& joints_inside) const {
    const MeshPlan& mesh = plan_.mesh;
    const bool has_mesh = mesh.half_rows > 0 || mesh.side > 0;
    const auto is_meshed = [&](const BlockPolygon& block) {
      return has_mesh && (mesh.materials.empty() ||
                          std::ranges::count(mesh.materials, block.material, &MeshedMaterial::material) > 0);
    };
    try {
      const auto graph_for = [&](const BlockPolygon& block) {
        BodyGraph graph = graph_of(block);
        add_cracks({&graph, 1}, inside(graph, joints_inside), CracksOutside::are_gone);
        add_cracks({&graph, 1}, plan_.cracks, CracksOutside::are_gone);
        return graph;
      };
      return mesh_blocks(blocks_, is_meshed, graph_for, [&](const BlockPolygon& block, const BodyGraph& graph) {
        MeshPlan own = mesh;
        if (own.side > 0) own.side = std::min(own.side, std::sqrt(area_of(block)));
        own.tip_side = tip_side_of(plan_);
        std::vector<Point> tips;
        for (const CrackTip& tip : tips_of(graph)) tips.push_back(tip.at);
        return fitted_mesh(own, graph, tips).mesh;
      });
    } catch (const std::invalid_argument& error) {
      throw InputError(mesh.place, error.what());
    }
  }

  const Whereabouts& at(int block) const { return parts_.blocks[static_cast<std::size_t>(block)]; }

  /// Returns the element of the joined model at a position in a block as it was cut.
  ElementIndex holding(int block, Point position, const char* what, const Place& place) const {
    const Whereabouts& where = at(block);
    if (where.block >= 0) return {where.block};
    const auto blocks = static_cast<int>(parts_.rest.blocks.size());
    return {blocks + element_holding(parts_.manifold, where.body, position, what, place)};
  }

  std::vector<CarriedPoint> carried(const std::vector<BlockPoint>& points, const std::vector<TimeCurve>& curves) const {
    std::vector<CarriedPoint> result;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::string noun = fmt::format("a point of block {}", points[i].block + 1);
      const ElementIndex element = holding(points[i].block, points[i].position, noun.c_str(), points[i].place);
      result.push_back({points[i].position, element, i < curves.size() ? curves[i] : TimeCurve{}});
    }
    return result;
  }

  std::vector<int> blocks_of_elements() const {
    std::vector<int> of_elements(parts_.rest.blocks.size());
    std::vector<int> of_bodies(parts_.manifold.body_materials.size());
    for (std::size_t b = 0; b < parts_.blocks.size(); ++b) {
      const Whereabouts& where = parts_.blocks[b];
      auto& list = where.block >= 0 ? of_elements : of_bodies;
      list[static_cast<std::size_t>(std::max(where.block, where.body))] = static_cast<int>(b);
    }
    for (const ManifoldElement& element : parts_.manifold.elements)
      of_elements.push_back(of_bodies[static_cast<std::size_t>(element.body)]);
    return of_elements;
  }

  const Blocks& blocks_;
  const CoverPlan& plan_;
  MeshedBlocks parts_;
  Model model_;
};

}  // namespace

Model mixed_model(const Blocks& blocks, const Analysis& analysis, const CoverPlan& plan, const Settings& settings,
                  const std::vector<CrackPlan>& joints_inside) {
  return Mixed(blocks, analysis, plan, settings, joints_inside).result();
}

}  // namespace keyblock
