// Applies one change after another and records what each leaves of everything.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/stages/rock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <utility>

#include "base/error.hpp"
#include "base/sentences/sentences.hpp"
#include "cut/bodies/block_shape.hpp"
#include "cut/bodies/place_points.hpp"
#include "geometry/box.hpp"
#include "geometry/polygon.hpp"
#include "geometry/segment.hpp"
#include "material/strength.hpp"
#include "model/setup/from_blocks.hpp"

namespace keyblock {
namespace {

constexpr double kPointRoundOff = 1e-9;  // over the extent of the rock

std::vector<int> in_order(std::size_t count) {
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

template <class T>
std::vector<T> picked(const std::vector<T>& from, const std::vector<int>& indices) {
  std::vector<T> result;
  result.reserve(indices.size());
  for (const int i : indices) result.push_back(from[static_cast<std::size_t>(i)]);
  return result;
}

bool is_in(const std::vector<Point>& outline, Point p) {
  return side(outline, p) != Side::outside;
}

/// Returns the round-off of computed coordinates, by which a point on a face may lie outside.
double round_off_of(const std::vector<BlockPolygon>& blocks) {
  Box box;
  for (const BlockPolygon& block : blocks)
    for (const BlockVertex& vertex : block.outer) box.add(vertex.position);
  return kPointRoundOff * std::max(box.size().x, box.size().y);
}

class Changing {
 public:
  Changing(const Rock& rock, const Stage& stage) : stage_(stage), rock_(rock) {
    descent_ = {in_order(rock.blocks.blocks.size()), in_order(rock.blocks.fixed_points.size()),
                in_order(rock.blocks.bolts.size())};
  }

  ChangedRock run() && {
    excavate();
    if (!stage_.cuts.empty()) cut();
    assign_materials();
    remove_bolts();
    install_bolts();
    release();
    hold();
    load();
    look_at_mesh();
    return {std::move(rock_), std::move(descent_), std::move(warnings_)};
  }

 private:
  void require(int index, std::size_t count, const char* noun, const Place& place) const {
    if (index >= 0 && static_cast<std::size_t>(index) < count) return;
    throw InputError(place, fmt::format("expected a {} from 1 to {}, found {}", noun, count, index + 1LL));
  }

  void require_joint_material(int index, const Place& place) const {
    require(index, rock_.analysis.joint_materials.size(), "joint material", place);
  }

  int block_at(Point p, const char* what, const Place& place) const {
    const std::vector<BlockPolygon>& blocks = rock_.blocks.blocks;
    const auto found = std::ranges::find_if(blocks, [&](const BlockPolygon& block) { return holds(block, p); });
    if (found == blocks.end()) {
      if (const auto beside = block_beside(blocks, p, round_off_of(blocks))) return beside->block;
      throw InputError(place, fmt::format("expected {} in a block, found none at ({:.9g}, {:.9g})", what, p.x, p.y));
    }
    return static_cast<int>(found - blocks.begin());
  }

  void warn(const Place& place, const char* sentence) {
    warnings_.push_back({"stage_without_effect", place, sentence});
  }

  static void require_simple(const std::vector<Point>& outline, const Place& place) {
    const std::size_t count = outline.size();
    const auto side_at = [&](std::size_t i) { return Segment{outline[i], outline[(i + 1) % count]}; };
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = i + 1; j < count; ++j) {
        const bool is_next = j == i + 1 || (i == 0 && j + 1 == count);
        const Meeting met = meeting(side_at(i), side_at(j));
        if (is_next ? met == Meeting::overlapping : met != Meeting::none)
          throw InputError(place, fmt::format("expected an outline that does not cross or touch itself, found sides {} "
                                              "and {} that meet",
                                              i + 1, j + 1));
      }
  }

  double area() const {
    double sum = 0;
    for (const BlockPolygon& block : rock_.blocks.blocks) sum += area_of(block);
    return sum;
  }

  void excavate() {
    for (const StageExcavation& excavation : stage_.excavations) {
      require_joint_material(excavation.joint_material, excavation.place);
      require_simple(excavation.outline, excavation.place);
      const double before = area();
      take(without_regions(rock_.blocks, std::array{Region{excavation.outline, excavation.joint_material}}));
      if (rock_.blocks.blocks.empty())
        throw InputError(excavation.place, "expected a block that is not excavated, found none");
      if (!(area() < before)) warn(excavation.place, "nothing lies within the outline: nothing is excavated");
    }
  }

  void cut() {
    for (const JointLine& line : stage_.cuts) require_joint_material(line.joint_material, line.place);
    const std::size_t before = rock_.blocks.blocks.size();
    take(cut_along(rock_.blocks, stage_.cuts));
    if (rock_.blocks.blocks.size() == before)
      warn(stage_.cuts.front().place, "no line passes through a block from side to side: nothing is cut");
  }

  void take(ChangedBlocks changed) {
    rock_.blocks = std::move(changed.blocks);
    Identities& names = rock_.identities;
    names.measured_points = picked(names.measured_points, changed.measured_points);
    names.bolts = picked(names.bolts, changed.bolts);
    descent_.blocks = picked(descent_.blocks, changed.parents);
    descent_.bolts = picked(descent_.bolts, changed.bolts);
    keep_fixed(changed.fixed_points);
    rock_.analysis.point_loads = picked(rock_.analysis.point_loads, changed.loading_points);
  }

  /// Keeps the data of the remaining fixed points; the points themselves are in the blocks already.
  void keep_fixed(const std::vector<int>& kept) {
    descent_.fixed_points = picked(descent_.fixed_points, kept);
    rock_.holds_in_place = picked(rock_.holds_in_place, kept);
    rock_.analysis.fixed_point_motions = picked(rock_.analysis.fixed_point_motions, kept);
  }

  void assign_materials() {
    for (const StageMaterial& change : stage_.block_materials) {
      require(change.block_material, rock_.analysis.block_materials.size(), "block material", change.place);
      bool is_met = false;
      for (BlockPolygon& block : rock_.blocks.blocks) {
        if (!is_in(change.outline, centroid(points_of(block.outer)))) continue;
        keep_plastic_strain(block.material, change.block_material);
        block.material = change.block_material;
        is_met = true;
      }
      if (!is_met) warn(change.place, "no block has its centroid within the outline: no material changes");
    }
    for (const StageJointMaterial& change : stage_.joint_materials) {
      require_joint_material(change.from, change.place);
      require_joint_material(change.to, change.place);
      int edges = 0;
      for (BlockPolygon& block : rock_.blocks.blocks) {
        edges += replaced(block.outer, change);
        for (BlockLoop& hole : block.holes) edges += replaced(hole, change);
      }
      if (edges == 0) warn(change.place, "no edge is of this joint material: none changes");
    }
  }

  /// Rock that may have yielded must keep its plastic strain in a material without strength. That material gets an
  /// unreachable strength; otherwise a block would spring back to its shape before flow.
  void keep_plastic_strain(int from, int to) {
    std::vector<BlockMaterial>& materials = rock_.analysis.block_materials;
    BlockMaterial& after = materials[static_cast<std::size_t>(to)];
    if (materials[static_cast<std::size_t>(from)].strength && !after.strength)
      after.strength = std::make_shared<const Strength>(unreachable_strength());
  }

  /// Returns the number of edges of the loop that change.
  static int replaced(BlockLoop& loop, const StageJointMaterial& change) {
    int edges = 0;
    for (BlockVertex& vertex : loop) {
      if (vertex.joint_material != change.from) continue;
      vertex.joint_material = change.to;
      ++edges;
    }
    return edges;
  }

  void remove_bolts() {
    std::vector<int> kept = in_order(rock_.blocks.bolts.size());
    for (const StageBolt& removed : stage_.removed_bolts) {
      require(removed.bolt, static_cast<std::size_t>(rock_.next_bolt), "bolt", removed.place);
      const std::size_t erased = std::erase_if(
          kept, [&](int i) { return rock_.identities.bolts[static_cast<std::size_t>(i)] == removed.bolt; });
      if (erased == 0) warn(removed.place, "the bolt is gone already: none is removed");
    }
    if (kept.size() == rock_.blocks.bolts.size()) return;
    rock_.blocks.bolts = picked(rock_.blocks.bolts, kept);
    rock_.identities.bolts = picked(rock_.identities.bolts, kept);
    descent_.bolts = picked(descent_.bolts, kept);
  }

  void install_bolts() {
    std::size_t idle_bolts = 0;
    for (const BoltLine& line : stage_.bolts) {
      BlockBolt bolt{line.segment,
                     block_at(line.segment.start, "the start of a bolt", line.place),
                     block_at(line.segment.end, "the end of a bolt", line.place),
                     line.stiffness,
                     line.strength,
                     line.pretension,
                     line.place,
                     line.name};
      const std::vector<BoltProperties>& types = rock_.analysis.bolt_properties;
      const bool has_none = bolt.stiffness == 0 && bolt.strength == 0 && bolt.pretension == 0;
      if (has_none && types.empty()) ++idle_bolts;
      if (has_none && !types.empty()) {
        require(line.type, types.size(), "bolt type", line.place);
        const BoltProperties& type = types[static_cast<std::size_t>(line.type)];
        bolt.stiffness = type.stiffness;
        bolt.strength = type.strength;
        bolt.pretension = type.pretension;
      }
      if (bolt.segment.start == bolt.segment.end)
        throw InputError(line.place, "expected a bolt with a length, found none");
      if (!(bolt.stiffness >= 0))
        throw InputError(line.place,
                         fmt::format("expected a stiffness of at least 0 of a bolt, found {}", bolt.stiffness));
      rock_.blocks.bolts.push_back(std::move(bolt));
      rock_.identities.bolts.push_back(rock_.next_bolt++);
      descent_.bolts.push_back(-1);
    }
    if (idle_bolts == 0) return;
    warnings_.push_back(
        warning_of({"bolts_without_properties:of_stage", {{{"count", idle_bolts}}}}, stage_.bolts.front().place));
  }

  void release() {
    std::vector<int> kept;
    const std::vector<BlockPoint>& points = rock_.blocks.fixed_points;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (std::ranges::none_of(stage_.released,
                               [&](const StageRelease& r) { return is_in(r.outline, points[i].position); }))
        kept.push_back(static_cast<int>(i));
    if (kept.size() == points.size()) {
      if (!stage_.released.empty()) warn(stage_.released.front().place, "no fixed point lies within the outline");
      return;
    }
    keep_fixed(kept);
    rock_.blocks.fixed_points = picked(rock_.blocks.fixed_points, kept);
  }

  void hold() {
    for (const MarkedPoint& point : stage_.held) {
      rock_.blocks.fixed_points.push_back(
          {point.position, block_at(point.position, "a point of held_points", point.place), point.place});
      rock_.analysis.fixed_point_motions.emplace_back();
      rock_.holds_in_place.push_back(1);
      descent_.fixed_points.push_back(-1);
    }
  }

  void load() {
    if (stage_.removes_forces) {
      rock_.blocks.loading_points.clear();
      rock_.analysis.point_loads.clear();
    }
    for (const StageForce& force : stage_.forces) {
      rock_.blocks.loading_points.push_back({force.at, block_at(force.at, "a force", force.place), force.place});
      rock_.analysis.point_loads.push_back({{0}, {force.force}, force.place});
    }
  }

  void look_at_mesh() {
    if (!stage_.mesh || stage_.mesh->materials.empty()) return;
    const auto is_named = [&](const BlockPolygon& block) {
      return std::ranges::count(stage_.mesh->materials, block.material, &MeshedMaterial::material) > 0;
    };
    if (std::ranges::none_of(rock_.blocks.blocks, is_named))
      warn(stage_.mesh->place, "no block has a material that the mesh names: there are no NMM bodies from here on");
  }

  const Stage& stage_;
  Rock rock_;
  Descent descent_;
  Warnings warnings_;
};

}  // namespace

Rock rock_of(Blocks blocks, Analysis analysis) {
  Rock rock;
  analysis.fixed_point_motions.resize(blocks.fixed_points.size());
  analysis.point_loads.resize(blocks.loading_points.size());
  rock.identities.measured_points = in_order(blocks.measured_points.size());
  rock.identities.bolts = in_order(blocks.bolts.size());
  rock.holds_in_place.assign(blocks.fixed_points.size(), 0);
  rock.next_bolt = static_cast<int>(blocks.bolts.size());
  rock.blocks = std::move(blocks);
  rock.analysis = std::move(analysis);
  return rock;
}

ChangedRock changed(const Rock& rock, const Stage& stage) {
  return Changing(rock, stage).run();
}

Model model_of(const Rock& rock) {
  Model model = model_from_blocks(rock.blocks, rock.analysis);
  name_points(model, rock);
  return model;
}

void name_points(Model& model, const Rock& rock) {
  model.identities.measured_points = rock.identities.measured_points;
  model.identities.bolts = rock.identities.bolts;
  for (std::size_t i = 0; i < rock.holds_in_place.size(); ++i)
    model.fixed_points[i].holds_in_place = rock.holds_in_place[i] != 0;
}

}  // namespace keyblock
