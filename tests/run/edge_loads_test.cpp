// Tractions, pressures and rollers on edges of blocks, beside closed forms of uniform stress; moved, turned and in mm.
#include "run/bodies/edge_loads.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "tests/support/stepped_case.hpp"

namespace keyblock::edge_loads_test {
namespace {

using support::fault_of;
using support::own_file;
using support::stepper_of;

constexpr double kModulus = 1e9, kPoisson = 0.25;

/// Turns and moves the coordinates of a case; `unit`: lengths of the file per metre.
struct Frame {
  double angle = 0;
  Point origin = {};
  double unit = 1;

  Point vector(Point p) const {
    return {std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y};
  }
  Point at(Point p) const { return unit * (vector(p) + origin); }
  std::string row(Point p) const { return fmt::format("[{:.17g}, {:.17g}]", at(p).x, at(p).y); }
  std::string chain(Point a, Point b) const { return fmt::format(R"("along": [{}, {}])", row(a), row(b)); }
};

std::string block(const Frame& frame, Point low, Point high) {
  std::string rows;
  for (const Point p : {low, Point{high.x, low.y}, high, Point{low.x, high.y}})
    rows += fmt::format("{}[{:.17g}, {:.17g}, 1]", rows.empty() ? "" : ", ", frame.at(p).x, frame.at(p).y);
  return fmt::format(R"({{"outer": [{}]}})", rows);
}

/// Units: mass in kg, lengths by the frame; a plain number of stress or density follows from those in metres.
std::string case_of(const Frame& frame, const std::string& blocks, const std::string& loads, const std::string& run,
                    double gravity = 0) {
  const double per_length = frame.unit;
  return fmt::format(
      R"({{"keyblock": 2, "blocks": {{"blocks": [{}]}}, "loads": {{{}}}, "analysis": {{"step_count": 1,
      "time_step": 0.01, "velocity_carry_over": 0, "plane_strain": true, "gravity": {},
      "joint_materials": [{{"friction_angle_deg": 30}}],
      "block_materials": [{{"density": {}, "youngs_modulus": {}, "poissons_ratio": {}}}]}},
      "run": {{"set": {{{}}}}}}})",
      blocks, loads, gravity * per_length, 2000 / std::pow(per_length, 3), kModulus / per_length, kPoisson, run);
}

std::unique_ptr<Stepper> after_one_step(const std::string& text) {
  std::unique_ptr<Stepper> stepper = stepper_of(text);
  const auto made = stepper->advance();
  if (const auto* failure = std::get_if<StepFailure>(&made)) ADD_FAILURE() << failure->reason;
  return stepper;
}

/// Stress components along the axes of the frame, in units of metres.
Stress stress_of(const Stepper& stepper, int element, const Frame& frame) {
  const Stress s = stepper.state().elements[ElementIndex{element}].stress;
  const Point x = frame.vector({1, 0}), y = frame.vector({0, 1});
  const auto of = [&](Point a, Point b) {
    return frame.unit * (a.x * (s.xx * b.x + s.xy * b.y) + a.y * (s.xy * b.x + s.yy * b.y));
  };
  return {of(x, x), of(y, y), of(x, y)};
}

const std::vector<Frame> kFrames{{}, {0, {1e4, -3e3}, 1}, {0.7, {2, 5}, 1}, {0, {}, 1000}, {-2.1, {30, 40}, 1000}};
constexpr const char* kStatics = R"("motion": "static")";

