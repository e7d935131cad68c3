// Histories of a run: words of the command line, resultants across lines of blocks compared with weight and inertia,
// and contacts that know their joint of the drawing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

#include "formats/columns/contact_columns.hpp"
#include "formats/columns/joint_sums.hpp"
#include "run/follow/drawn_joints.hpp"
#include "run/follow/followed.hpp"
#include "run/follow/history_option.hpp"
#include "run/follow/resultant.hpp"
#include "run/prepare.hpp"
#include "run/record.hpp"
#include "run/run.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock::histories_test {
namespace {

using support::plain_analysis;
using support::radians;
using support::rectangle;
using support::turned_rectangle;

constexpr double kStep = 1e-3;
constexpr double kDensity = 2500;
constexpr double kWeight = 24525;  // of the square metre

std::string refusal(const std::string& text) {
  try {
    history_of(text);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

Prepared prepared(const Blocks& blocks, double friction_deg, int steps, const std::string& profile,
                  const std::vector<Override>& overrides = {}) {
  Problem problem;
  problem.geometry = blocks;
  problem.analysis = plain_analysis(kStep, steps);
  problem.analysis->allowed_displacement_ratio = 0.01;
  problem.analysis->joint_materials[0].friction_angle_deg = friction_deg;
  return prepare(problem, profile, overrides);
}

/// Largest distance, over the weight of a block, of the resultant across `line` from m a - W of the blocks `above`. All
/// steps count except the first, in which `legacy` closes its contacts.
double misfit(const Prepared& scene, const Segment& line, const std::vector<std::size_t>& above, bool is_legacy) {
  double greatest = 0;
  int checked = 0;
  Frame before;
  Observer observer;
  observer.on_state = [&](const Stepper& stepper) {
    Frame now = frame_of(stepper.model(), stepper.state(), stepper.unloaded(), stepper.settings());
    if (now.step >= 2) {
      Point wanted;
      for (const std::size_t e : above) {
        const Velocity v0 = before.elements[e].velocity, v1 = now.elements[e].velocity;
        const double rate = 1 / (now.time - before.time);
        const double area = is_legacy ? before.elements[e].area : 1;  // Shi's mass and weight follow the area
        wanted = wanted + area * (kDensity * rate * Point{v1.x - v0.x, v1.y - v0.y} - Point{0, -kWeight});
      }
      const LineResultant found = resultant_across(line, stepper, stepper.contacts());
      greatest = std::max(greatest, length(found.force - wanted) / kWeight);
      ++checked;
    }
    before = std::move(now);
  };
  const RunOutcome outcome = run(scene.scene, 1, observer);
  EXPECT_EQ(outcome.end, RunEnd::finished) << outcome.reason;
  EXPECT_GT(checked, 10);
  return greatest;
}

/// Courses of two squares each on a fixed floor.
Blocks wall(int courses) {
  Blocks scene;
  scene.blocks = {rectangle({-2, -1}, {4, 0})};
  for (int i = 0; i < courses; ++i)
    for (int k = 0; k < 2; ++k)
      scene.blocks.push_back(rectangle({double(k), double(i)}, {double(k + 1), double(i + 1)}));
  scene.fixed_points = {{{-1, -0.5}, 0, {}}, {{3, -0.5}, 0, {}}};
  return scene;
}

}  // namespace

// A toe or a free face is where histories are asked for; turned corners and points differ by their last digits.
TEST(Histories, a_point_on_the_outline_of_a_turned_block_belongs_to_it) {
  int on_edge = 0;
  for (int degrees = 0; degrees < 90; ++degrees) {
    const auto turned = [&](Point p) {
      const double a = radians(degrees);
      return Point{100 + std::cos(a) * p.x - std::sin(a) * p.y, std::sin(a) * p.x + std::cos(a) * p.y};
    };
    Blocks blocks;
    blocks.blocks = {rectangle({0, 0}, {4, 1})};
    for (BlockVertex& corner : blocks.blocks[0].outer) corner.position = turned(corner.position);
    for (const double x : {0.3, 1.7, 3.5}) {
      Problem problem;
      problem.geometry = blocks;
      problem.outputs.histories = {history_of("point:0,0")};
      problem.outputs.histories[0].point = turned({x, 0});
      ASSERT_NO_THROW(problem = with_followed_points(problem)) << degrees << " " << x;
      on_edge += static_cast<int>(std::get<Blocks>(problem.geometry).measured_points.size());
      problem.outputs.histories[0].point = turned({x, -1e-6});
      EXPECT_THROW(with_followed_points(problem), InputError) << degrees << " " << x;
    }
  }
  EXPECT_EQ(on_edge, 270);
}

TEST(Histories, words_of_the_command_line_say_what_is_followed) {
  const HistoryPlan point = history_of("crest=point:1.5,-2e1");
  EXPECT_EQ(point.name, "crest");
  EXPECT_EQ(point.point, (Point{1.5, -20}));
  EXPECT_EQ(history_of("block:12").block, 11);
  EXPECT_EQ(history_of("contact:3,7").contact, (BlockPair{2, 6}));
  EXPECT_EQ(history_of("joint:1").joint, 0);
  EXPECT_EQ(history_of("cut=line:0,1,4,1").line, (Segment{{0, 1}, {4, 1}}));
}

TEST(Histories, words_that_say_nothing_are_told_the_forms_and_the_nearest) {
  EXPECT_NE(refusal("piont:1,2").find("did you mean \"point\"?"), std::string::npos) << refusal("piont:1,2");
  for (const char* text : {"", "12", "block:0", "block:1.5", "point:1", "contact:1,2,3", "line:0,0,0,0", "point:1,x",
                           "joint:-1", "block:", "point:1,2,"})
    EXPECT_NE(refusal(text).find("expected point:X,Y"), std::string::npos) << text;
}

TEST(Histories, resultant_across_a_line_is_weight_and_inertia_of_what_is_above) {
  const Segment between_courses{{-1, 1}, {3, 1}};
  EXPECT_LT(misfit(prepared(wall(3), 30, 30, "standard"), between_courses, {3, 4, 5, 6}, false), 1e-7)
      << "at rest: velocity that closing contacts lose is an impulse beside their forces";
  EXPECT_LT(misfit(prepared(wall(3), 30, 30, "legacy"), between_courses, {3, 4, 5, 6}, true), 1e-9);
  const double slope = radians(30);
  Blocks pair = support::block_on_slope(slope);
  pair.blocks.push_back(turned_rectangle({1, 1}, {2, 2}, -slope));
  const auto across = [&](double height) {
    return Segment{turned(Point{0, height}, -slope), turned(Point{20, height}, -slope)};
  };
  for (const auto& [profile, is_legacy] : {std::pair("standard", false), std::pair("legacy", true)}) {
    EXPECT_LT(misfit(prepared(pair, 15, 50, profile), across(1), {2}, is_legacy), 1e-9) << profile << ", sliding";
    EXPECT_LT(misfit(prepared(pair, 15, 50, profile), across(0), {1, 2}, is_legacy), 1e-9) << profile << ", both";
  }
}

// Half of the wall is on half of the line; a reversed line has the opposite force.
TEST(Histories, a_line_takes_what_lies_between_its_ends_and_acts_on_its_left) {
  const Prepared scene = prepared(wall(3), 30, 5, "standard");
  Observer observer;
  LineResultant all, half, back;
  observer.on_state = [&](const Stepper& stepper) {
    const ContactFrames contacts = stepper.contacts();
    all = resultant_across({{-1, 1}, {3, 1}}, stepper, contacts);
    half = resultant_across({{-1, 1}, {0.99, 1}}, stepper, contacts);
    back = resultant_across({{3, 1}, {-1, 1}}, stepper, contacts);
  };
  run(scene.scene, 1, observer);
  EXPECT_NEAR(all.force.y / (4 * kWeight), 1, 1e-8);
  EXPECT_NEAR(back.force.y / (-4 * kWeight), 1, 1e-8);
  EXPECT_NEAR(all.moment / kWeight, 0, 1e-6) << "about its middle, which is below the wall";
  EXPECT_GT(all.closed, half.closed);
  EXPECT_GT(half.force.y, 0);
}

TEST(Histories, contacts_know_the_joint_of_the_drawing_in_both_profiles) {
  Problem problem;
  Drawing drawing;
  const std::vector<Point> outline{{0, 0}, {2, 0}, {2, 3}, {0, 3}};
  for (std::size_t i = 0; i < 4; ++i) drawing.joints.push_back({{outline[i], outline[(i + 1) % 4]}, 0, {}});
  drawing.boundary_count = 4;
  drawing.joints.push_back({{{0, 2}, {2, 2}}, 1, {}});
  drawing.joints.push_back({{{2, 1}, {0, 1}}, 0, {}});
  for (const double x : {0.5, 1.5}) drawing.fixed_lines.push_back({{{x, 0.5}, {x, 0.5}}, {}});
  problem.geometry = drawing;
  problem.analysis = plain_analysis(kStep, 3);
  problem.analysis->allowed_displacement_ratio = 0.01;
  problem.analysis->joint_materials.resize(2, problem.analysis->joint_materials[0]);
  for (const char* profile : {"legacy", "standard"}) {
    const Prepared scene = prepare(problem, profile, {});
    const DrawnJoints joints(scene.scene.model, scene.joint_lines);
    EXPECT_TRUE(joints.has(0)) << "the outline is of the drawing too";
    EXPECT_FALSE(joints.has(6));
    ContactFrames contacts;
    Observer observer;
    observer.on_state = [&](const Stepper& stepper) {
      contacts = stepper.contacts();
      joints.name(contacts, stepper.model());
    };
    run(scene.scene, 1, observer);
    ASSERT_FALSE(contacts.empty()) << profile;
    std::set<int> met;
    for (const ContactFrame& contact : contacts) {
      met.insert(contact.joint_line);
      EXPECT_EQ(contact.joint_line, contact.position.y > 1.5 ? 4 : 5) << profile;
      EXPECT_EQ(contact.joint_material, contact.position.y > 1.5 ? 1 : 0) << profile;
    }
    EXPECT_EQ(met, (std::set<int>{4, 5})) << profile;
    if (std::string(profile) == "legacy") continue;  // springs still oscillate after three steps
    const auto sums = formats::joint_sums(formats::contact_part(contacts), formats::JointsBy::line);
    ASSERT_EQ(sums.size(), 2U);
    EXPECT_NEAR(sums[0].normal_force / (2 * kWeight), 1, 0.05) << "two square metres are on the upper joint";
    EXPECT_NEAR(sums[1].normal_force / (4 * kWeight), 1, 0.05) << profile;
  }
}

TEST(Histories, what_is_not_there_is_refused_by_name) {
  const auto refused = [](const HistoryPlan& plan) -> std::string {
    const Prepared scene = prepared(wall(1), 30, 1, "standard");
    const DrawnJoints joints(scene.scene.model, scene.joint_lines);
    try {
      Followed({plan}, scene.scene, joints, {});
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_NE(refused(history_of("block:4")).find("1 to 3, found 4"), std::string::npos)
      << refused(history_of("block:4"));
  EXPECT_NE(refused(history_of("joint:1")).find("expected blocks cut from a drawing"), std::string::npos);
  EXPECT_NE(refused(history_of("point:0.5,9")).find("found 0.5, 9 in none"), std::string::npos);
  EXPECT_EQ(refused(history_of("contact:1,3")), "");
}

// Stiffness relates force and elongation; the length is that between the ends of the frame.
TEST(Histories, a_bolt_is_followed_by_its_force_and_elongation) {
  Blocks scene;
  scene.blocks = {rectangle({-2, -1}, {4, 0}), rectangle({0, 0}, {2, 1})};
  scene.fixed_points = {{{-1, -0.5}, 0, {}}, {{3, -0.5}, 0, {}}};
  scene.bolts = {{{{-1, -0.2}, {-1.5, -0.2}}, 0, 0, 0, 0, 0, {}},
                 {{{1, -0.5}, {1, 0.5}}, 0, 1, 2e6, 0, 5000, {}, std::string("crown, left")}};
  const Prepared made = prepared(scene, 30, 30, "standard");
  Followed followed({history_of("bolt:2"), history_of("mine=bolt:2")}, made.scene, {}, {});
  std::map<std::string, double> values;
  double length_at_end = 0;
  Observer observer;
  observer.on_state = [&](const Stepper& stepper) {
    const BoltState& bolt = stepper.state().bolts[1];
    length_at_end = distance(bolt.first, bolt.second);
    const std::vector<FollowedValue> now = followed.values(stepper, {});
    for (const FollowedValue& one : now) {
      EXPECT_EQ(one.what, "bolt");
      values[one.name + " " + one.quantity] = one.value;
    }
    EXPECT_TRUE(history_lines(now, 3, 0.5).starts_with("3,0.5,bolt,\"crown, left\",force,"));
  };
  EXPECT_EQ(run(made.scene, 1, observer).reason, "");
  ASSERT_EQ(values.size(), 6U);
  EXPECT_NE(length_at_end, 1);
  EXPECT_NEAR(values["crown, left elongation"], length_at_end - 1, 1e-15);
  EXPECT_NEAR(values["crown, left force"], 5000 + 2e6 * (length_at_end - 1), 1e-6);
  EXPECT_EQ(values["crown, left is_broken"], 0);
  EXPECT_EQ(values["mine force"], values["crown, left force"]);
}

TEST(Histories, a_bolt_that_is_not_there_is_refused) {
  Blocks scene = wall(1);
  const auto refused = [&] {
    try {
      Followed({history_of("bolt:3")}, prepared(scene, 30, 1, "standard").scene, {}, {});
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refused().find("expected a bolt in a scene with a history of one, found none"), std::string::npos);
  scene.bolts = {{{{0.5, -0.5}, {0.5, 0.5}}, 0, 1, 1, 0, 0, {}}};
  EXPECT_NE(refused().find("expected the number of a bolt in a history, 1 to 1, found 3"), std::string::npos);
}

}  // namespace keyblock::histories_test
