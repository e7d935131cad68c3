// Builds the model from blocks, and its first state from the materials.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/from_blocks.hpp"

#include <limits>

#include "geometry/polygon.hpp"
#include "model/build.hpp"
#include "model/hanging.hpp"
#include "model/material_stress.hpp"

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
    bolts.push_back({{bolt.segment.start, {bolt.first_block}},
                     {bolt.segment.end, {bolt.second_block}},
                     bolt.stiffness,
                     strength_of(bolt),
                     bolt.pretension});
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

Stress berkeley_stress_gradient(const BlockMaterial& material, AnalysisDialect dialect) {
  const Velocity slots = berkeley_start_velocity(material, dialect);
  return {slots.x, slots.y, slots.rotation};
}

}  // namespace

Velocity berkeley_start_velocity(const BlockMaterial& material, AnalysisDialect dialect) {
  if (dialect == AnalysisDialect::ddaml) return material.initial_velocity;
  return {material.stress_gradient.xx, material.stress_gradient.yy, material.stress_gradient.xy};
}

Velocity berkeley_step_velocity(const BlockMaterial& material, AnalysisDialect dialect) {
  if (dialect != AnalysisDialect::ddaml) return material.initial_velocity;
  return {material.initial_strain[0], material.initial_strain[1], material.initial_strain[2]};
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

State start_state(const Model& model, AnalysisDialect dialect, const Settings& settings) {
  State state;
  state.vertices.assign(model.start_vertices.begin(), model.start_vertices.end());
  state.elements.reserve(model.elements.size());
  for (ElementIndex e : indices(model.elements)) {
    const Element& element = model.elements[e];
    const BlockMaterial& material = model.material_of(element);
    const auto [centroid, moments] = place(model, state.vertices, e, settings);
    const bool slots = settings.quirks.start_velocity_slots;
    const Velocity v = slots ? berkeley_start_velocity(material, dialect) : material.initial_velocity;
    const Stress gradient = slots ? berkeley_stress_gradient(material, dialect) : material.stress_gradient;
    Unknowns velocity = Unknowns::Zero(element.basis->unknown_count());
    velocity.head<3>() << v.x, v.y, v.rotation;
    state.elements.push_back({centroid, moments, velocity, Unknowns::Zero(element.basis->unknown_count()),
                              start_stress(material, gradient, centroid.y), 0});
  }
  state.nodes = start_nodes(model, state.elements);
  hang_velocities(model, state);
  for (const CarriedPoint& p : model.fixed_points) state.fixed_points.push_back({p.start, {}});
  for (const CarriedPoint& p : model.loading_points) state.loading_points.push_back({p.start, {}});
  for (const CarriedPoint& p : model.measured_points) state.measured_points.push_back({p.start, {}});
  for (const Bolt& bolt : model.bolts) state.bolts.push_back({bolt.first.start, bolt.second.start, bolt.pretension});
  return state;
}

}  // namespace keyblock
