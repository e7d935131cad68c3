// Declares the table of quantities: a key, with the key above it if the quantity depends on it. A number of the schema
// without a row here fails a test.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/case_measures.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace keyblock::formats {
namespace {

struct FieldMeasure {
  std::string_view key;
  Measure measure;
};

constexpr auto kFields = std::to_array<FieldMeasure>({
    {"x", measures::kLength},
    {"y", measures::kLength},
    {"x1", measures::kLength},
    {"y1", measures::kLength},
    {"x2", measures::kLength},
    {"y2", measures::kLength},
    {"edge_node_ratio", measures::kNumber},
    {"join", measures::kLength},
    {"stiffness", measures::kStiffness},
    {"strength", measures::kForce},
    {"pretension", measures::kForce},

    {"side", measures::kLength},
    {"tip_side", measures::kLength},
    {"tip_radius", measures::kLength},
    {"through_x", measures::kLength},
    {"through_y", measures::kLength},
    {"angle", measures::kDegrees},
    {"error", measures::kNumber},
    {"snap_ratio", measures::kNumber},
    {"tractions.x", measures::kStress},
    {"tractions.y", measures::kStress},
    {"pressure", measures::kStress},
    {"normal", measures::kLength},
    {"factor", measures::kNumber},
    {"force_x", measures::kForce},
    {"force_y", measures::kForce},
    {"direction_x", measures::kNumber},
    {"direction_y", measures::kNumber},
    {"body_force.x", measures::kForcePerVolume},
    {"body_force.y", measures::kForcePerVolume},
    {"initial_stress_field.xx", measures::kStress},
    {"initial_stress_field.yy", measures::kStress},
    {"initial_stress_field.xy", measures::kStress},
    {"initial_stress_field.zz", measures::kStress},
    {"increment", measures::kLength},

    {"velocity_carry_over", measures::kNumber},
    {"time_step", measures::kTime},
    {"allowed_displacement_ratio", measures::kNumber},
    {"contact_penalty", measures::kStiffness},
    {"penalty_factor", measures::kNumber},
    {"gravity", measures::kAcceleration},
    {"closing_ratio", measures::kNumber},
    {"opening_ratio", measures::kNumber},
    {"allowed_penetration", measures::kNumber},
    {"angle_overlap_deg", measures::kDegrees},
    {"normal_to_shear_stiffness", measures::kNumber},
    {"contact_damping", measures::kNumber},
    {"over_relaxation", measures::kNumber},
    {"density", measures::kDensity},
    {"unit_weight", measures::kForcePerVolume},
    {"youngs_modulus", measures::kStress},
    {"poissons_ratio", measures::kNumber},
    {"damping", measures::kNumber},
    {"horizontal_force", measures::kForcePerVolume},
    {"initial_stress.xx", measures::kStress},
    {"initial_stress.yy", measures::kStress},
    {"initial_stress.xy", measures::kStress},
    {"stress_gradient.xx", measures::kForcePerVolume},
    {"stress_gradient.yy", measures::kForcePerVolume},
    {"stress_gradient.xy", measures::kForcePerVolume},
    {"initial_velocity.x", measures::kVelocity},
    {"initial_velocity.y", measures::kVelocity},
    {"initial_velocity.rotation", measures::kRotationRate},
    {"initial_strain.xx", measures::kNumber},
    {"initial_strain.yy", measures::kNumber},
    {"initial_strain.xy", measures::kNumber},
    {"initial_stress_zz", measures::kStress},
    {"stress_gradient_zz", measures::kForcePerVolume},
    {"cohesion", measures::kStress},
    {"friction_deg", measures::kDegrees},
    {"dilation_deg", measures::kDegrees},
    {"yield_stress", measures::kStress},
    {"tensile_strength", measures::kStress},
    {"plastic_strain", measures::kNumber},
    {"fracture_energy", measures::kEnergyPerArea},
    {"initial_modulus", measures::kStress},
    {"closure_strain", measures::kNumber},
    {"mode_1", measures::kToughness},
    {"mode_2", measures::kToughness},
    {"friction_angle_deg", measures::kDegrees},
    {"time", measures::kTime},
    {"point_loads.x", measures::kForce},
    {"point_loads.y", measures::kForce},
    {"body_acceleration.x", measures::kAcceleration},
    {"body_acceleration.y", measures::kAcceleration},
    {"motion.x", measures::kNumber},
    {"motion.y", measures::kNumber},

    {"displacement_x", measures::kLength},
    {"displacement_y", measures::kLength},
    {"rotation", measures::kRadians},
    {"velocity_x", measures::kVelocity},
    {"velocity_y", measures::kVelocity},
    {"velocity_rotation", measures::kRotationRate},
    {"stress_xx", measures::kStress},
    {"stress_yy", measures::kStress},
    {"stress_xy", measures::kStress},
    {"area", measures::kArea},
    {"mass", measures::kMass},
    {"moment_of_inertia", measures::kMomentOfInertia},
    {"force", measures::kForce},
    {"displacement", measures::kLength},
    {"speed", measures::kVelocity},

    {"duration", measures::kTime},
    {"equilibrium", measures::kNumber},
});

}  // namespace

std::optional<Measure> measure_of(std::string_view parent, std::string_view key) {
  const std::string full = std::string(parent) + '.' + std::string(key);
  for (const std::string_view wanted : {std::string_view(full), key}) {
    const auto found = std::ranges::find(kFields, wanted, &FieldMeasure::key);
    if (found != kFields.end()) return found->measure;
  }
  return std::nullopt;
}

bool takes_unit(std::string_view parent, std::string_view key) {
  return measure_of(parent, key).value_or(measures::kNumber) != measures::kNumber;
}

bool takes_per_cent(std::string_view parent, std::string_view key) {
  return parent == "initial_strain" || key == "plastic_strain" || key == "closure_strain";
}

}  // namespace keyblock::formats
