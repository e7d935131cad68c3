// The reports of a run to its observer, their order, and the ends of a run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/run.hpp"

#include <gtest/gtest.h>

#include <string>

#include "base/context.hpp"
#include "run/checkpoint.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::run_test {
namespace {

using support::legacy_scene;
using support::plain_analysis;
using support::rectangle;

/// One measured point, so that there is one row per step.
Scene falling_block(int steps) {
  return legacy_scene({{rectangle({0, 10}, {1, 11})}, {}, {}, {}, {{{0, 10}, 0, {}}}, {}}, plain_analysis(1e-3, steps));
}

/// The calls an observer gets, as "frame 0 row 0 step 1 …".
struct Listener {
  Context own;
  std::string heard;
  int stop_after = -1;

  RunOutcome run(const Scene& scene, int record_every) {
    Observer observer;
    observer.on_frame = [&](const Frame& f) { heard += "frame " + std::to_string(f.step) + " "; };
    observer.on_row = [&](const HistoryRow& r) {
      heard += "row " + std::to_string(r.step) + " ";
      if (r.step == stop_after) own.stop();
    };
    observer.on_step = [&](const StepReport& s) { heard += "step " + std::to_string(s.step) + " "; };
    const Under under(own);
    return keyblock::run(scene, record_every, observer);
  }
};

}  // namespace

TEST(Run, tells_the_start_then_every_step_and_row_and_the_last_frame_once) {
  Listener listener;
  const RunOutcome outcome = listener.run(falling_block(3), 2);
  EXPECT_EQ(listener.heard, "frame 0 row 0 step 1 row 1 step 2 row 2 frame 2 step 3 row 3 frame 3 ");
  EXPECT_EQ(outcome.end, RunEnd::finished);
  EXPECT_EQ(outcome.steps, 3);
  EXPECT_NEAR(outcome.time, 3e-3, 1e-17);
  Listener even;
  even.run(falling_block(2), 2);
  EXPECT_EQ(even.heard, "frame 0 row 0 step 1 row 1 step 2 row 2 frame 2 ") << "the last frame is not shown twice";
}

TEST(Run, rows_come_with_the_frames_where_nothing_is_measured) {
  Scene scene = falling_block(3);
  scene.model.measured_points.clear();
  Listener listener;
  listener.run(scene, 2);
  EXPECT_EQ(listener.heard.find("row 1"), std::string::npos) << listener.heard;
  for (const char* row : {"row 0", "row 2", "row 3"})
    EXPECT_NE(listener.heard.find(row), std::string::npos) << listener.heard;
}

TEST(Run, stops_between_steps_when_asked_and_shows_where_it_stands) {
  Listener listener;
  listener.stop_after = 1;
  const RunOutcome outcome = listener.run(falling_block(5), 10);
  EXPECT_EQ(listener.heard, "frame 0 row 0 step 1 row 1 frame 1 ");
  EXPECT_EQ(outcome.end, RunEnd::stopped);
  EXPECT_EQ(outcome.steps, 1);
  EXPECT_TRUE(outcome.reason.empty());
  Listener at_once;
  at_once.stop_after = 0;
  EXPECT_EQ(at_once.run(falling_block(5), 1).steps, 0);
  EXPECT_EQ(at_once.heard, "frame 0 row 0 ");
}

TEST(Run, that_fails_says_why_and_has_shown_the_last_accepted_step) {
  Scene scene = falling_block(5);
  scene.settings.allowed_displacement_ratio = 1e-12;
  Listener listener;
  const RunOutcome outcome = listener.run(scene, 1);
  EXPECT_EQ(outcome.end, RunEnd::failed);
  EXPECT_NE(outcome.reason.find("smallest step"), std::string::npos) << outcome.reason;
  EXPECT_EQ(outcome.steps, 0);
  EXPECT_EQ(listener.heard, "frame 0 row 0 ");
}

TEST(Run, needs_no_observer) {
  EXPECT_EQ(run(falling_block(2), 1, {}).steps, 2);
}

TEST(Run, the_same_scene_gives_the_same_bits) {
  Analysis analysis = plain_analysis(1e-3, 20);
  analysis.joint_materials[0].friction_angle_deg = 20;
  const Scene scene =
      legacy_scene({{rectangle({-2, -1}, {3, 0}), rectangle({0, 0}, {1, 1})}, {}, {}, {}, {}, {}}, analysis);
  const auto places = [&] {
    std::vector<Point> points;
    Observer observer;
    observer.on_frame = [&](const Frame& f) {
      for (const ElementFrame& e : f.elements) points.insert(points.end(), e.loops[0].begin(), e.loops[0].end());
    };
    run(scene, 1, observer);
    return points;
  };
  EXPECT_EQ(places(), places());
}

/// One block at rest on a fixed one.
Scene resting_block(int steps) {
  return legacy_scene({{rectangle({0, 0}, {3, 1}), rectangle({1, 1}, {2, 2})},
                       {},
                       {{{0.1, 0.5}, 0, {}}, {{2.9, 0.5}, 0, {}}},
                       {},
                       {{{1.5, 2}, 1, {}}},
                       {}},
                      plain_analysis(1e-3, steps));
}

// The request is present when the third step begins, though nobody looks at it between the steps.
TEST(Run, stopped_within_a_step_ends_before_it_and_lets_its_state_be_saved) {
  for (const Dynamics dynamics : {Dynamics::shi, Dynamics::standard}) {
    Scene scene = resting_block(5);
    scene.settings.dynamics = dynamics;
    Archive at_third;
    Archive at_end;
    int looks = 0;
    const Context own;
    Observer observer;
    observer.between_steps = [&](Stepper& now) {
      if (now.state().step != 2) return;
      now.save(++looks == 1 ? at_third : at_end);
      own.stop();
    };
    const Under under(own);
    const RunOutcome outcome = run(scene, 1, observer);
    EXPECT_EQ(outcome.end, RunEnd::stopped);
    EXPECT_EQ(outcome.steps, 2);
    ASSERT_EQ(looks, 2) << "before the step, and where it was left";
    EXPECT_EQ(checkpoint_bytes(at_third), checkpoint_bytes(at_end));
  }
}

TEST(Run, stopped_in_the_search_for_its_start_tells_nothing) {
  Scene scene = resting_block(5);
  scene.settings.dynamics = Dynamics::standard;
  Listener listener;
  listener.own.stop();
  EXPECT_THROW(listener.run(scene, 1), StopRequested);
  EXPECT_EQ(listener.heard, "");
}

}  // namespace keyblock::run_test
