// Reads and writes the analysis file of the manifold program; the layout is in the header.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/shi/nmm_analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <stdexcept>

#include "formats/shi/analysis_parts.hpp"
#include "formats/text/demands.hpp"
#include "formats/text/numbers.hpp"
#include "formats/text/split.hpp"
#include "formats/text/tokens.hpp"

namespace keyblock::formats {
namespace {

constexpr double kUsualOverRelaxation = 1.5;  // files hold 1.4 to 1.9

/// Returns true if E and nu of each material fit after `loads` loading points, and the file holds them all.
bool materials_follow(std::span<const double> n, std::size_t loads) {
  if (static_cast<double>(n.size()) < 7 + 2 * static_cast<double>(loads) + 14 * n[2]) return false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n[2]); ++i) {
    const auto material = n.subspan(7 + 2 * loads + 14 * i);
    if (!(material[3] > 0) || !kPoissonPlaneStress.holds(material[4])) return false;
  }
  return true;
}

/// Returns the number of loading points that gives the file's total; nothing if none does.
std::optional<std::size_t> loads_by_total(std::span<const double> n) {
  const auto is_count = [](double v) { return is_whole(v) && v >= 0; };
  if (n.size() < 7 || !kShare.holds(n[0]) || !std::ranges::all_of(n.subspan(1, 3), is_count) || n[2] < 1) return {};
  const double loads = (static_cast<double>(n.size()) - 11 - 14 * n[2] - 3 * n[3]) / 2;
  if (!is_count(loads) || !materials_follow(n, static_cast<std::size_t>(loads))) return {};
  return static_cast<std::size_t>(loads);
}

Recognition recognise(const Tokens& tokens) {
  const std::span<const double> n = tokens.numbers;
  const auto loads = loads_by_total(n);
  if (!loads) return {};
  return {Recognition::Fit::exact,
          fmt::format("7-number head, {} loading points and {} materials of 14 numbers give the file's {} numbers",
                      *loads, n[2], n.size())};
}

std::size_t load_count(const Cursor& cursor, const Tokens& tokens, const ReadHint& hint) {
  const auto loads = loads_by_total(tokens.numbers);
  if (hint.loading_points) {
    const auto points = static_cast<std::size_t>(*hint.loading_points);
    if (loads && *loads != points && !materials_follow(tokens.numbers, points))
      throw InputError(
          cursor.place(),
          fmt::format("expected the loads of {} loading points, as many as its geometry has, found those of {}", points,
                      *loads));
    return points;
  }
  if (loads) return *loads;
  throw InputError(
      cursor.place(),
      "expected the cover file of this analysis, to know its number of loading points; found no number that fits");
}

std::vector<TimeCurve> next_loads(Cursor& cursor, std::size_t count) {
  std::vector<TimeCurve> loads;
  for (std::size_t i = 0; i < count; ++i) {
    cursor.enter({"loading point", i + 1, count});
    TimeCurve load;
    load.place = cursor.place();
    const double x = cursor.next_real("the force in x");
    load.times = {0};
    load.values = {{x, cursor.next_real("the force in y")}};
    loads.push_back(std::move(load));
  }
  cursor.leave();
  return loads;
}

void next_head_of_material(Cursor& cursor, BlockMaterial& material) {
  material.density = cursor.next_real("the mass per unit area", kPositive);
  material.horizontal_force = cursor.next_real("the force per unit area in x");
  material.unit_weight = 0 - cursor.next_real("the force per unit area in y");
  material.youngs_modulus = cursor.next_real("Young's modulus", kPositive);
  material.poissons_ratio = cursor.next_real("Poisson's ratio", kPoissonPlaneStress);
}

Warnings next_final_numbers(Cursor& cursor) {
  const Place place = cursor.place();
  bool is_zero = true;
  for (int i = 0; i < 3; ++i)
    is_zero = cursor.next_real("three numbers behind the over-relaxation factor") == 0 && is_zero;
  if (is_zero) return {};
  return {{"final_numbers_ignored", place,
           "the three numbers behind the over-relaxation factor, of unknown meaning, are ignored"}};
}

Reading read(const Source& source, const ReadHint& hint) {
  const Tokens tokens = tokenise(source);
  Cursor cursor(tokens);
  auto [analysis, counts] = next_controls(cursor, AnalysisDialect::manifold);
  Warnings warnings = next_contact_stiffness(cursor, analysis);
  analysis.point_loads = next_loads(cursor, load_count(cursor, tokens, hint));
  analysis.block_materials = next_block_materials(cursor, counts.blocks, next_head_of_material);
  analysis.joint_materials = next_joint_materials(cursor, counts.joints);
  analysis.over_relaxation = cursor.next_real("the over-relaxation factor");
  warnings = joined(std::move(warnings), next_final_numbers(cursor));
  return {{{}, {}, std::move(analysis)}, joined(std::move(warnings), cursor.remainder())};
}

Point constant_load(const TimeCurve& curve) {
  const auto differs = [&](Point value) { return value != curve.values.front(); };
  if (std::ranges::any_of(curve.values, differs))
    throw std::invalid_argument("a manifold analysis file holds only loads that do not change with time");
  return curve.at(0);
}

std::string block_material_text(const BlockMaterial& material) {
  return fmt::format("{}\n{} {}\n{} {}\n", format_real(material.density), format_real(material.horizontal_force),
                     format_real(0 - material.unit_weight), format_real(material.youngs_modulus),
                     format_real(material.poissons_ratio)) +
         state_text(material);
}

std::string write(const Content& content) {
  if (!content.analysis) throw std::invalid_argument("an analysis file needs an analysis");
  const Analysis& analysis = *content.analysis;
  std::vector<TimeCurve> loads = analysis.point_loads;
  if (const auto points = counted_points(content).loading_points) loads.resize(static_cast<std::size_t>(*points));
  std::string text = controls_text(analysis) + contact_stiffness_text(analysis);
  for (const TimeCurve& load : loads) {
    const Point force = constant_load(load);
    text += fmt::format("{} {}\n", format_real(force.x), format_real(force.y));
  }
  for (const BlockMaterial& material : analysis.block_materials) text += block_material_text(material);
  text += text_of(analysis.joint_materials);
  return text + format_real(analysis.over_relaxation.value_or(kUsualOverRelaxation)) + "\n0 0 0\n";
}

}  // namespace

constinit const Format kNmmAnalysis{
    .name = "nmm-analysis",
    .title = "NMM analysis file (mf)",
    .read = read,
    .write = write,
    .recognise_numbers = recognise,
    .evidence = "count and order from data (12 files); names partly inferred",
    .sample = "1 5 1 1 .01 .1 50\n2 -3\n.1 0 -1 10 .2  0 0 0 0 0 0 0 0 0\n30 0 0\n1.5 0 0 0\n"};

}  // namespace keyblock::formats
