// Computes the same brick wall and pyramid of rigid blocks by Box2D and by Keyblock: steps per second, largest
// penetration, energy gained or lost.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <box2d/box2d.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "base/loop.hpp"
#include "model/setup/choose_basis.hpp"
#include "model/setup/from_blocks.hpp"
#include "run/steppers.hpp"
#include "tests/bench/bench_scenes.hpp"

namespace keyblock::bench {
namespace {

constexpr double kStep = 1.0 / 60;
constexpr int kSteps = 30;
constexpr int kMostEffort = 512;
constexpr double kGravity = 9.81;
constexpr double kDensity = 2500;

double now() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Outcome {
  double steps_per_second = 0;
  double penetration = 0;  ///< largest downward displacement of a block: at rest only penetration into its support
  double energy = 0;       ///< |kinetic + gravity − their initial sum| over m g h of all blocks
};

struct Box {
  Point low;
  Point high;
  double mass() const { return kDensity * (high.x - low.x) * (high.y - low.y); }
  Point centre() const { return 0.5 * (low + high); }
};

std::vector<Box> boxes_of(const Blocks& blocks) {
  std::vector<Box> boxes;
  for (const BlockPolygon& block : blocks.blocks) boxes.push_back({block.outer[0].position, block.outer[2].position});
  return boxes;
}

double weight_times_height(const std::vector<Box>& boxes) {
  double sum = 0;
  for (std::size_t i = 1; i < boxes.size(); ++i) sum += boxes[i].mass() * kGravity * boxes[i].centre().y;
  return sum;
}

// Compares each block with its support only, which is enough for walls at rest.
Outcome by_box2d(const std::vector<Box>& boxes, int effort) {
  b2World world(b2Vec2(0, -static_cast<float>(kGravity)));
  world.SetAllowSleeping(false);
  std::vector<b2Body*> bodies;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    b2BodyDef definition;
    definition.type = i == 0 ? b2_staticBody : b2_dynamicBody;
    definition.position.Set(static_cast<float>(boxes[i].centre().x), static_cast<float>(boxes[i].centre().y));
    b2PolygonShape shape;
    shape.SetAsBox(static_cast<float>((boxes[i].high.x - boxes[i].low.x) / 2),
                   static_cast<float>((boxes[i].high.y - boxes[i].low.y) / 2));
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.density = static_cast<float>(kDensity);
    fixture.friction = 0.7F;  // tan 35°
    bodies.push_back(world.CreateBody(&definition));
    bodies.back()->CreateFixture(&fixture);
  }
  const double begin = now();
  for (int i = 0; i < kSteps; ++i) world.Step(static_cast<float>(kStep), 8 * effort, 3 * effort);
  Outcome outcome;
  outcome.steps_per_second = kSteps / (now() - begin);
  double change = 0;
  for (std::size_t i = 1; i < boxes.size(); ++i) {
    const double fall = boxes[i].centre().y - static_cast<double>(bodies[i]->GetPosition().y);
    outcome.penetration = std::max(outcome.penetration, fall);
    const double speed = static_cast<double>(bodies[i]->GetLinearVelocity().Length());
    const double spin = static_cast<double>(bodies[i]->GetAngularVelocity());
    const double inertia = static_cast<double>(bodies[i]->GetInertia());
    change += boxes[i].mass() * (speed * speed / 2 - kGravity * fall) + inertia * spin * spin / 2;
  }
  outcome.energy = std::abs(change) / weight_times_height(boxes);
  return outcome;
}

Scene rigid_scene(const Blocks& blocks, const std::string& profile) {
  Analysis analysis = scaling_analysis(blocks);
  analysis.time_step = kStep;
  Settings settings = profile_settings(profile, analysis);
  settings.basis = BlockBasis::rigid;
  settings.standard.start = StartRule::sudden;
  settings.ledger = Bookkeeping::off;
  if (settings.dynamics == Dynamics::standard) return support::standard_scene_of(blocks, analysis, settings);
  return {with_moving_bases(model_from_blocks(blocks, analysis), settings.basis), settings};
}

Outcome by_us(const Blocks& blocks, const std::vector<Box>& boxes, const std::string& profile) {
  const Scene scene = rigid_scene(blocks, profile);
  const std::unique_ptr<Stepper> stepper = stepper_for(scene);
  const double begin = now();
  for (int i = 0; i < kSteps; ++i) {
    const auto made = stepper->advance();
    if (const auto* failure = std::get_if<StepFailure>(&made)) throw std::runtime_error(failure->reason);
  }
  Outcome outcome;
  outcome.steps_per_second = kSteps / (now() - begin);
  double change = 0;
  for (std::size_t i = 1; i < boxes.size(); ++i) {
    const ElementIndex e{static_cast<int>(i)};
    const ElementState& block = stepper->state().elements[e];
    const double fall = boxes[i].centre().y - block.centroid.y;
    outcome.penetration = std::max(outcome.penetration, fall);
    const Unknowns v = end_velocity(block, stepper->state(), scene.settings, scene.model.elements[e].material);
    const double width = boxes[i].high.x - boxes[i].low.x;
    const double height = boxes[i].high.y - boxes[i].low.y;
    change += boxes[i].mass() *
              (v.head<2>().squaredNorm() / 2 - kGravity * fall + v[2] * v[2] * (width * width + height * height) / 24);
  }
  outcome.energy = std::abs(change) / weight_times_height(boxes);
  return outcome;
}

// `ratio`: steps per second of Keyblock over those of Box2D; empty beside Keyblock's own.
void print(const std::string& name, const Outcome& outcome, const std::vector<Outcome>& ours) {
  std::string ratios;
  for (const Outcome& one : ours) ratios += fmt::format("{:>10.2f}", one.steps_per_second / outcome.steps_per_second);
  fmt::print("{:>26} {:>9.1f} {:>9.1e} {:>9.1e} {}\n", name, outcome.steps_per_second, outcome.penetration,
             outcome.energy, ratios);
  std::fflush(stdout);
}

void compare(const std::string& name, const Blocks& blocks) {
  const std::vector<Box> boxes = boxes_of(blocks);
  fmt::print("{} of {}\n", name, boxes.size());
  std::vector<Outcome> ours;
  for (const char* profile : {"legacy", "standard"}) {
    ours.push_back(by_us(blocks, boxes, profile));
    print(fmt::format("ours, {}", profile), ours.back(), {});
  }
  // Adds iterations until the penetration is that of Keyblock.
  const double least = std::min(ours[0].penetration, ours[1].penetration);
  for (int effort = 1; effort <= kMostEffort; effort *= 2) {
    const Outcome theirs = by_box2d(boxes, effort);
    print(fmt::format("Box2D, {} + {} iterations", 8 * effort, 3 * effort), theirs, ours);
    if (theirs.penetration <= least) break;
  }
}

}  // namespace
}  // namespace keyblock::bench

int main() {
  using namespace keyblock::bench;
  fmt::print(
      "30 steps of 1/60 s at rest, rigid blocks, friction of 35 degrees; Box2D {}.{}.{}, awake; one thread each\n"
      "{:>26} {:>9} {:>9} {:>9} {:>20}\n",
      b2_version.major, b2_version.minor, b2_version.revision, "", "steps/s", "sinks m", "energy",
      "legacy/  standard/");
  keyblock::context().use_threads(1);  // processor time is counted, and Box2D uses one thread
  for (const int side : {10, 30, 50}) compare("brick", brick_wall(side));
  for (const int rows : {14, 45}) compare("pyramid", pyramid(rows));
}
