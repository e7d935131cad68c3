// ext-02: a column of two layers, one 1e8 times stiffer, under a pressure of 1 Pa.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/extremes/extreme.hpp"
#include "tests/extremes/extreme_scenes.hpp"

namespace keyblock::extremes {
namespace {

constexpr double kStiff = 1e11;
constexpr double kSoft = 1e3;

Extremes pressed(double lower, double upper, const std::string& variant) {
  Blocks blocks = column(2);
  blocks.blocks[1].material = 1;
  blocks.blocks[2].material = 2;
  blocks.loading_points = {{{0, 2}, 2, {}}, {{1, 2}, 2, {}}};
  Analysis analysis = plain_analysis(1e-3, 100);
  analysis.gravity = 0;
  analysis.block_materials = {rock(kDensity, kModulus, 0), rock(kDensity, lower, 0), rock(kDensity, upper, 0)};
  const TimeCurve half{{0, 1}, {{0, -0.5}, {0, -0.5}}, {}};
  analysis.point_loads = {half, half};
  Problem problem;
  problem.geometry = blocks;
  problem.analysis = analysis;
  const Run run = run_standard(problem);
  const double shortening = -run.measured(0).y;
  const double lower_strain = -run.block(1).stress.yy / lower;
  const double upper_strain = -run.block(2).stress.yy / upper;
  const double soft_strain = std::max(lower_strain, upper_strain);
  const double stiff_strain = std::min(lower_strain, upper_strain);
  return {{"ext-02", variant + "shortening of both", 1 / kSoft + 1 / kStiff, shortening, 1e-6 * 1e-3, run.trouble},
          {"ext-02", variant + "strain of the soft layer", 1e-3, soft_strain, 1e-6 * 1e-3, {}},
          {"ext-02", variant + "strain of the stiff layer", 1e-11, stiff_strain, 1e-2 * 1e-11, {}}};
}

}  // namespace

Extremes stiffness_ratio(Effort) {
  Extremes rows = pressed(kStiff, kSoft, "soft on stiff: ");
  const Extremes other = pressed(kSoft, kStiff, "stiff on soft: ");
  rows.insert(rows.end(), other.begin(), other.end());
  return rows;
}

}  // namespace keyblock::extremes