// The edge keeps its length, so that the block is pressed sideways by ν/(1 - ν) of its mean weight, 10 kPa.
TEST(EdgeLoads, a_block_that_stands_on_a_held_edge_starts_in_equilibrium) {
  for (const Frame& frame : kFrames) {
    const Point down = frame.vector({0, -10 * frame.unit});
    const std::string loads = fmt::format(R"("displacements": [{{{}, "held": "both"}}])", frame.chain({0, 0}, {2, 0}));
    const std::string run =
        fmt::format(R"("motion": "dynamic", "gravity.x": {:.17g}, "gravity.y": {:.17g})", down.x, down.y);
    std::unique_ptr<Stepper> stepper = stepper_of(case_of(frame, block(frame, {0, 0}, {2, 1}), loads, run));
    for (int step = 0; step < 2; ++step) {
      const Stress s = stress_of(*stepper, 0, frame);
      EXPECT_NEAR(s.yy, -1e4, 1e-3);
      EXPECT_NEAR(s.xx, -1e4 * kPoisson / (1 - kPoisson), 1e-3);
      EXPECT_NEAR(s.xy, 0, 1e-3);
      if (step == 0) stepper->advance();
    }
  }
}

// Friction and held edges share the load in more ways than one: dynamics begins with the one of statics, in all frames.
TEST(EdgeLoads, a_column_on_a_block_between_rollers_starts_as_in_statics_in_all_frames) {
  for (const Frame& frame : kFrames) {
    const std::string blocks = block(frame, {-2, -2}, {4, 0}) + ", " + block(frame, {0, 0}, {2, 1}) + ", " +
                               block(frame, {0, 1}, {2, 2}) + ", " + block(frame, {0, 2}, {2, 3});
    const std::string loads =
        fmt::format(R"("displacements": [{{{}, "held": "both"}}, {{{}, "held": "normal"}}, {{{}, "held": "normal"}}])",
                    frame.chain({-2, -2}, {4, -2}), frame.chain({-2, 0}, {-2, -2}), frame.chain({4, -2}, {4, 0}));
    const Point down = frame.vector({0, -10 * frame.unit});
    const auto run = [&](const char* motion) {
      return case_of(
          frame, blocks, loads,
          fmt::format(R"("motion": "{}", "gravity.x": {:.17g}, "gravity.y": {:.17g})", motion, down.x, down.y));
    };
    const auto rest = after_one_step(run("static"));
    const auto moves = stepper_of(run("dynamic"));
    for (int i = 0; i < 4; ++i) {
      const Stress exact = stress_of(*rest, i, frame), found = stress_of(*moves, i, frame);
      EXPECT_NEAR(found.xx, exact.xx, 5) << i;  // of 40 kPa
      EXPECT_NEAR(found.yy, exact.yy, 5) << i;
      EXPECT_NEAR(found.xy, exact.xy, 5) << i;
    }
  }
}

TEST(EdgeLoads, a_bar_under_end_traction_has_its_stress_and_stretch) {
  constexpr double kTraction = 2e5, kLength = 4;
  for (const Frame& frame : kFrames) {
    const Point t = (kTraction / frame.unit) * frame.vector({1, 0});
    const std::string text = case_of(frame, block(frame, {0, 0}, {kLength, 1}),
                                     fmt::format(R"("tractions": [{{{}, "x": {:.17g}, "y": {:.17g}}}],
          "displacements": [{{{}, "held": "normal"}}, {{{}, "held": "normal"}}])",
                                                 frame.chain({kLength, 0}, {kLength, 1}), t.x, t.y,
                                                 frame.chain({0, 0}, {0, 1}), frame.chain({0, 0}, {kLength, 0})),
                                     kStatics);
    const auto stepper = after_one_step(text);
    const Stress stress = stress_of(*stepper, 0, frame);
    EXPECT_NEAR(stress.xx, kTraction,
                1e-3 * kTraction);  // large strain: first order in t/E = 2e-4
    EXPECT_NEAR(stress.yy, 0, 1e-6 * kTraction);
    EXPECT_NEAR(stress.xy, 0, 1e-6 * kTraction);
    const Point moved =
        (1 / frame.unit) * (stepper->state().elements[ElementIndex{0}].centroid - frame.at({kLength / 2, 0.5}));
    const double strain = kTraction * (1 - kPoisson * kPoisson) / kModulus;
    const double across = -kTraction * kPoisson * (1 + kPoisson) / kModulus;
    EXPECT_NEAR(dot(moved, frame.vector({1, 0})), strain * kLength / 2, 1e-3 * strain);
    EXPECT_NEAR(dot(moved, frame.vector({0, 1})), across / 2, 1e-3 * strain);
  }
}

