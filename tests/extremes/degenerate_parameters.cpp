// ext-08: parameters at the end of their range. The exact answer if there is one, else a message that names the fault;
// never a NaN without a message.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "formats/registry.hpp"
#include "problem/checks/check.hpp"
#include "tests/extremes/extreme.hpp"
#include "tests/extremes/extreme_scenes.hpp"

namespace keyblock::extremes {
namespace {

constexpr double kRoundOff = 1e-14;  // of a metre

Extreme row(std::string quantity, double expected, double got, double tolerance, std::string note = {}) {
  return {"ext-08", std::move(quantity), expected, got, tolerance, std::move(note)};
}

// Returns true if a message names the fault.
Extreme says(const std::string& variant, const std::string& word, const std::string& said) {
  return row(variant + fmt::format(": says \"{}\"", word), 1, said.find(word) != std::string::npos ? 1 : 0, 0, said);
}

Problem slope_problem(double slope_deg, double friction_deg, int steps) {
  Problem problem;
  problem.geometry = block_on_slope(radians(slope_deg));
  problem.analysis = plain_analysis(1e-3, steps);
  problem.analysis->joint_materials[0].friction_angle_deg = friction_deg;
  return problem;
}

Extreme slides(double slope_deg, double friction_deg) {
  const Run run = run_standard(slope_problem(slope_deg, friction_deg, 500));
  return row(fmt::format("friction {:g} on {:g} degrees: slide in 0.5 s", friction_deg, slope_deg),
             slide(radians(slope_deg), radians(friction_deg), 0.5), length(run.travel(1)), 1e-7, run.trouble);
}

Extreme without_gravity() {
  const Run run = run_standard(slope_problem(0, 30, 100), {{"gravity", "0"}});
  return row("gravity 0: drift of a block on a floor", 0, length(run.travel(1)), kRoundOff, run.trouble);
}

// Mean vertical stress of a block at rest is half the pressure of its weight, for any elasticity.
Extreme stress_at_rest(const std::string& variant, double modulus, double poissons_ratio, const std::string& plane) {
  Problem problem;
  problem.geometry = column(1);
  problem.analysis = plain_analysis(1e-3, 100);
  problem.analysis->block_materials = {rock(kDensity, modulus, poissons_ratio)};
  const Run run = run_standard(problem, {{"plane", plane}});
  const double expected = -kDensity * kGravity / 2;
  return row(variant + ": vertical stress at rest", expected, run.block(1).stress.yy, 1e-6 * -expected, run.trouble);
}

// Under its own weight a block of 1e-3 Pa would be pressed to nothing; a falling one is exact.
Extremes too_soft() {
  Problem falling;
  falling.geometry = scene_of_blocks({}, {rectangle({0, 10}, {1, 11})});
  falling.analysis = plain_analysis(1e-3, 100);
  falling.analysis->block_materials = {rock(kDensity, 1e-3, kPoisson)};
  Problem resting = falling;
  resting.geometry = column(1);
  const Run run = run_standard(falling);
  const std::string trouble = run_standard(resting).trouble;
  return {row("E 1e-3 Pa: fall in 0.1 s", kGravity / 2 * 0.01, -run.travel(0).y, 1e-10),
          row("E 1e-3 Pa: rest under its weight ends with a reason", 1,
              trouble.starts_with("ended") || trouble.starts_with("refused") ? 1 : 0, 0, trouble)};
}

// Text, because such numbers come from files: k01 n5 nb nj g2 g1, block material, joint material.
std::string what_reader_says(const std::string& time_step, const std::string& density) {
  const std::string text =
      fmt::format("1 10 1 1 0.01 {}\n{} 25506 5e9 0.25\n0 0 0\n0 0 0\n0 0 0\n30 0 0\n", time_step, density);
  try {
    formats::read_as({formats::find_format("dda-analysis-berkeley"), {}}, {"case.ana", text});
  } catch (const InputError& error) {
    return error.what();
  }
  return "read without complaint";
}

Extreme checked(const std::string& variant, const std::string& word, const BlockPolygon& block) {
  Problem problem;
  problem.geometry = scene_of_blocks({rectangle({-2, -1}, {3, 0})}, {block});
  problem.analysis = plain_analysis(1e-3, 10);
  const Checked seen = check(problem);
  return says(variant, word, seen.errors.empty() ? "checked without complaint" : seen.errors.front().what());
}

Extremes repeated_vertex() {
  Problem problem;
  problem.geometry =
      scene_of_blocks({rectangle({-2, -1}, {3, 0})}, {polygon({{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}})});
  problem.analysis = plain_analysis(1e-3, 100);
  const Run run = run_standard(problem);
  return {row("repeated vertex: vertical stress at rest", -kDensity * kGravity / 2, run.block(1).stress.yy, 1e-3,
              run.trouble)};
}

// A square drawn in a square: the outer block has a hole of 1 m2, in which the inner one lies.
Extremes inside_another() {
  Drawing drawing;
  drawing.edge_node_ratio = 1e-3;
  const auto square = [&](double low, double high) {
    for (const auto& [a, b] : {std::pair{Point{low, low}, Point{high, low}},
                               {{high, low}, {high, high}},
                               {{high, high}, {low, high}},
                               {{low, high}, {low, low}}})
      drawing.joints.push_back({{a, b}, 0, {}});
  };
  square(0, 3);
  square(1, 2);
  drawing.boundary_count = 4;
  drawing.fixed_lines = {{{{0.5, 0.5}, {0.5, 0.5}}, {}}, {{{2.5, 0.5}, {2.5, 0.5}}, {}}};
  Problem problem;
  problem.geometry = drawing;
  problem.analysis = plain_analysis(1e-3, 100);
  const Run run = run_standard(problem);
  if (run.trouble.starts_with("refused")) return {says("block inside another", "holes", run.trouble)};
  double area = 0;
  for (const ElementFrame& e : run.last.elements) area += e.area;
  return {row("block inside another: area of both", 9, area, 1e-4, run.trouble),
          row("block inside another: drift of the inner one", 0, length(run.travel(1)), 1e-9)};
}

Problem nothing() {
  Problem problem;
  problem.geometry = Blocks{};
  problem.analysis = plain_analysis(1e-3, 10);
  return problem;
}

}  // namespace

Extremes degenerate_parameters(Effort) {
  Extremes rows{slides(30, 0),
                slides(30, 89.9),
                without_gravity(),
                stress_at_rest("nu 0", kModulus, 0, "strain"),
                stress_at_rest("nu 0.4999, plane strain", kModulus, 0.4999, "strain"),
                stress_at_rest("E 1e15 Pa", 1e15, kPoisson, "stress"),
                says("dt 0", "time step", what_reader_says("0", "2600")),
                says("density NaN", "mass per unit area", what_reader_says("1e-3", "nan")),
                says("no block", "block", run_standard(nothing()).trouble),
                checked("clockwise polygon", "counter-clockwise", polygon({{0, 0}, {0, 1}, {1, 1}, {1, 0}})),
                checked("block without area", "area", polygon({{0, 0}, {1, 0}, {2, 0}}))};
  for (const Extremes& more : {too_soft(), repeated_vertex(), inside_another()})
    rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

}  // namespace keyblock::extremes
