// Builds the model from blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/setup/from_blocks.hpp"

#include <limits>

#include "geometry/polygon.hpp"
#include "model/setup/build.hpp"

namespace keyblock {
namespace {

void add_block(Model& model, const BlockPolygon& block) {
  const int own_cover = model.elements.end_index().value;
  begin_element(model, block.material, affine_basis(), {own_cover});
  const auto add = [&](const BlockLoop& loop) {
    std::vector<Corner> corners;
    for (const BlockVertex& corner : loop) corners.push_back({corner.position, corner.joint_material});
    add_loop(model, corners);
  };
  add(block.outer);
  for (const BlockLoop& hole : block.holes) add(hole);
}

std::vector<CarriedPoint> carried(const std::vector<BlockPoint>& points, const std::vector<TimeCurve>& curves) {
  std::vector<CarriedPoint> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    result.push_back({points[i].position, {points[i].block}, i < curves.size() ? curves[i] : TimeCurve{}});
  return result;
}

double strength_of(const BlockBolt& bolt) {
  return bolt.strength > 0 ? bolt.strength : std::numeric_limits<double>::infinity();
}

std::vector<Bolt> bolts_of(const Blocks& blocks) {
  std::vector<Bolt> bolts;
  for (const BlockBolt& bolt : blocks.bolts)
    bolts.push_back(bolt_between(bolt, {bolt.first_block}, {bolt.second_block}));
  return bolts;
}

double mean_area_of(const Blocks& blocks) {
  double sum = 0;
  for (const BlockPolygon& block : blocks.blocks) {
    sum += area(points_of(block.outer));
    for (const BlockLoop& hole : block.holes) sum += area(points_of(hole));
  }
  return sum / static_cast<double>(blocks.blocks.size());
}

}  // namespace

Bolt bolt_between(const BlockBolt& bolt, ElementIndex first, ElementIndex second) {
  return {{bolt.segment.start, first}, {bolt.segment.end, second}, bolt.stiffness, strength_of(bolt), bolt.pretension,
          bolt.name.value_or({})};
}

Model model_from_blocks(const Blocks& blocks, const Analysis& analysis) {
  Model model;
  model.block_materials = analysis.block_materials;
  for (BlockMaterial& material : model.block_materials) material.horizontal_force = 0;
  model.joint_materials = analysis.joint_materials;
  for (const BlockPolygon& block : blocks.blocks) add_block(model, block);
  model.elements.shrink_to_fit();
  model.vertices.shrink_to_fit();
  model.start_vertices.shrink_to_fit();
  model.fixed_points = carried(blocks.fixed_points, analysis.fixed_point_motions);
  model.loading_points = carried(blocks.loading_points, analysis.point_loads);
  model.measured_points = carried(blocks.measured_points, {});
  model.bolts = bolts_of(blocks);
  model.scale = scale_of(model.start_vertices);
  model.mean_area = mean_area_of(blocks);
  return model;
}

}  // namespace keyblock