TEST(EdgeLoads, a_column_between_rollers_keeps_its_width_under_its_weight) {
  constexpr double kGravity = 10, kHeight = 2, kDensity = 2000;
  constexpr int kBlocks = 3;
  for (const Frame& frame : {kFrames[0], kFrames[1], kFrames[3]}) {
    std::string blocks;
    for (int i = 0; i < kBlocks; ++i)
      blocks += (i == 0 ? "" : ", ") + block(frame, {0, i * kHeight}, {1, (i + 1) * kHeight});
    const double top = kBlocks * kHeight;
    const std::string text =
        case_of(frame, blocks,
                fmt::format(R"("displacements": [{{{}, "held": "normal"}}, {{{}, "held": "x"}}, {{{}, "held": "y"}}])",
                            frame.chain({0, top}, {0, 0}), frame.chain({1, 0}, {1, top}), frame.chain({0, 0}, {1, 0})),
                kStatics, kGravity);
    const auto stepper = after_one_step(text);
    for (int i = 0; i < kBlocks; ++i) {
      const double vertical = -kDensity * kGravity * (top - (i + 0.5) * kHeight);
      const Stress stress = stress_of(*stepper, i, frame);
      EXPECT_NEAR(stress.yy, vertical, 1e-3 * std::abs(vertical)) << i;
      EXPECT_NEAR(stress.xx, kPoisson / (1 - kPoisson) * vertical, 1e-3 * std::abs(vertical)) << i;
      EXPECT_NEAR(stepper->state().elements[ElementIndex{i}].centroid.x, frame.at({0.5, 0}).x, 1e-9 * frame.unit);
    }
  }
}

TEST(EdgeLoads, equal_pressure_all_around_moves_no_block_and_turns_with_it) {
  constexpr double kPressure = 1e5;
  const Frame frame;
  std::string loads;
  const std::vector<Point> corners{{0, 0}, {3, 0}, {3, 1}, {0, 1}};
  for (std::size_t i = 0; i < 4; ++i)
    loads += fmt::format(R"({}{{{}, "pressure": {}}})", i == 0 ? "" : ", ",
                         frame.chain(corners[i], corners[(i + 1) % 4]), kPressure);
  std::string text =
      case_of(frame, block(frame, {0, 0}, {3, 1}), R"("tractions": [)" + loads + "]", R"("start": "sudden")");
  const auto set = [&](const std::string& was, const std::string& is) { text.replace(text.find(was), was.size(), is); };
  set(R"("velocity_carry_over": 0)", R"("velocity_carry_over": 1)");
  set(R"("density")", R"("initial_velocity": [0, 0, 2], "density")");
  set(R"("step_count": 1)", R"("step_count": 60)");
  const auto stepper = stepper_of(text);
  for (int i = 0; i < 60; ++i) ASSERT_TRUE(std::holds_alternative<StepReport>(stepper->advance()));
  const ElementState& end = stepper->state().elements[ElementIndex{0}];
  EXPECT_NEAR(end.rotation, 2 * 0.6, 1e-3);
  EXPECT_NEAR(end.centroid.x, 1.5, 1e-9);
  EXPECT_NEAR(end.centroid.y, 0.5, 1e-9);
  const double along = 2000 * 4 * 9 / 12.0, across = 2000 * 4 * 1 / 12.0;  // of the spin, ρ ω² L²/12
  const double c = std::cos(end.rotation), d = std::sin(end.rotation);
  EXPECT_NEAR(end.stress.xx, -kPressure + c * c * along + d * d * across, 1e-3 * kPressure);
  EXPECT_NEAR(end.stress.yy, -kPressure + d * d * along + c * c * across, 1e-3 * kPressure);
  EXPECT_NEAR(end.stress.xy, c * d * (along - across), 1e-3 * kPressure);
}

