// Forces of contacts, as frames report them, balance weight and inertia of blocks, in both profiles.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/contact_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "formats/columns/contact_columns.hpp"
#include "formats/columns/joint_sums.hpp"
#include "run/prepare.hpp"
#include "run/run.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock::contact_frame_test {
namespace {

using support::plain_analysis;
using support::radians;
using support::rectangle;

constexpr double kStep = 1e-3;
constexpr double kDensity = 2500;
constexpr double kWeight = 24525;  // of the square metre

struct Told {
  std::vector<Frame> frames;
  std::vector<ContactFrames> contacts;
};

Told run_told(const Blocks& blocks, double friction_deg, int steps, const std::string& profile,
              const std::vector<Override>& overrides = {}) {
  Problem problem;
  problem.geometry = blocks;
  problem.analysis = plain_analysis(kStep, steps);
  problem.analysis->allowed_displacement_ratio = 0.01;  // `legacy` searches contacts within this distance
  problem.analysis->joint_materials[0].friction_angle_deg = friction_deg;
  const Prepared prepared = prepare(problem, profile, overrides);
  Told told;
  Observer observer;
  observer.on_frame = [&](const Frame& frame) { told.frames.push_back(frame); };
  observer.on_contacts = [&](const ContactFrames& contacts) { told.contacts.push_back(contacts); };
  const RunOutcome outcome = run(prepared.scene, 1, observer);
  EXPECT_EQ(outcome.end, RunEnd::finished) << outcome.reason;
  return told;
}

Point force_on(int element, const ContactFrames& contacts) {
  Point sum;
  for (const ContactFrame& contact : contacts) {
    if (contact.element == element) sum = sum + contact.force();
    if (contact.other == element) sum = sum - contact.force();
  }
  return sum;
}

/// Largest |m (v1 - v0) / dt - weight - contact forces| over the weight, from the second step on: in the first one
/// `legacy` closes its contacts. Its mass and weight are those of the area at the start of the step, as Shi has them;
/// `standard` keeps the mass.
double out_of_balance(const Told& told, const std::string& profile) {
  double greatest = 0;
  for (std::size_t i = 2; i < told.frames.size(); ++i)
    for (std::size_t e = 1; e < told.frames[i].elements.size(); ++e) {
      const ElementFrame& before = told.frames[i - 1].elements[e];
      const ElementFrame& now = told.frames[i].elements[e];
      const double area = profile == "legacy" ? before.area : 1;
      const double rate = 1 / (told.frames[i].time - told.frames[i - 1].time);
      const Point acceleration = rate * Point{now.velocity.x - before.velocity.x, now.velocity.y - before.velocity.y};
      const Point left =
          area * (kDensity * acceleration - Point{0, -kWeight}) - force_on(static_cast<int>(e), told.contacts[i]);
      greatest = std::max(greatest, length(left) / kWeight);
    }
  return greatest;
}

/// A fixed floor and squares on each other.
Blocks stack(int count) {
  Blocks scene;
  scene.blocks = {rectangle({-2, -1}, {3, 0})};
  for (int i = 0; i < count; ++i) scene.blocks.push_back(rectangle({0, double(i)}, {1, double(i + 1)}));
  scene.fixed_points = {{{-1, -0.5}, 0, {}}, {{2, -0.5}, 0, {}}};
  return scene;
}

/// Two blocks on a slope, the upper one on the lower.
Blocks pair_on_slope(double slope) {
  Blocks scene = support::block_on_slope(slope);
  scene.blocks.push_back(support::turned_rectangle({1, 1}, {2, 2}, -slope));
  return scene;
}

}  // namespace

TEST(ContactFrame, forces_on_a_block_are_its_weight_and_inertia) {
  const double slope = radians(30);
  struct Choice {
    std::string profile;
    std::vector<Override> overrides;
  };
  const std::vector<Choice> choices{
      {"legacy", {}}, {"standard", {{"enforcement", "penalty"}}}, {"standard", {{"enforcement", "lagrange"}}}};
  for (const auto& [profile, overrides] : choices) {
    const std::string name = profile + (overrides.empty() ? "" : " " + overrides[0].second);
    EXPECT_LT(out_of_balance(run_told(stack(3), 30, 50, profile, overrides), profile), 1e-9) << name << ", at rest";
    EXPECT_LT(out_of_balance(run_told(pair_on_slope(slope), 15, 50, profile, overrides), profile), 1e-9)
        << name << ", sliding";
  }
}

TEST(ContactFrame, a_joint_bears_what_stands_above_it) {
  for (const char* motion : {"dynamic", "static"}) {
    const Told told = run_told(stack(3), 30, 5, "standard", {{"motion", motion}});
    const auto sums = formats::joint_sums(formats::contact_part(told.contacts.back()), formats::JointsBy::bodies);
    ASSERT_EQ(sums.size(), 3U);
    for (int i = 0; i < 3; ++i) {
      const formats::JointSum& sum = sums[static_cast<std::size_t>(i)];
      EXPECT_EQ(sum.block, i + 1);
      EXPECT_EQ(sum.other, i + 2);
      EXPECT_EQ(sum.closed, 2);
      EXPECT_NEAR(sum.normal_force / ((3 - i) * kWeight), 1, 1e-9) << motion;
      EXPECT_NEAR(sum.force.y / ((3 - i) * kWeight), -1, 1e-9) << motion << ": pressed down by the blocks above";
      EXPECT_NEAR(sum.shear_force / kWeight, 0, 1e-9) << motion;
    }
  }
}

TEST(ContactFrame, a_block_that_slides_says_so_and_how_far) {
  const double slope = radians(30);
  for (const char* profile : {"legacy", "standard"}) {
    const Told told = run_told(support::block_on_slope(slope), 15, 100, profile);
    const Point moved = told.frames.back().elements[1].displacement;
    int closed = 0;
    for (const ContactFrame& contact : told.contacts.back()) {
      if (contact.condition == ContactCondition::open) continue;
      ++closed;
      EXPECT_EQ(contact.condition, ContactCondition::slide) << profile;
      EXPECT_NEAR(std::abs(contact.slip), length(moved), 1e-5) << profile << ": elastic strain aside";
      EXPECT_NEAR(std::abs(contact.shear_force), std::tan(radians(15)) * contact.normal_force, 1e-3 * kWeight)
          << profile << ": Coulomb";
      EXPECT_LT(contact.shear_force * contact.slip, 0) << profile << ": against the slip";
    }
    EXPECT_EQ(closed, 2) << profile;
  }
}

}  // namespace keyblock::contact_frame_test
