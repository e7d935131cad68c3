// Reads and writes Berkeley's and Shi's native analysis files; the layout is in the header.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/shi/dda_analysis.hpp"

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

constexpr std::int64_t kBlockMaterialSize = 13;
constexpr std::int64_t kJointMaterialSize = 3;
constexpr Demand kRowCount{{0}, "0, or 2 and more", true, 1};

/// Numbers of the materials that a head announces; nothing if it cannot be a head.
struct Materials {
  std::int64_t blocks, joints;

  std::int64_t size() const { return kBlockMaterialSize * blocks + kJointMaterialSize * joints; }
};

std::optional<Materials> materials_of(std::span<const double> numbers) {
  if (numbers.size() < 6 || !kShare.holds(numbers[0])) return std::nullopt;
  for (const int i : {1, 2, 3})
    if (!is_whole(numbers[i])) return std::nullopt;
  if (numbers[2] < 1 || numbers[3] < 0) return std::nullopt;
  return Materials{static_cast<std::int64_t>(numbers[2]), static_cast<std::int64_t>(numbers[3])};
}

/// Returns true if block materials may stand from `at` on: mass, E and nu have possible values. Precondition: the
/// numbers exist.
bool block_materials_at(std::span<const double> numbers, std::int64_t at, std::int64_t count) {
  for (std::int64_t i = 0; i < count; ++i) {
    const auto material = numbers.subspan(at + kBlockMaterialSize * i);
    if (material[0] < 0 || !(material[2] > 0) || !kPoissonPlaneStress.holds(material[3])) return false;
  }
  return true;
}

/// Returns true for more numbers than in Berkeley's file and no block material at its first place: only Shi's file
/// fits.
bool is_like_shi(std::span<const double> numbers, const Materials& materials) {
  const auto have = static_cast<std::int64_t>(numbers.size());
  return have > 6 + materials.size() && !block_materials_at(numbers, 6, materials.blocks);
}

Recognition recognise_berkeley(const Tokens& tokens) {
  using Fit = Recognition::Fit;
  const auto have = static_cast<std::int64_t>(tokens.numbers.size());
  if (tokens.numbers.empty() || !kShare.holds(tokens.numbers[0])) return {};
  if (const auto materials = materials_of(tokens.numbers)) {
    const std::int64_t total = 6 + materials->size();
    const std::string evidence =
        fmt::format("6-number head with {} block and {} joint materials gives {} numbers, the file has {}",
                    materials->blocks, materials->joints, total, have);
    if (total == have) return {Fit::exact, evidence};
    if (is_like_shi(tokens.numbers, *materials)) return {};
    if (total < have) return {Fit::surplus, evidence};
  }
  return {Fit::damaged, fmt::format("its first number, {}, can be a velocity carry-over, but the counts do not fit",
                                    format_real(tokens.numbers[0]))};
}

/// Returns true if the rows after `points` flags, the first at `flags`, may be curves: times increase within each.
bool times_increase(std::span<const double> numbers, std::int64_t flags, std::int64_t points) {
  std::int64_t time = flags + points;
  for (const double flag : numbers.subspan(flags, points)) {
    const auto rows = static_cast<std::int64_t>(flag);
    for (std::int64_t row = 1; row < rows; ++row)
      if (!(numbers[time + 3 * row] > numbers[time + 3 * (row - 1)])) return false;
    time += 3 * rows;
  }
  return true;
}

/// Returns every number of points with which the count equation of Shi's file gives the count of the file.
std::vector<int> possible_point_counts(std::span<const double> numbers) {
  const auto materials = materials_of(numbers);
  const auto have = static_cast<std::int64_t>(numbers.size());
  std::vector<int> counts;
  std::int64_t rows = 0;
  for (std::int64_t points = 0; materials; ++points) {
    const std::int64_t start = 7 + points + 3 * rows;
    const std::int64_t tail = have - start - materials->size();
    if (tail < 0) break;
    const bool sound_tail = tail == 0 || (tail == 1 && numbers[have - 1] >= 1 && numbers[have - 1] <= 2);
    if (sound_tail && times_increase(numbers, 7, points) && block_materials_at(numbers, start, materials->blocks))
      counts.push_back(static_cast<int>(points));
    const double flag = numbers[7 + points];
    if (!kRowCount.holds(flag) || flag > static_cast<double>(have)) break;
    rows += static_cast<std::int64_t>(flag);
  }
  return counts;
}