TEST(EdgeLoads, a_water_level_within_an_edge_gives_the_force_and_moment_of_a_triangle) {
  const Frame frame;
  const std::string text =
      case_of(frame, block(frame, {0, 0}, {2, 10}),
              R"("tractions": [{"along": [[0, 10], [0, 0]], "pressure": "y < 7.3 ? 10 * (7.3 - y) : 0"}])", kStatics);
  const std::string file = own_file();
  support::write_text(file, text);
  const Prepared prepared = prepare(formats::load_case({file}).problem, "standard", {});
  ASSERT_EQ(prepared.scene.model.edge_loads.size(), 1U);
  EXPECT_EQ(prepared.scene.model.edge_loads.front().edge.start.y, 10);
  const EdgeForces load = prepared.scene.model.edge_loads.front().at(0);
  const double length = 10, force = 10 * 7.3 * 7.3 / 2;
  EXPECT_NEAR((load.pushes[0] + load.pushes[1]) * length, force, 1e-3 * force);
  EXPECT_NEAR(load.pushes[0] * length * 10, force * 7.3 / 3,
              1e-3 * force);  // about the foot
}

TEST(EdgeLoads, an_edge_follows_its_table_of_factors) {
  const Frame frame;
  constexpr double kLength = 4, kStretch = 0.004;
  std::string text =
      case_of(frame, block(frame, {0, 0}, {kLength, 1}),
              R"("displacements": [{"along": [[0, 0], [0, 1]], "held": "x"}, {"along": [[0, 0], [4, 0]], "held": "y"},
         {"along": [[4, 0], [4, 1]], "held": "x", "x": 0.004, "over_time": [[0, 0], [0.04, 1]]}])",
              kStatics);
  text.replace(text.find(R"("step_count": 1)"), 15, R"("step_count": 4)");
  const auto stepper = stepper_of(text);
  for (const double factor : {0.25, 0.5, 0.75, 1.0}) {
    const auto made = stepper->advance();
    ASSERT_TRUE(std::holds_alternative<StepReport>(made)) << std::get<StepFailure>(made).reason;
    const double stress = kModulus / (1 - kPoisson * kPoisson) * factor * kStretch / kLength;
    EXPECT_NEAR(stress_of(*stepper, 0, frame).xx, stress, 2e-3 * stress);  // first order in the strain, 1e-3
    EXPECT_NEAR(stepper->state().elements[ElementIndex{0}].centroid.x, (kLength + factor * kStretch) / 2, 1e-9);
  }
}

// Between an edge that is held and one that is driven, and then stops: E/(1 - ν²) times the strain, and no energy from
// nothing by the pushes of the supports.
TEST(EdgeLoads, a_block_without_weight_is_pressed_and_stays_so) {
  for (const Frame& frame : kFrames) {
    std::string text =
        case_of(frame, block(frame, {0, 0}, {2, 1}),
                fmt::format(R"("displacements": [{{{}, "held": "normal"}}, {{{}, "held": "normal", "normal": {},
                    "over_time": [[0, 0], [0.1, 1], [1, 1]]}}])",
                            frame.chain({0, 0}, {2, 0}), frame.chain({2, 1}, {0, 1}), -1e-4 * frame.unit),
                "");
    text.replace(text.find(R"("velocity_carry_over": 0)"), 24, R"("velocity_carry_over": 1)");
    text.replace(text.find(R"("step_count": 1)"), 15, R"("step_count": 20)");
    const auto stepper = stepper_of(text);
    double largest = 0;
    for (int step = 1; step <= 20; ++step) {
      const auto made = stepper->advance();
      ASSERT_TRUE(std::holds_alternative<StepReport>(made)) << step << std::get<StepFailure>(made).reason;
      largest = std::max(largest, stepper->ledger().stored.strain);
    }
    const double stress = kModulus / (1 - kPoisson * kPoisson) * -1e-4;
    EXPECT_NEAR(stress_of(*stepper, 0, frame).yy, stress, 1e-3 * -stress);
    EXPECT_NEAR(stepper->ledger().flow.clean_up, 0, 1e-3 * largest);
  }
}

