// ext-05: slivers, given as polygons and left by cuts close to one another.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/extremes/extreme.hpp"
#include "tests/extremes/extreme_scenes.hpp"

namespace keyblock::extremes {
namespace {

// Their own weight strains them by 2e-10 at most.
constexpr double kStrained = 1e-9;
constexpr double kRoundOffOfSlivers = 1e-14;  // of a square metre

// (0,0), (1,0), (0.5, height) lying on a floor.
Extremes lying_triangle(double height) {
  Problem problem;
  problem.geometry = scene_of_blocks({rectangle({-2, -1}, {3, 0})}, {polygon({{0, 0}, {1, 0}, {0.5, height}})});
  problem.analysis = plain_analysis(1e-3, 100);
  problem.analysis->joint_materials[0].friction_angle_deg = 30;
  const std::string variant = fmt::format("triangle {:g} high: ", height);
  const Run run = run_standard(problem);
  const double area = height / 2;
  // Equilibrium: its mean vertical stress is a third of the pressure of its largest depth, by Σ of weight times height
  // of the centroid.
  return {{"ext-05", variant + "area", area, run.block(1).area, kStrained * area, run.trouble},
          {"ext-05",
           variant + "vertical stress",
           -kDensity * kGravity * height / 3,
           run.block(1).stress.yy,
           1e-6 * kDensity * kGravity * height,
           {}},
          {"ext-05", variant + "drift", 0, length(run.travel(1)), 1e-9, {}}};
}

// Two joints `distance` apart through a fixed square of 1 m: the blocks together keep its area, with or without a block
// in the strip between.
Drawing strip(double distance, double overhang) {
  Drawing drawing;
  drawing.edge_node_ratio = 1e-12;
  const auto line = [&](Point a, Point b) { drawing.joints.push_back({{a, b}, 0, {}}); };
  line({0, 0}, {1, 0});
  line({1, 0}, {1, 1});
  line({1, 1}, {0, 1});
  line({0, 1}, {0, 0});
  drawing.boundary_count = 4;
  line({-overhang, 0.5}, {1 + overhang, 0.5});
  line({-overhang, 0.5 + distance}, {1 + overhang, 0.5 + distance});
  drawing.fixed_lines = {{{{0.2, 0.2}, {0.2, 0.2}}, {}}, {{{0.8, 0.2}, {0.8, 0.2}}, {}}};
  return drawing;
}

Run run_strip(double distance, double overhang) {
  Problem problem;
  problem.geometry = strip(distance, overhang);
  problem.analysis = plain_analysis(1e-3, 20);
  problem.analysis->joint_materials[0].friction_angle_deg = 30;
  return run_standard(problem);
}

Extremes cut_strip(double distance) {
  const std::string variant = fmt::format("joints {:g} apart: ", distance);
  const Run run = run_strip(distance, 0);
  const std::size_t upper = std::max<std::size_t>(1, run.last.elements.size()) - 1;
  return {{"ext-05", variant + "makes 20 steps", 1, run.is_sound() ? 1.0 : 0.0, 0, run.trouble},
          {"ext-05", variant + "area of all blocks", 1, run.drawn_area, kRoundOffOfSlivers, {}},
          {"ext-05", variant + "sinking of the upper block", 0, length(run.travel(upper)), 1e-9, {}}};
}

// Ends of such joints outside the square meet within the reach of a line and leave unsupported needles there. They
// fall, or a message names the fault.
Extreme needles(double distance) {
  const Run run = run_strip(distance, 0.1);
  return {"ext-05", fmt::format("needles {:g} wide: no crash, no NaN", distance),
          1,        run.trouble.starts_with("crashed") || run.trouble.ends_with("NaN") ? 0.0 : 1.0,
          0,        run.trouble};
}

}  // namespace

Extremes slivers(Effort) {
  Extremes rows;
  const auto add = [&](const Extremes& more) { rows.insert(rows.end(), more.begin(), more.end()); };
  for (const double height : {1e-4, 1e-8}) add(lying_triangle(height));
  for (int power = -3; power >= -10; --power) {
    add(cut_strip(std::pow(10.0, power)));
    rows.push_back(needles(std::pow(10.0, power)));
  }
  return rows;
}

}  // namespace keyblock::extremes
