// Takes excavations from the plan, as linear statics does, and everything else from the rock.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/stages/cover_stages.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "cut/bodies/place_points.hpp"
#include "geometry/polygon.hpp"
#include "model/continuum.hpp"
#include "model/setup/from_blocks.hpp"
#include "model/setup/from_manifold.hpp"
#include "run/bodies/cover_plan_parts.hpp"

namespace keyblock {
namespace {

Problem with_excavations(const Problem& problem) {
  const Place& place = problem.stages.front().place;
  if (!problem.covers) throw InputError(place, "expected stages of blocks or a drawing, found them of a cover file");
  if (!problem.covers->excavations.empty())
    throw InputError(problem.covers->excavations.front().place,
                     "expected excavations in stages or in covers, found both");
  Problem with = problem;
  for (std::size_t i = 0; i < problem.stages.size(); ++i) {
    const Stage& stage = problem.stages[i];
    if (!stage.cuts.empty())
      throw InputError(stage.cuts.front().place, "expected cuts of blocks, found them in stages of NMM bodies");
    for (const StageExcavation& excavation : stage.excavations)
      with.covers->excavations.push_back({static_cast<int>(i) + 1, excavation.outline, excavation.place, 0});
  }
  // A joint material of its own identifies the excavation that made an edge; see joint_material_at.
  const int count = static_cast<int>(problem.analysis->joint_materials.size());
  for (std::size_t e = 0; e < with.covers->excavations.size(); ++e)
    with.covers->excavations[e].joint_material = count + static_cast<int>(e);
  return with;
}

std::vector<CoverPoint> in_elements(const Manifold& manifold, const std::vector<BlockPoint>& points, const char* noun) {
  std::vector<CoverPoint> result;
  for (const BlockPoint& point : points)
    result.push_back({point.position, element_holding(manifold, -1, point.position, noun, point.place), point.place});
  return result;
}

/// Gives every body the material of its block in the rock.
void put_body_materials(Manifold& manifold, const Rock& rock) {
  std::vector<char> is_known(manifold.body_materials.size(), 0);
  for (const ManifoldElement& element : manifold.elements) {
    const auto body = static_cast<std::size_t>(element.body);
    if (is_known[body]) continue;
    const std::optional<Point> inside = point_inside(manifold.polygon(element));
    if (!inside) continue;
    for (const BlockPolygon& block : rock.blocks.blocks) {
      if (!holds(block, *inside)) continue;
      manifold.body_materials[body] = block.material;
      is_known[body] = 1;
      break;
    }
  }
}

bool is_within(const std::vector<std::vector<Point>>& loops, Point p) {
  int times = 0;
  for (const std::vector<Point>& loop : loops) times += side(loop, p) == Side::outside ? 0 : 1;
  return times == 1;
}

}  // namespace

CoverStages::CoverStages(const Problem& problem) : problem_(with_excavations(problem)), planned_(problem_) {
  for (const Stage& stage : problem.stages)
    for (const StageExcavation& excavation : stage.excavations) dug_materials_.push_back(excavation.joint_material);
}

Continuum CoverStages::continuum_at(Manifold manifold, const Rock& rock, int stage, const Settings& settings) const {
  const CoverPlan plan = what_is_left_of(acting_in(*problem_.covers, stage), manifold, rock.blocks);
  Continuum continuum = continuum_of(std::move(manifold), rock.analysis.block_materials, settings,
                                     functions_of(*problem_.covers, rock.analysis.block_materials));
  put_loads(continuum, plan);
  put_points(continuum, plan);
  continuum.cracks = plan.cracks;
  continuum.tip_functions = plan.mesh.tip_functions;
  return continuum;
}

// An edge made by an excavation is changed by that stage and later ones; an edge of the drawing by all stages.
int CoverStages::joint_material_at(int stage, int first) const {
  const int count = static_cast<int>(problem_.analysis->joint_materials.size());
  int from = 0;
  int material = first;
  if (first >= count) {
    from = problem_.covers->excavations[static_cast<std::size_t>(first - count)].step - 1;
    material = dug_materials_[static_cast<std::size_t>(first - count)];
  }
  for (int i = from; i <= stage; ++i)
    for (const StageJointMaterial& change : problem_.stages[static_cast<std::size_t>(i)].joint_materials)
      if (material == change.from) material = change.to;
  return material;
}

Model CoverStages::model(const Rock& rock, int stage, const Settings& settings) const {
  Manifold manifold = planned_.at(stage + 1);
  put_body_materials(manifold, rock);
  for (ElementCorner& corner : manifold.corners)
    if (corner.joint_material >= 0) corner.joint_material = joint_material_at(stage, corner.joint_material);
  const ElementPoints points{in_elements(manifold, rock.blocks.fixed_points, "a fixed point"),
                             in_elements(manifold, rock.blocks.loading_points, "a loading point"),
                             in_elements(manifold, rock.blocks.measured_points, "a measured point")};
  Model model = model_from_manifold(manifold, points, rock.analysis);
  for (const BlockBolt& bolt : rock.blocks.bolts) {
    const auto end = [&](Point p) { return ElementIndex{element_holding(manifold, -1, p, "a bolt end", bolt.place)}; };
    model.bolts.push_back(bolt_between(bolt, end(bolt.segment.start), end(bolt.segment.end)));
  }
  name_points(model, rock);
  model.continuum = std::make_shared<Continuum>(continuum_at(std::move(manifold), rock, stage, settings));
  return model;
}

Table<ElementIndex, ElementIndex> cover_parents(const Model& before, const Model& after) {
  const Manifold& was = before.continuum->manifold;
  const Manifold& is = after.continuum->manifold;
  std::vector<std::vector<int>> of_triangle(was.mesh.triangles.size());
  for (std::size_t e = 0; e < was.elements.size(); ++e)
    of_triangle[static_cast<std::size_t>(was.elements[e].triangle)].push_back(static_cast<int>(e));
  Table<ElementIndex, ElementIndex> parents;
  for (const ManifoldElement& element : is.elements) {
    const std::vector<int>& candidates = of_triangle[static_cast<std::size_t>(element.triangle)];
    const std::optional<Point> inside = point_inside(is.polygon(element));
    ElementIndex parent;
    for (const int candidate : candidates)
      if (inside && is_within(was.polygon(was.elements[static_cast<std::size_t>(candidate)]), *inside))
        parent = {candidate};
    if (!parent && !candidates.empty()) parent = {candidates.front()};  // a corner made by rounding
    if (!parent) throw std::logic_error("an element of a later stage lies outside the bodies of the stage before");
    parents.push_back(parent);
  }
  return parents;
}

}  // namespace keyblock