// Rock in balance with its initial stress between held edges: the forces of both cancel.
TEST(EdgeLoads, an_initial_stress_between_held_edges_needs_no_weight) {
  const std::string text =
      R"({"keyblock": 2, "blocks": {"blocks": [{"outer": [[0, 0, 1], [4, 0, 1], [4, 2, 1], [0, 2, 1]]}]},
      "covers": {"functions": "quadratic", "mesh": {"side": 0.7}, "displacements": [{"along": [[0, 0], [4, 0]]},
      {"along": [[4, 0], [4, 2]]}, {"along": [[4, 2], [0, 2]]}, {"along": [[0, 2], [0, 0]]}]},
      "analysis": {"step_count": 1, "time_step": 1, "velocity_carry_over": 0, "gravity": 0, "plane_strain": true,
      "block_materials": [{"density": 2000, "youngs_modulus": 1e9, "poissons_ratio": 0.2,
      "initial_stress": [-1e6, -2e6, 0]}], "joint_materials": [{}]}})";
  const auto stepper = after_one_step(text);
  for (int element : {0, 1}) {
    EXPECT_NEAR(stress_of(*stepper, element, {}).xx, -1e6, 1);
    EXPECT_NEAR(stress_of(*stepper, element, {}).yy, -2e6, 1);
  }
}

TEST(EdgeLoads, statics_lets_the_strain_go_once_the_last_load_is_gone) {
  const std::string text = case_of({}, block({}, {0, 0}, {2, 3}),
                                   R"("tractions": [{"along": [[0, 3], [2, 3]], "pressure": 2e5,
                                                     "over_time": [[0, 0], [0.02, 1], [0.04, 0], [1, 0]]}],
          "displacements": [{"along": [[0, 0], [2, 0]], "held": "normal"},
                            {"along": [[0, 3], [0, 0]], "held": "normal"}])",
                                   kStatics);
  const auto stepper = stepper_of(text);
  for (const double stress : {-1e5, -2e5, -1e5, 0.0, 0.0}) {
    const auto made = stepper->advance();
    ASSERT_TRUE(std::holds_alternative<StepReport>(made)) << std::get<StepFailure>(made).reason;
    EXPECT_NEAR(stress_of(*stepper, 0, {}).yy, stress, 1e3);
  }
}

TEST(EdgeLoads, a_pressure_follows_its_table_of_factors) {
  const Frame frame;
  std::string text =
      case_of(frame, block(frame, {0, 0}, {4, 1}),
              R"("displacements": [{"along": [[0, 0], [0, 1]], "held": "x"}, {"along": [[0, 0], [4, 0]], "held": "y"}],
         "tractions": [{"along": [[4, 0], [4, 1]], "pressure": 1e5, "over_time": [[0.01, 1], [0.02, 3]]}])",
              kStatics);
  text.replace(text.find(R"("step_count": 1)"), 15, R"("step_count": 3)");
  const auto stepper = stepper_of(text);
  for (const double stress : {-1e5, -3e5, -3e5}) {
    ASSERT_TRUE(std::holds_alternative<StepReport>(stepper->advance()));
    EXPECT_NEAR(stress_of(*stepper, 0, frame).xx, stress, 1e-3 * std::abs(stress));
  }
}

// A free block of mass m, pushed along x on the area A of its left side.
struct Pushed {
  double mass = 2000 * 2 * 1, area = 1;