Recognition recognise_shi(const Tokens& tokens) {
  const std::vector<int> counts = possible_point_counts(tokens.numbers);
  const auto materials = materials_of(tokens.numbers);
  if (counts.empty() && materials && kShare.holds(tokens.numbers[0]) && is_like_shi(tokens.numbers, *materials))
    return {Recognition::Fit::damaged,
            "more numbers than Berkeley's dialect has, and no block material at the place of its first"};
  if (counts.empty()) return {};
  return {Recognition::Fit::exact, fmt::format("7-number head, {} points and the materials give the file's {} numbers",
                                               fmt::join(counts, " or "), tokens.numbers.size())};
}

void next_head_of_material(Cursor& cursor, BlockMaterial& material) {
  material.density = cursor.next_real("the mass per unit area", kPositive);
  material.unit_weight = cursor.next_real("the weight per unit area");
  material.youngs_modulus = cursor.next_real("Young's modulus", kPositive);
  material.poissons_ratio = cursor.next_real("Poisson's ratio", kPoissonPlaneStress);
}

Reading read_berkeley(const Source& source, const ReadHint&) {
  const Tokens tokens = tokenise(source);
  Cursor cursor(tokens);
  auto [analysis, counts] = next_controls(cursor, AnalysisDialect::berkeley);
  analysis.block_materials = next_block_materials(cursor, counts.blocks, next_head_of_material);
  analysis.joint_materials = next_joint_materials(cursor, counts.joints);
  return {{{}, {}, std::move(analysis)}, cursor.remainder()};
}

/// Number of points with a flag, and of those that are fixed; the others are loaded.
struct CurveCounts {
  int points = 0;
  std::optional<int> fixed;  ///< absent: unknown without the geometry
};

CurveCounts curve_counts(const Tokens& tokens, const ReadHint& hint) {
  std::vector<int> counts = possible_point_counts(tokens.numbers);
  if (hint.fixed_points && hint.loading_points) {
    const int points = *hint.fixed_points + *hint.loading_points;
    if (!counts.empty() && std::ranges::find(counts, points) == counts.end())
      throw InputError(tokens.place_of(7),
                       fmt::format("expected time rows of {} fixed and {} loading points, as many as its geometry has, "
                                   "found those of {} points",
                                   *hint.fixed_points, *hint.loading_points, fmt::join(counts, " or ")));
    return {points, hint.fixed_points};
  }
  if (hint.loading_points) std::erase_if(counts, [&](int points) { return points < *hint.loading_points; });
  if (counts.size() != 1)
    throw InputError(tokens.place_of(7),
                     fmt::format("expected the block or geometry file of this analysis, to know its number of fixed "
                                 "and loading points; found {} that fit",
                                 counts.empty() ? "none" : fmt::format("{}", fmt::join(counts, ", "))));
  if (hint.loading_points) return {counts[0], counts[0] - *hint.loading_points};
  return {counts[0], std::nullopt};
}

TimeCurve next_curve(Cursor& cursor, int rows) {
  TimeCurve curve;
  curve.place = cursor.place();
  for (int row = 0; row < rows; ++row) {
    cursor.enter({"row", static_cast<std::size_t>(row) + 1, static_cast<std::size_t>(rows)});
    curve.times.push_back(row == 0 ? cursor.next_real("the time")
                                   : cursor.next_real_above(curve.times.back(), "the time"));
    const double x = cursor.next_real("the x value");
    curve.values.push_back({x, cursor.next_real("the y value")});
  }
  cursor.leave();
  return curve;
}

std::vector<TimeCurve> next_curves(Cursor& cursor, int points) {
  std::vector<int> rows;
  for (int i = 0; i < points; ++i) {
    cursor.enter({"fixed or loading point", static_cast<std::size_t>(i) + 1, static_cast<std::size_t>(points)});
    rows.push_back(cursor.next_integer("the number of time rows", kRowCount));
  }
  cursor.leave();
  std::vector<TimeCurve> curves;
  for (const int count : rows) curves.push_back(next_curve(cursor, count));
  return curves;
}

/// Assigns curves to the two lists of the analysis. Without the geometry this is possible only if none has rows.
Analysis with_curves(Analysis analysis, const std::vector<TimeCurve>& curves, const CurveCounts& counts) {
  if (counts.fixed) {
    analysis.fixed_point_motions.assign(curves.begin(), curves.begin() + *counts.fixed);
    analysis.point_loads.assign(curves.begin() + *counts.fixed, curves.end());
    return analysis;
  }
  for (const TimeCurve& curve : curves)
    if (!curve.times.empty())
      throw InputError(curve.place,
                       "expected the block or geometry file of this analysis, to know whether these time rows move a "
                       "fixed point or load a loading point; found none");
  return analysis;
}

