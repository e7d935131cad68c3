// ext-09: a wall in running bond under its own weight stays at rest.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "tests/extremes/extreme.hpp"
#include "tests/extremes/extreme_scenes.hpp"

namespace keyblock::extremes {
namespace {

constexpr double kLength = 0.4;  // of a brick, m
constexpr double kHeight = 0.2;

struct Wall {
  int courses = 0;
  int bricks = 0;  ///< of a course; every second course has two half bricks instead of one
};

Blocks blocks_of(const Wall& wall) {
  std::vector<BlockPolygon> bricks;
  const double end = wall.bricks * kLength;
  for (int i = 0; i < wall.courses; ++i) {
    const double y = i * kHeight;
    const double shift = i % 2 == 0 ? 0 : kLength / 2;
    for (double x = -shift; x < end - kLength / 4; x += kLength)
      bricks.push_back(rectangle({std::max(0.0, x), y}, {std::min(end, x + kLength), y + kHeight}));
  }
  Blocks scene = scene_of_blocks({rectangle({-1, -1}, {end + 1, 0})}, bricks);
  const Point top = bricks.back().outer[2].position;
  scene.measured_points = {{top, static_cast<int>(scene.blocks.size()) - 1, {}}};
  return scene;
}

Extremes rest(const Wall& wall, int steps) {
  Problem problem;
  problem.geometry = blocks_of(wall);
  problem.analysis = plain_analysis(1e-3, steps);
  problem.analysis->block_materials = {rock(kDensity, kModulus, 0)};
  problem.analysis->joint_materials[0].friction_angle_deg = 30;
  const std::string variant = fmt::format("{} courses of {} bricks, {} steps: ", wall.courses, wall.bricks, steps);
  const Run run = run_standard(problem);
  if (!run.is_sound()) return {{"ext-09", variant + "runs", 1, 0, 0, run.trouble}};
  const double height = wall.courses * kHeight;
  const double weight = kDensity * kGravity * wall.bricks * kLength * height;
  double gain = 0;  // of vertical momentum in the last step
  double kinetic = 0;
  for (std::size_t i = 0; i < run.last.elements.size(); ++i) {
    const ElementFrame& e = run.block(i);
    const double mass = kDensity * e.area;
    gain += mass * (e.velocity.y - run.before_last.elements[i].velocity.y);
    kinetic += mass * (e.velocity.x * e.velocity.x + e.velocity.y * e.velocity.y) / 2;
  }
  const double dt = problem.analysis->time_step;
  const double settlement = kDensity * kGravity * height * height / (2 * kModulus);
  return {{"ext-09", variant + "force on the base / weight", 1, 1 + gain / (dt * weight), 1e-6, {}},
          {"ext-09", variant + "settlement of the top", settlement, -run.measured(0).y, 0.05 * settlement, {}},
          {"ext-09", variant + "kinetic energy / m g h", 0, kinetic / (weight * height), 1e-12, {}}};
}

}  // namespace

Extremes wall_at_rest(Effort effort) {
  if (effort == Effort::brief) return rest({10, 20}, 100);
  return rest({100, 10}, 10'000);
}

}  // namespace keyblock::extremes