  static std::string text(const std::string& load, const std::string& stages) {
    std::string text = case_of({}, block({}, {0, 0}, {2, 1}),
                               R"("tractions": [{"along": [[0, 1], [0, 0]], )" + load + "}]", R"("start": "sudden")");
    text.replace(text.find(R"("velocity_carry_over": 0)"), 24, R"("velocity_carry_over": 1)");
    text.replace(text.find(R"("step_count": 1)"), 15, R"("step_count": 20)");
    return stages.empty() ? text : text.substr(0, text.rfind('}')) + R"(, "stages": [)" + stages + "]}";
  }
  /// Returns the velocity after each of 20 steps of 10 ms.
  static std::vector<double> velocities(const std::string& load, const std::string& stages = {}) {
    const auto stepper = stepper_of(text(load, stages));
    std::vector<double> v;
    for (int i = 0; i < 20; ++i) {
      const auto made = stepper->advance();
      if (const auto* failure = std::get_if<StepFailure>(&made)) ADD_FAILURE() << failure->reason;
      v.push_back(stepper->state().elements[ElementIndex{0}].velocity[0]);
    }
    return v;
  }
};

constexpr const char* kTwoStages = R"({"name": "first", "steps": 10}, {"name": "second", "steps": 10})";

TEST(EdgeLoads, a_block_under_a_ramp_of_pressure_has_the_velocity_of_theory) {
  constexpr double kRate = 4e4;  // dp/dt; v = p' t² A / (2 m)
  const Pushed pushed;
  const std::vector<double> by_formula = Pushed::velocities(R"("pressure": "4e4 * t")");
  const std::vector<double> by_table = Pushed::velocities(R"("pressure": 8000, "over_time": [[0, 0], [0.2, 1]])");
  for (std::size_t i = 0; i < by_formula.size(); ++i) {
    const double t = 0.01 * static_cast<double>(i + 1);
    const double theory = kRate * t * t * pushed.area / (2 * pushed.mass);
    EXPECT_NEAR(by_formula[i], theory, 1e-3 * theory) << i;
    EXPECT_NEAR(by_formula[i], by_table[i], 1e-12 * theory) << i;
  }
}

TEST(EdgeLoads, stages_switch_a_load_on_and_off) {
  constexpr double kForce = 4000, kStage = 0.1;
  const double gain = kForce * kStage / Pushed().mass;
  const auto after = [](const std::string& stages) {
    const std::vector<double> v = Pushed::velocities(R"("pressure": 4000)" + stages, kTwoStages);
    return std::pair(v[9], v[19]);
  };
  const auto expect = [&](const std::string& stages, double first, double second) {
    const auto [v1, v2] = after(stages);
    EXPECT_NEAR(v1, first * gain, 1e-3 * gain) << stages;
    EXPECT_NEAR(v2, second * gain, 1e-3 * gain) << stages;
  };
  expect("", 1, 2);
  expect(R"(, "last_stage": 1)", 1, 1);
  expect(R"(, "first_stage": 2)", 0, 1);
  expect(R"(, "first_stage": 1, "last_stage": 2)", 1, 2);
}

TEST(EdgeLoads, a_stage_with_equilibrium_lasts_as_long_as_its_loads_change) {
  std::string text = case_of({}, block({}, {0, 0}, {4, 1}),
                             R"("tractions": [{"along": [[4, 0], [4, 1]], "x": 2e5, "over_time": [[0, 1], [0.03, 2]]},
                           {"along": [[4, 0], [4, 1]], "x": 1e5, "first_stage": 2}],
          "displacements": [{"along": [[0, 0], [0, 1]], "held": "x"}, {"along": [[0, 0], [4, 0]], "held": "y"}])",
                             kStatics);
  text = text.substr(0, text.rfind('}')) +
         R"(, "stages": [{"name": "a", "steps": 10, "equilibrium": 1e-3}, {"name": "b", "steps": 1}]})";
  const auto stepper = stepper_of(text);
  for (const double factor : {4 / 3.0, 5 / 3.0, 2.0, 2.5}) {
    ASSERT_TRUE(std::holds_alternative<StepReport>(stepper->advance()));
    EXPECT_NEAR(stress_of(*stepper, 0, {}).xx, 2e5 * factor, 1e-3 * 2e5 * factor);
  }
}

