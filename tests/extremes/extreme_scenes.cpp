// Builds blocks, materials and runs that several extreme cases share.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/extremes/extreme_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "geometry/polygon.hpp"
#include "model/kinematics.hpp"

namespace keyblock::extremes {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
// Longer runs are observed only at their beginning and end.
constexpr int kFewSteps = 2000;

bool is_finite(const Frame& frame) {
  return std::ranges::all_of(frame.elements, [](const ElementFrame& e) {
    return std::isfinite(e.centroid.x + e.centroid.y + e.rotation + e.velocity.x + e.velocity.y + e.velocity.rotation +
                         e.stress.xx + e.stress.yy + e.stress.xy + e.area);
  });
}

void run_prepared(const Scene& scene, Run& made) {
  bool all_finite = true;
  Observer observer;
  observer.on_step = [&](const StepReport& step) { made.most_passes = std::max(made.most_passes, step.passes); };
  observer.on_frame = [&](const Frame& frame) {
    if (frame.step == 0) made.first = frame;
    made.before_last = std::move(made.last);
    made.last = frame;
    all_finite = all_finite && is_finite(frame);
  };
  const int steps = scene.settings.step_count;
  const RunOutcome outcome = run(scene, steps <= kFewSteps ? 1 : steps, observer);
  if (outcome.end != RunEnd::finished)
    made.trouble = "ended: " + outcome.reason;
  else if (!all_finite)
    made.trouble = "finished with a NaN";
}

}  // namespace

ElementFrame Run::block(std::size_t index) const {
  if (index < last.elements.size()) return last.elements[index];
  ElementFrame none;
  none.centroid = none.displacement = {kNothing, kNothing};
  none.rotation = none.area = kNothing;
  none.velocity = {kNothing, kNothing, kNothing};
  none.stress = {kNothing, kNothing, kNothing};
  return none;
}

Point Run::travel(std::size_t index) const {
  if (index >= first.elements.size()) return {kNothing, kNothing};
  return block(index).centroid - first.elements[index].centroid;
}

Point Run::measured(std::size_t point) const {
  if (point >= last.measured_points.size()) return {kNothing, kNothing};
  return last.measured_points[point].displacement;
}

Run run_standard(const Problem& problem, const std::vector<Override>& overrides) {
  Run made;
  try {
    const Prepared prepared = prepare(problem, "standard", overrides);
    for (const BlockPolygon& block : prepared.blocks.blocks) made.drawn_area += area(points_of(block.outer));
    run_prepared(prepared.scene, made);
  } catch (const InputError& error) {
    made.trouble = "refused: " + error.sentence();
  } catch (const std::invalid_argument& error) {
    made.trouble = std::string("refused: ") + error.what();
  } catch (const std::exception& error) {
    made.trouble = std::string("crashed: ") + error.what();
  }
  return made;
}

BlockMaterial rock(double density, double modulus, double poissons_ratio) {
  BlockMaterial material;
  material.density = density;
  material.unit_weight = density * kGravity;
  material.youngs_modulus = modulus;
  material.poissons_ratio = poissons_ratio;
  return material;
}

Analysis plain_analysis(double dt, int steps) {
  Analysis analysis;
  analysis.velocity_carry_over = 1;
  analysis.step_count = steps;
  analysis.time_step = dt;
  analysis.allowed_displacement_ratio = 0.01;
  analysis.block_materials = {rock(kDensity, kModulus, kPoisson)};
  analysis.joint_materials = {JointMaterial{}};
  analysis.place = {"extreme", 0, 0};
  return analysis;
}

BlockPolygon polygon(std::vector<Point> corners, int material) {
  BlockPolygon block;
  block.material = material;
  for (const Point& corner : corners) block.outer.push_back({corner, 0});
  return block;
}

BlockPolygon rectangle(Point low, Point high, int material) {
  return polygon({low, {high.x, low.y}, high, {low.x, high.y}}, material);
}

Blocks scene_of_blocks(std::vector<BlockPolygon> held, const std::vector<BlockPolygon>& moving) {
  Blocks scene;
  for (std::size_t i = 0; i < held.size(); ++i) {
    const std::vector<Point> corners = points_of(held[i].outer);
    const Point middle = centroid(corners);
    for (const Point& corner : {corners[0], corners[1]})
      scene.fixed_points.push_back({middle + 0.5 * (corner - middle), static_cast<int>(i), {}});
  }
  scene.blocks = std::move(held);
  scene.blocks.insert(scene.blocks.end(), moving.begin(), moving.end());
  scene.place = {"extreme", 0, 0};
  return scene;
}

Blocks block_on_slope(double slope) {
  BlockPolygon wedge = rectangle({0, -2}, {20, 0});
  BlockPolygon block = rectangle({1, 0}, {2, 1});
  for (BlockPolygon* one : {&wedge, &block})
    for (BlockVertex& corner : one->outer) corner.position = turned(corner.position, -slope);
  return scene_of_blocks({wedge}, {block});
}

Blocks column(int count) {
  std::vector<BlockPolygon> squares;
  for (int i = 0; i < count; ++i) {
    const double y = i;
    squares.push_back(rectangle({0, y}, {1, y + 1}));
  }
  Blocks scene = scene_of_blocks({rectangle({-2, -1}, {3, 0})}, squares);
  scene.measured_points.push_back({{0.5, static_cast<double>(count)}, count, {}});
  return scene;
}

double slide(double slope, double friction, double time) {
  const double pull = std::sin(slope) - std::cos(slope) * std::tan(friction);
  return std::max(0.0, kGravity / 2 * pull * time * time);
}

double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

}  // namespace keyblock::extremes
