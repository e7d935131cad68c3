// Makes the plan of each stage and finds elements in those of earlier stages.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/stages/mixed_stages.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "geometry/box.hpp"
#include "geometry/polygon.hpp"
#include "model/continuum.hpp"
#include "run/bodies/mixed_model.hpp"
#include "step/groups/carry_blocks.hpp"

namespace keyblock {
namespace {

bool has_mesh(const MeshPlan& mesh) {
  return mesh.half_rows > 0 || mesh.side > 0;
}

/// Elements of one block, searchable by position.
class ElementsOfBlock {
 public:
  void add(const Model& model, ElementIndex e) {
    Part& part = parts_.emplace_back(Part{e, {}, loops_of(model, e)});
    for (const std::vector<Point>& loop : part.loops)
      for (const Point& p : loop) part.box.add(p);
  }

  /// Returns the element that holds the point; the nearest if rounding leaves none.
  ElementIndex at(Point p) const {
    for (const Part& part : parts_)
      if (part.box.holds(p) && is_within(part.loops, p)) return part.element;
    return std::ranges::min_element(parts_, {}, [&](const Part& part) { return distance(part.box.middle(), p); })
        ->element;
  }

 private:
  struct Part {
    ElementIndex element;
    Box box;
    std::vector<std::vector<Point>> loops;
  };

  static bool is_within(const std::vector<std::vector<Point>>& loops, Point p) {
    return std::ranges::count_if(loops, [&](const auto& loop) { return side(loop, p) != Side::outside; }) == 1;
  }

  std::vector<Part> parts_;
};

}  // namespace

bool has_mixed_stages(const Problem& problem) {
  const auto gives_mesh = [](const Stage& stage) { return stage.mesh.has_value(); };
  if (problem.stages.empty()) return false;
  return (problem.covers && !problem.covers->mesh.materials.empty()) || std::ranges::any_of(problem.stages, gives_mesh);
}

MixedStages::MixedStages(const Problem& problem) {
  if (problem.covers)
    plan_ = *problem.covers;
  else
    add(plan_, problem.loads);
  if (!plan_.excavations.empty())
    throw InputError(plan_.excavations.front().place, "expected excavations in stages or in covers, found both");
  if (std::holds_alternative<Cover>(problem.geometry))
    throw InputError(problem.stages.front().place,
                     "expected stages of blocks or a drawing, found them of a cover file");
  const bool is_shared = has_mesh(plan_.mesh) && plan_.mesh.materials.empty();
  for (const Stage& stage : problem.stages) {
    if (stage.mesh && is_shared)
      throw InputError(stage.mesh->place,
                       "expected covers whose mesh names its materials before a stage that gives "
                       "another mesh, found one mesh that all bodies share");
    if (stage.mesh)
      meshes_.push_back(*stage.mesh);
    else
      meshes_.push_back(meshes_.empty() ? plan_.mesh : meshes_.back());
  }
}

Model MixedStages::model(const Rock& rock, int stage, const Settings& settings) const {
  CoverPlan plan = acting_in(plan_, stage);
  plan.mesh = meshes_[static_cast<std::size_t>(stage)];
  Model model = mixed_model(rock.blocks, rock.analysis, plan, settings);
  name_points(model, rock);
  return model;
}

Table<ElementIndex, ElementIndex> mixed_parents(const Model& before, const Model& after, const Descent& descent) {
  std::map<int, ElementsOfBlock> of_block;
  for (ElementIndex e : indices(before.elements))
    of_block[before.identities.blocks[static_cast<std::size_t>(e.value)]].add(before, e);
  Table<ElementIndex, ElementIndex> parents;
  for (ElementIndex e : indices(after.elements)) {
    const int block = after.identities.blocks[static_cast<std::size_t>(e.value)];
    const auto loops = loops_of(after, e);
    const std::optional<Point> inside = point_inside(loops);
    parents.push_back(
        of_block.at(descent.blocks[static_cast<std::size_t>(block)]).at(inside ? *inside : loops.front().front()));
  }
  return parents;
}

}  // namespace keyblock