TEST(EdgeLoads, a_roller_of_the_first_stage_lets_go_in_the_second) {
  const std::string load = R"("pressure": 4000}], "displacements": [{"along": [[2, 0], [2, 1]], "held": "x", )"
                           R"("last_stage": 1)";
  const std::vector<double> v = Pushed::velocities(load, kTwoStages);
  EXPECT_NEAR(v[9], 0, 2e-4);
  EXPECT_NEAR(v[19], 4000 * 0.1 / Pushed().mass, 2e-3);
}

// A body of 2 m by 1 m spins by 3 rad/s under a pressure of 10 kPa on one side: its momentum is ∫ p n(t) dt.
TEST(EdgeLoads, a_pressure_turns_with_blocks_and_with_NMM_bodies) {
  constexpr double kSpin = 3, kTime = 0.6;
  for (const char* covers : {"", R"("covers": {"mesh": {"side": 0.45}},)"}) {
    double error = 0;
    for (const int steps : {60, 120}) {
      const double before = error;
      const auto stepper = stepper_of(fmt::format(
          R"({{"keyblock": 2, "blocks": {{"blocks": [{}]}}, {}
          "loads": {{"tractions": [{{{}, "pressure": 1e4}}]}}, "analysis": {{"step_count": {}, "time_step": {},
          "gravity": 0, "joint_materials": [{{}}], "block_materials": [{{"density": 2000, "youngs_modulus": 1e9,
          "poissons_ratio": 0.25, "initial_velocity": [0, 0, {}]}}]}}}})",
          block({}, {0, 0}, {2, 1}), covers, Frame{}.chain({2, 0}, {2, 1}), steps, kTime / steps, kSpin));
      for (int step = 0; step < steps; ++step) ASSERT_TRUE(std::holds_alternative<StepReport>(stepper->advance()));
      const Point exact = (-1e4 / kSpin) * Point{std::sin(kSpin * kTime), 1 - std::cos(kSpin * kTime)};
      error = distance(stepper->ledger().momentum.linear, exact) / length(exact);
      EXPECT_LT(error, 2 * kSpin * kTime / steps);  // the pressure is that of the start of each step
      if (before > 0) {
        EXPECT_LT(error, 0.6 * before);
      }
    }
  }
}

TEST(EdgeLoads, a_traction_on_an_NMM_body_ends_with_its_stage) {
  constexpr double kEnds = 2e5, kStays = 2e3;
  std::string text = case_of({}, block({}, {0, 0}, {4, 1}),
                             R"("tractions": [{"along": [[4, 0], [4, 1]], "x": 2e5, "last_stage": 1},
                           {"along": [[4, 0], [4, 1]], "x": 2e3}],
          "displacements": [{"along": [[0, 0], [0, 1]], "held": "normal"},
                            {"along": [[0, 0], [4, 0]], "held": "normal"}])",
                             kStatics);
  text.replace(text.find(R"("loads")"), 7, R"("covers": {"mesh": {"side": 1}}, "loads")");
  text = text.substr(0, text.rfind('}')) + R"(, "stages": [{"name": "a", "steps": 1}, {"name": "b", "steps": 1}]})";
  const auto stepper = stepper_of(text);
  for (const double stress : {kEnds + kStays, kStays}) {
    const auto made = stepper->advance();
    ASSERT_TRUE(std::holds_alternative<StepReport>(made)) << std::get<StepFailure>(made).reason;
    for (ElementIndex e : indices(stepper->state().elements))
      EXPECT_NEAR(stress_of(*stepper, e.value, {}).xx, stress, 1e-3 * kEnds);
  }
}

