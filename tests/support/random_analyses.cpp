// Draws materials, controls and curves.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/random_analyses.hpp"

#include "tests/support/random_values.hpp"

namespace keyblock::support::drawn {

using formats::Content;

namespace {

Stress any_stress(Dice& dice) {
  const double xx = any_real(dice), yy = any_real(dice);
  return {xx, yy, any_real(dice)};
}

Velocity any_velocity(Dice& dice) {
  const double x = any_real(dice), y = any_real(dice);
  return {x, y, any_real(dice)};
}

BlockMaterial block_material(Dice& dice) {
  BlockMaterial material;
  material.density = positive_real(dice);
  material.unit_weight = any_real(dice);
  material.youngs_modulus = positive_real(dice);
  material.poissons_ratio = dice.between(0, 0.49);
  material.initial_stress = any_stress(dice);
  material.initial_velocity = any_velocity(dice);
  return material;
}

JointMaterial joint_material(Dice& dice) {
  JointMaterial material;
  material.friction_angle_deg = dice.between(0, 89);
  material.cohesion = dice.happens(0.5) ? 0 : positive_real(dice);
  material.tensile_strength = dice.happens(0.5) ? 0 : positive_real(dice);
  return material;
}

Analysis controls(Dice& dice, AnalysisDialect dialect) {
  Analysis a;
  a.dialect = dialect;
  a.step_count = 1 + dice.below(100000);
  a.allowed_displacement_ratio = positive_real(dice);
  a.time_step = positive_real(dice);
  a.velocity_carry_over = dice.below(2);
  a.block_materials = some(dice, 3, block_material);
  a.block_materials.push_back(block_material(dice));
  a.joint_materials = some(dice, 3, joint_material);
  a.joint_materials.push_back(joint_material(dice));
  return a;
}

Analysis native_controls(Dice& dice, AnalysisDialect dialect) {
  Analysis a = controls(dice, dialect);
  a.velocity_carry_over = dice.happens(0.5) ? a.velocity_carry_over : dice.between(0, 1);
  a.automatic_time_step = true;
  a.automatic_penalty = true;
  for (BlockMaterial& material : a.block_materials) material.stress_gradient = any_stress(dice);
  return a;
}

}  // namespace

TimeCurve curve(Dice& dice) {
  TimeCurve rows;
  const int count = 2 + dice.below(4);
  double time = dice.between(-1, 1);
  for (int i = 0; i < count; ++i) {
    rows.times.push_back(time);
    rows.values.push_back(any_point(dice));
    time += dice.between(0.001, 3);
  }
  return rows;
}

TimeCurve curve_or_none(Dice& dice) {
  return dice.happens(0.5) ? TimeCurve{} : curve(dice);
}

Content berkeley_analysis(Dice& dice) {
  Content content;
  content.analysis = native_controls(dice, AnalysisDialect::berkeley);
  return content;
}

Content shi_analysis(Dice& dice) {
  Content content;
  Analysis& a = content.analysis.emplace(native_controls(dice, AnalysisDialect::shi));
  if (dice.happens(0.8)) a.contact_penalty = positive_real(dice);
  if (dice.happens(0.5)) a.over_relaxation = dice.between(1, 2);
  a.fixed_point_motions = some(dice, 4, curve_or_none);
  a.point_loads = some(dice, 3, curve_or_none);
  return content;
}

Content manifold_analysis(Dice& dice) {
  Content content;
  Analysis& a = content.analysis.emplace(native_controls(dice, AnalysisDialect::manifold));
  if (dice.happens(0.8)) a.contact_penalty = positive_real(dice);
  a.over_relaxation = dice.between(1, 2);
  for (BlockMaterial& material : a.block_materials) material.horizontal_force = any_real(dice);
  a.point_loads = some(dice, 3, [](Dice& one) { return TimeCurve{{0}, {any_point(one)}, {}}; });
  return content;
}

Analysis ddaml_controls(Dice& dice) {
  Analysis a = controls(dice, AnalysisDialect::ddaml);
  a.automatic_time_step = dice.happens(0.5);
  a.automatic_penalty = dice.happens(0.5);
  a.penalty_factor = positive_real(dice);
  a.plane_strain = dice.happens(0.5);
  a.rotation = dice.happens(0.5) ? Rotation::exact : Rotation::first_order;
  a.gravity = any_real(dice);
  a.open_close_limit = 1 + dice.below(20);
  a.contact_damping = dice.happens(0.5) ? 0 : positive_real(dice);
  if (dice.happens(0.5)) a.save_interval = 1 + dice.below(50);
  a.open_close = {positive_real(dice), positive_real(dice), positive_real(dice), positive_real(dice),
                  positive_real(dice)};
  for (BlockMaterial& material : a.block_materials) {
    material.damping = dice.happens(0.5) ? 0 : positive_real(dice);
    for (double& strain : material.initial_strain) strain = any_real(dice);
  }
  a.bolt_properties = some(dice, 3, [](Dice& one) {
    const double stiffness = positive_real(one), strength = any_real(one);
    return BoltProperties{stiffness, strength, any_real(one)};
  });
  a.point_loads = some(dice, 3, curve);
  return a;
}

}  // namespace keyblock::support::drawn