Reading read_shi(const Source& source, const ReadHint& hint) {
  const Tokens tokens = tokenise(source);
  Cursor cursor(tokens);
  auto [analysis, materials] = next_controls(cursor, AnalysisDialect::shi);
  Warnings warnings = next_contact_stiffness(cursor, analysis);
  const CurveCounts counts = curve_counts(tokens, hint);
  analysis = with_curves(std::move(analysis), next_curves(cursor, counts.points), counts);
  analysis.block_materials = next_block_materials(cursor, materials.blocks, next_head_of_material);
  analysis.joint_materials = next_joint_materials(cursor, materials.joints);
  if (cursor.numbers_left() > 0) analysis.over_relaxation = cursor.next_real("the over-relaxation factor");
  warnings = joined(std::move(warnings), cursor.remainder());
  return {{{}, {}, std::move(analysis)}, std::move(warnings)};
}

std::string block_material_text(const BlockMaterial& material) {
  return fmt::format("{} {} {} {}\n", format_real(material.density), format_real(material.unit_weight),
                     format_real(material.youngs_modulus), format_real(material.poissons_ratio)) +
         state_text(material);
}

const Analysis& analysis_of(const Content& content) {
  if (!content.analysis) throw std::invalid_argument("an analysis file needs an analysis");
  return *content.analysis;
}

std::string materials_text(const Analysis& analysis) {
  std::string text;
  for (const BlockMaterial& material : analysis.block_materials) text += block_material_text(material);
  return text + text_of(analysis.joint_materials);
}

std::string write_berkeley(const Content& content) {
  const Analysis& analysis = analysis_of(content);
  return controls_text(analysis) + materials_text(analysis);
}

/// Returns the curves in the form of the file: one per point of the geometry if its points are known.
std::vector<TimeCurve> curves_to_write(std::vector<TimeCurve> curves, std::optional<int> points) {
  if (points) curves.resize(static_cast<std::size_t>(*points));
  for (TimeCurve& curve : curves) curve = with_two_rows(std::move(curve));
  return curves;
}

std::string rows_text(const std::vector<TimeCurve>& curves) {
  std::string text;
  for (const TimeCurve& curve : curves)
    for (std::size_t row = 0; row < curve.times.size(); ++row)
      text += fmt::format("{} {} {}\n", format_real(curve.times[row]), format_real(curve.values[row].x),
                          format_real(curve.values[row].y));
  return text;
}

std::string write_shi(const Content& content) {
  const Analysis& analysis = analysis_of(content);
  const ReadHint points = counted_points(content);
  std::vector<TimeCurve> curves = curves_to_write(analysis.fixed_point_motions, points.fixed_points);
  for (TimeCurve& curve : curves_to_write(analysis.point_loads, points.loading_points))
    curves.push_back(std::move(curve));
  std::string text = controls_text(analysis) + contact_stiffness_text(analysis);
  for (const TimeCurve& curve : curves) text += fmt::format("{}\n", curve.times.size());
  text += rows_text(curves) + materials_text(analysis);
  if (analysis.over_relaxation) text += format_real(*analysis.over_relaxation) + '\n';
  return text;
}

}  // namespace

constinit const Format kDdaAnalysisBerkeley{
    .name = "dda-analysis-berkeley",
    .title = "native DDA analysis, Berkeley dialect",
    .read = read_berkeley,
    .write = write_berkeley,
    .recognise_numbers = recognise_berkeley,
    .evidence = "data",
    .sample = "1\n50\n1\n1\n0.01\n0.001\n2500 24525 5e9 0.25\n0 0 0\n0 0 0\n0 0 0\n30 0 0\n"};
constinit const Format kDdaAnalysisShi{
    .name = "dda-analysis-shi",
    .title = "native DDA analysis, Shi's dialect",
    .read = read_shi,
    .write = write_shi,
    .recognise_numbers = recognise_shi,
    .evidence = "comments of public source; over-relaxation inferred; no real file seen",
    .sample =
        "1 20 1 1 .006 .01 1e7\n0 2 2\n0 0 0 5 1 1\n0 7 7 5 8 8\n5 161 1e6 .25\n0 0 0 0 0 0 0 0 0\n30 0 0\n1.5\n"};

}  // namespace keyblock::formats