TEST(EdgeLoads, faults_of_stages_and_of_time_name_their_place) {
  const auto fault = [](const std::string& load, const std::string& stages) {
    return fault_of(Pushed::text(R"("pressure": 1, )" + load, stages));
  };
  EXPECT_NE(fault(R"("last_stage": 1)", "").find("expected stages for a load with first_stage"), std::string::npos);
  EXPECT_NE(fault(R"("first_stage": 3)", kTwoStages).find("a stage of a load from 1 to 2, found 3"), std::string::npos);
  EXPECT_NE(fault(R"("first_stage": 2, "last_stage": 1)", kTwoStages).find("a last_stage from 2, found 1"),
            std::string::npos);
  EXPECT_NE(fault(R"("x": "1 / 0 * t")", "").find("expected a finite value"), std::string::npos);
}

TEST(EdgeLoads, a_load_on_a_joint_acts_on_both_of_its_sides) {
  const Frame frame;
  const std::string text = case_of(frame, block(frame, {0, 0}, {1, 1}) + ", " + block(frame, {1, 0}, {2, 1}),
                                   R"("tractions": [{"along": [[1, 0], [1, 1]], "pressure": 5}])", kStatics);
  const std::string file = own_file();
  support::write_text(file, text);
  const Prepared prepared = prepare(formats::load_case({file}).problem, "standard", {});
  ASSERT_EQ(prepared.scene.model.edge_loads.size(), 2U);
  EXPECT_TRUE(prepared.requirements.has(TermKind::edge_load));
}

TEST(EdgeLoads, rows_that_follow_from_others_are_left_out) {
  const Frame frame;
  const std::string text = case_of(
      frame, R"({"outer": [[0, 0, 1], [1, 0, 1], [2, 0, 1], [4, 0, 1], [4, 1, 1], [0, 1, 1]]})",
      R"("displacements": [{"along": [[0, 0], [4, 0]], "held": "both"}, {"along": [[0, 1], [0, 0]], "held": "x"}])",
      kStatics);
  const std::string file = own_file();
  support::write_text(file, text);
  const Prepared prepared = prepare(formats::load_case({file}).problem, "standard", {});
  EXPECT_EQ(prepared.scene.model.support_rows.size(),
            5U);  // four of the foot; x of the left side above it
  EXPECT_TRUE(prepared.requirements.has(TermKind::edge_support));
}

TEST(EdgeLoads, faults_name_their_place) {
  const Frame frame;
  const std::string one = block(frame, {0, 0}, {2, 1});
  const std::string off = R"("tractions": [{"along": [[0, 3], [2, 3]], "x": 1}])";
  EXPECT_NE(fault_of(case_of(frame, one, off, kStatics)).find("expected a chain on edges, found none of it there"),
            std::string::npos);
  const std::string apart = R"("displacements": [{"along": [[0, 0], [2, 0]], "held": "y"}, )"
                            R"({"along": [[0, 1], [0, 0]], "held": "y", "y": 0.01}])";
  EXPECT_NE(fault_of(case_of(frame, one, apart, kStatics)).find("expected displacements that block 1 can follow"),
            std::string::npos);
  const std::string at_other_times =
      R"("displacements": [{"along": [[0, 0], [2, 0]], "held": "y", "y": 0.01, "over_time": [[0, 0], [1, 1]]}, )"
      R"({"along": [[0, 1], [0, 0]], "held": "y", "y": 0.01}])";
  EXPECT_NE(fault_of(case_of(frame, one, at_other_times, kStatics)).find("that block 1 can follow"), std::string::npos);
  const std::string back = R"("tractions": [{"along": [[0, 0], [2, 0]], "x": 1, "over_time": [[1, 0], [1, 1]]}])";
  EXPECT_NE(fault_of(case_of(frame, one, back, kStatics)).find("times of over_time that increase"), std::string::npos);
  const std::string unknown = R"("tractions": [{"along": [[0, 0], [2, 0]], "x": "z"}])";
  EXPECT_NE(fault_of(case_of(frame, one, unknown, kStatics)), "");
}

}  // namespace
}  // namespace keyblock::edge_loads_test
