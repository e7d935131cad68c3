// Reads and writes the common parts of native analysis files.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/shi/analysis_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "formats/text/demands.hpp"
#include "formats/text/numbers.hpp"

namespace keyblock::formats {
namespace {

constexpr double kPenaltyFactor = 50;  // of Shi's programs, over the largest Young's modulus
constexpr double kEndOfTime = 100000;  // last time in rows that Shi's programs insert

int next_material_count(Cursor& cursor, std::string_view name) {
  const Place place = cursor.place();
  const int count = cursor.next_count(name);
  if (count == 0) throw InputError(place, fmt::format("expected {} (1 or more), found \"0\"", name));
  return count;
}

Stress next_stress(Cursor& cursor, std::string_view xx, std::string_view yy, std::string_view xy) {
  Stress stress;
  stress.xx = cursor.next_real(xx);
  stress.yy = cursor.next_real(yy);
  stress.xy = cursor.next_real(xy);
  return stress;
}

Velocity next_velocity(Cursor& cursor) {
  Velocity velocity;
  velocity.x = cursor.next_real("the initial velocity in x");
  velocity.y = cursor.next_real("the initial velocity in y");
  velocity.rotation = cursor.next_real("the initial rotation rate");
  return velocity;
}

JointMaterial next_joint_material(Cursor& cursor) {
  JointMaterial material;
  material.place = cursor.place();
  material.friction_angle_deg = cursor.next_real("the friction angle", kFrictionAngle);
  material.cohesion = cursor.next_real("the cohesion", kNotNegative);
  material.tensile_strength = cursor.next_real("the tensile strength", kNotNegative);
  return material;
}

std::string line(double a, double b, double c) {
  return fmt::format("{} {} {}\n", format_real(a), format_real(b), format_real(c));
}

}  // namespace

ReadHint counted_points(const Content& geometry) {
  const auto count = [](const auto& points) { return static_cast<int>(points.size()); };
  const auto is_one_point = [](const FixedLine& line) { return line.segment.start == line.segment.end; };
  if (geometry.cover) return {std::nullopt, count(geometry.cover->loading_points), GeometryKind::cover};
  if (geometry.blocks)
    return {count(geometry.blocks->fixed_points), count(geometry.blocks->loading_points), GeometryKind::blocks};
  if (!geometry.drawing) return {};
  const Drawing& drawing = *geometry.drawing;
  ReadHint hint{std::nullopt, count(drawing.loading_points), GeometryKind::drawing};
  if (std::ranges::all_of(drawing.fixed_lines, is_one_point)) hint.fixed_points = count(drawing.fixed_lines);
  return hint;
}

std::pair<Analysis, MaterialCounts> next_controls(Cursor& cursor, AnalysisDialect dialect) {
  Analysis analysis;
  analysis.dialect = dialect;
  analysis.automatic_time_step = true;
  analysis.automatic_penalty = true;
  analysis.penalty_factor = kPenaltyFactor;
  analysis.place = {cursor.place().file};
  analysis.velocity_carry_over = cursor.next_real("the velocity carry-over (0 static, 1 dynamic)", kShare);
  analysis.step_count = cursor.next_integer("the number of time steps", kStepCount);
  MaterialCounts counts;
  counts.blocks = next_material_count(cursor, "the number of block materials");
  counts.joints = next_material_count(cursor, "the number of joint materials");
  analysis.allowed_displacement_ratio = cursor.next_real("the allowed displacement ratio", kPositive);
  analysis.time_step_place = cursor.place();
  analysis.time_step = cursor.next_real("the upper limit of the time step", kPositive);
  return {std::move(analysis), counts};
}

Warnings next_contact_stiffness(Cursor& cursor, Analysis& analysis) {
  const Place place = cursor.place();
  const double stiffness = cursor.next_real("the contact stiffness", kNotNegative);
  if (stiffness > 0) analysis.contact_penalty = stiffness;
  if (stiffness > 0) return {};
  return {{"contact_stiffness_zero", place,
           "contact stiffness 0 taken as \"program chooses\": 50 × the largest Young's modulus"}};
}

std::vector<BlockMaterial> next_block_materials(Cursor& cursor, int count,
                                                void (*next_head)(Cursor& cursor, BlockMaterial& material)) {
  constexpr std::size_t kFewestNumbers = 13;  // per record: four at its head, stress, its gradient and the velocity
  std::vector<BlockMaterial> materials;
  materials.reserve(std::min(static_cast<std::size_t>(std::max(0, count)), cursor.numbers_left() / kFewestNumbers));
  for (int i = 0; i < count; ++i) {
    cursor.enter({"block material", static_cast<std::size_t>(i) + 1, static_cast<std::size_t>(count)});
    BlockMaterial material;
    material.place = cursor.place();
    next_head(cursor, material);
    material.initial_stress =
        next_stress(cursor, "the initial stress xx", "the initial stress yy", "the initial stress xy");
    material.stress_gradient =
        next_stress(cursor, "the stress gradient xx", "the stress gradient yy", "the stress gradient xy");
    material.initial_velocity = next_velocity(cursor);
    materials.push_back(material);
  }
  cursor.leave();
  return materials;
}

std::vector<JointMaterial> next_joint_materials(Cursor& cursor, int count) {
  std::vector<JointMaterial> materials;
  for (int i = 0; i < count; ++i) {
    cursor.enter({"joint material", static_cast<std::size_t>(i) + 1, static_cast<std::size_t>(count)});
    materials.push_back(next_joint_material(cursor));
  }
  cursor.leave();
  return materials;
}

double largest_modulus(const Analysis& analysis) {
  double largest = 0;
  for (const BlockMaterial& material : analysis.block_materials) largest = std::max(largest, material.youngs_modulus);
  return largest;
}

TimeCurve with_two_rows(TimeCurve curve) {
  if (curve.times.size() != 1) return curve;
  const double start = curve.times.front();
  const double end = start + std::max(kEndOfTime, std::abs(start));
  curve.times.push_back(std::min(end, std::numeric_limits<double>::max()));
  curve.values.push_back(curve.values.front());
  return curve;
}

std::string controls_text(const Analysis& analysis) {
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n", format_real(analysis.velocity_carry_over), analysis.step_count,
                     analysis.block_materials.size(), analysis.joint_materials.size(),
                     format_real(analysis.allowed_displacement_ratio), format_real(analysis.time_step));
}

std::string contact_stiffness_text(const Analysis& analysis) {
  const bool program_chooses = !analysis.contact_penalty && analysis.penalty_factor == kPenaltyFactor;
  const double by_factor = program_chooses ? 0 : analysis.penalty_factor * largest_modulus(analysis);
  return format_real(analysis.contact_penalty.value_or(by_factor)) + '\n';
}

std::string state_text(const BlockMaterial& material) {
  const auto& [s, t, v] = std::tie(material.initial_stress, material.stress_gradient, material.initial_velocity);
  return line(s.xx, s.yy, s.xy) + line(t.xx, t.yy, t.xy) + line(v.x, v.y, v.rotation);
}

std::string text_of(const std::vector<JointMaterial>& materials) {
  std::string text;
  for (const JointMaterial& material : materials)
    text += line(material.friction_angle_deg, material.cohesion, material.tensile_strength);
  return text;
}

}  // namespace keyblock::formats
