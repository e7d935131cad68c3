// Declares the keys of materials and of the analysis in a case file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/case_file/fields/field_demands.hpp"

namespace keyblock::formats {

template <class F>
void describe(F& f, In<F, Stress>& stress) {
  f.real("xx", stress.xx);
  f.real("yy", stress.yy);
  f.real("xy", stress.xy);
}

template <class F>
void describe(F& f, In<F, Velocity>& velocity) {
  f.real("x", velocity.x);
  f.real("y", velocity.y);
  f.real("rotation", velocity.rotation);
}

template <class F>
void describe(F& f, In<F, std::array<double, 3>>& strain) {
  f.real("xx", strain[0]);
  f.real("yy", strain[1]);
  f.real("xy", strain[2]);
}

template <class F>
void describe(F& f, In<F, StrengthValues>& values) {
  f.real("cohesion", values.cohesion, kNotNegative);
  f.real("friction_deg", values.friction_deg, kFrictionAngle);
  f.real("dilation_deg", values.dilation_deg, kFrictionAngle);
  f.real("yield_stress", values.yield_stress, kNotNegative);
  f.optional_real("tensile_strength", values.tensile_strength, kNotNegative);
}

template <class F>
void describe(F& f, In<F, StrengthChange>& change) {
  describe(f, change.values);
  f.real("plastic_strain", change.plastic_strain, kNotNegative);
  f.real("fracture_energy", change.fracture_energy, kNotNegative);
}

template <class F>
void describe(F& f, In<F, Strength>& strength) {
  f.word("surface", strength.surface, kYieldSurfaces);
  f.word("matching", strength.matching, kConeMatchings);
  describe(f, strength.values);
  // Values that it does not name stay unchanged.
  f.optional_object("after", strength.change, StrengthChange{.values = strength.values});
}

template <class F>
void describe(F& f, In<F, CrackClosure>& closure) {
  f.real("initial_modulus", closure.initial_modulus, kNotNegative);
  f.real("closure_strain", closure.closure_strain, kNotNegative);
}

template <class F>
void describe(F& f, In<F, Toughness>& toughness) {
  f.real("mode_1", toughness.mode_1, kPositive);
  f.optional_real("mode_2", toughness.mode_2, kPositive);
  f.optional_real("tensile_strength", toughness.tensile_strength, kPositive);
  f.optional_real("cohesion", toughness.cohesion, kPositive);
  f.real("friction_deg", toughness.friction_deg, kFrictionAngle);
}

template <class F>
void describe(F& f, In<F, BlockMaterial>& material) {
  f.name("name");
  f.of_library("like", material);
  f.real("density", material.density, kPositive);
  f.real("unit_weight", material.unit_weight);
  f.real("youngs_modulus", material.youngs_modulus, kPositive);
  f.real("poissons_ratio", material.poissons_ratio, kPoissonPlaneStress);
  f.real("damping", material.damping);
  f.real("horizontal_force", material.horizontal_force);
  f.row("initial_stress", material.initial_stress);
  f.row("stress_gradient", material.stress_gradient);
  f.row("initial_velocity", material.initial_velocity);
  f.row("initial_strain", material.initial_strain);
  std::optional<double> zz, gradient_zz;
  if (material.gives_zz) zz = material.initial_stress.zz;
  if (material.gives_zz) gradient_zz = material.stress_gradient.zz;
  f.optional_real("initial_stress_zz", zz, kAny);
  f.optional_real("stress_gradient_zz", gradient_zz, kAny);
  std::optional<Strength> strength;
  if (material.strength) strength = *material.strength;
  f.optional_object("strength", strength);
  std::optional<CrackClosure> crack_closure = material.crack_closure;
  f.optional_object("crack_closure", crack_closure);
  std::optional<Toughness> toughness = material.toughness;
  f.optional_object("toughness", toughness);
  if constexpr (!F::is_writing) {
    material.gives_zz = zz || gradient_zz;
    material.initial_stress.zz = zz.value_or(0);
    if (strength) material.strength = std::make_shared<const Strength>(*strength);
    material.crack_closure = crack_closure;
    material.toughness = toughness;
    material.stress_gradient.zz = gradient_zz.value_or(0);
  }
}

template <class F>
void describe(F& f, In<F, JointMaterial>& material) {
  f.name("name");
  f.of_library("like", material);
  f.real("friction_angle_deg", material.friction_angle_deg, kFrictionAngle);
  f.real("cohesion", material.cohesion, kNotNegative);
  f.real("tensile_strength", material.tensile_strength, kNotNegative);
}

template <class F>
void describe(F& f, In<F, BoltProperties>& bolt) {
  f.real("stiffness", bolt.stiffness);
  f.real("strength", bolt.strength);
  f.real("pretension", bolt.pretension);
}

template <class F>
void describe(F& f, In<F, OpenCloseConstants>& constants) {
  f.real("closing_ratio", constants.closing_ratio);
  f.real("opening_ratio", constants.opening_ratio);
  f.real("allowed_penetration", constants.allowed_penetration);
  f.real("angle_overlap_deg", constants.angle_overlap_deg);
  f.real("normal_to_shear_stiffness", constants.normal_to_shear_stiffness, kPositive);
}

template <class F>
void describe(F& f, In<F, Analysis>& analysis) {
  f.word("dialect", analysis.dialect, kDialects);
  f.real("velocity_carry_over", analysis.velocity_carry_over, kShare);
  f.integer("step_count", analysis.step_count, kStepCount);
  f.real("time_step", analysis.time_step, kPositive);
  f.real("allowed_displacement_ratio", analysis.allowed_displacement_ratio, kPositive);
  f.flag("automatic_time_step", analysis.automatic_time_step);
  f.flag("automatic_penalty", analysis.automatic_penalty);
  f.optional_real("contact_penalty", analysis.contact_penalty, kPositive);
  f.real("penalty_factor", analysis.penalty_factor, kNotNegative);
  f.flag("plane_strain", analysis.plane_strain);
  f.word("rotation", analysis.rotation, kRotations);
  f.optional_real("gravity", analysis.gravity, kAny);
  f.integer("open_close_limit", analysis.open_close_limit, kAtLeastOne);
  f.object("open_close", analysis.open_close);
  f.real("contact_damping", analysis.contact_damping);
  f.optional_real("over_relaxation", analysis.over_relaxation, kAny);
  f.optional_integer("save_interval", analysis.save_interval, kAtLeastOne);
  f.objects("block_materials", analysis.block_materials);
  f.objects("joint_materials", analysis.joint_materials);
  f.objects("bolt_properties", analysis.bolt_properties);
  f.curves("fixed_point_motions", analysis.fixed_point_motions);
  f.curves("point_loads", analysis.point_loads);
  f.curve("body_acceleration", analysis.body_acceleration);
}

}  // namespace keyblock::formats
