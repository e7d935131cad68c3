// Prints the cost of a step for growing scenes, in both profiles, and its parts; a JSON file keeps them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <malloc.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "base/context.hpp"
#include "base/loop.hpp"
#include "contact/find/candidates.hpp"
#include "contact/rows/gap.hpp"
#include "legacy/contact/carry.hpp"
#include "legacy/contact/detect.hpp"
#include "legacy/contact/judge.hpp"
#include "legacy/contact/springs.hpp"
#include "legacy/step/advance.hpp"
#include "legacy/step/update.hpp"
#include "legacy/terms/assemble.hpp"
#include "run/steppers.hpp"
#include "step/scene/acceleration.hpp"
#include "step/scene/touch_search.hpp"
#include "step/time/smooth_solve.hpp"
#include "system/block_iterations.hpp"
#include "system/cholmod/sparse_factor.hpp"
#include "tests/bench/bench_scenes.hpp"

namespace keyblock::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kEnough = 0.5;  // least time of the measured steps, if they are few [s]
constexpr int kMostSteps = 20;
constexpr int kFewestSteps = 2;
constexpr int kWarmSteps = 2;

// Wall-clock time: several threads share the work.
double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Memory in use on the heap, between two steps, when factorisations and lists of a step are free again.
double megabytes_in_use() {
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd) / 1e6;
}

// Best of as many as fit into a tenth of a second, three at least.
double best(const std::function<void()>& work) {
  double least = 1e300;
  double spent = 0;
  for (int i = 0; i < 3 || (spent < 0.1 && i < 100); ++i) {
    const double begin = now();
    work();
    const double took = now() - begin;
    spent += took;
    least = std::min(least, took);
  }
  return least;
}

struct Layout {
  std::string name;
  std::function<Blocks(int)> draw;
};

const std::vector<Layout>& layouts() {
  static const std::vector<Layout> all = {{"brick", [](int side) { return brick_wall(side); }},
                                          {"slope", [](int side) { return brick_wall(side, support::radians(20)); }},
                                          {"scatter", [](int side) { return scatter(side); }}};
  return all;
}

// Time of the Berkeley program for the median step of the same brick walls [s] (noisy, ± 30 %).
const std::map<int, double>& berkeley_bricks() {
  static const std::map<int, double> seconds = {
      {10, 0.002141}, {20, 0.015570}, {30, 0.093216}, {50, 0.825403}, {70, 3.165920}};
  return seconds;
}

// Least time of an open–close iteration [s per block] for walls with six contacts per brick. It follows from memory and
// arithmetic of one core of the machine of Keyblock's performance study: 1 / (4 iterations × steps per second ×
// blocks). The smaller bound counts: of a factorisation, or of iterations at dt c / h = 2. Power laws interpolate its
// three sizes.
double bound_of_pass(double blocks) {
  constexpr std::array<std::pair<double, double>, 3> kBounds{{{1e3, 3.5e-6}, {1e4, 1e-5}, {1e5, 2.27e-5}}};
  const std::size_t i = blocks < kBounds[1].first ? 0 : 1;
  const auto [small, least] = kBounds[i];
  const auto [large, most] = kBounds[i + 1];
  return least * std::pow(std::max(blocks, kBounds[0].first) / small, std::log(most / least) / std::log(large / small));
}

// Parts of a step by Shi's rules, each repeated from the present state [s].
Json parts_of_legacy(const ShiScene& scene, const Stepping& at) {
  const State& state = at.state;
  Json parts;
  const double dt = scene.settings.time_step;
  Contacts contacts = at.contacts;
  parts["search"] = best([&] { detect(scene.model, state, scene.settings, scene.rules); });
  parts["carry"] = best([&] { carry(contacts, contacts, state, scene.rules, scene.settings.quirks); });
  BlockMatrix::Pairs coupled;
  for (const Contact& contact : contacts)
    coupled.push_back(std::minmax(scene.model.vertices[contact.first.vertex].element.value,
                                  scene.model.vertices[contact.first.start].element.value));
  std::ranges::sort(coupled);
  coupled.erase(std::unique(coupled.begin(), coupled.end()), coupled.end());
  System system({});
  parts["assembly"] = best([&] {
    system = assemble(scene.terms, {scene.model, state, scene.settings, dt}, coupled);
    add_springs(contacts, scene.model, state, scene.rules, at.penalty, system);
  });
  Solver iterating;
  iterating.method = LinearMethod::conjugate_gradients;
  Eigen::VectorXd guess = Eigen::VectorXd::Zero(system.load.size());
  parts["solve_cg"] = best([&] { iterating.solve(system, {0, guess}); });
  if (system.matrix.block_count() <= 20000) {
    Solver factoring;
    factoring.method = LinearMethod::factor;
    parts["solve_factor"] = best([&] { factoring.solve(system); });
    // The same matrix by CHOLMOD alone: its factorisation, with the pattern analysed before.
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < system.matrix.block_count(); ++i)
      for (const auto& [j, block] : system.matrix.row(i))
        for (int c = 0; c < block.cols(); ++c)
          for (int r = 0; r < block.rows(); ++r)
            if (i != j || c <= r)
              entries.emplace_back(system.matrix.first_row(j) + (i == j ? r : c),
                                   system.matrix.first_row(i) + (i == j ? c : r), block(r, c));
    Eigen::SparseMatrix<double> lower(system.load.size(), system.load.size());
    lower.setFromTriplets(entries.begin(), entries.end());
    SparseFactor cholmod(lower, Definiteness::definite);
    parts["cholmod_factor"] = best([&] {
      cholmod.factorise(lower);
      cholmod.solve(system.load);
    });
  }
  Solution solution = *iterating.solve(system, {0, guess});
  Increments increments(scene.model.elements.size());
  for (ElementIndex e : indices(scene.model.elements))
    increments[e] = solution.x.segment(system.matrix.first_row(e.value), system.matrix.size(e.value));
  parts["judge"] = best([&] { judge(contacts, scene.model, state, increments, scene.rules, at.penalty); });
  parts["update"] = best([&] { update(scene.model, state, scene.settings, increments, dt); });
  return parts;
}

Json parts_of_standard(const StandardStepper& stepper) {
  const StandardScene& scene = stepper.scene();
  const Motion& motion = stepper.motion();
  const double dt = scene.settings.time_step;
  Json parts;
  const UnknownsTable loads = loads_at(scene, motion.q, stepper.state().time);
  const Scales scales = scales_of(scene, loads, motion.q, motion.v);
  Touches found;
  parts["search"] = best([&] { found = touches_of(scene, motion, scales, dt); });
  ContactRows rows;
  parts["rows"] = best([&] { rows = contact_rows(scene.model, scene.reference, motion.q, found); });
  SmoothMotion smooth;
  const ForceTolerance tolerance{1e-8 * scales.force, 1e-6 * scales.force};
  parts["forces"] = best([&] {
    smooth = smooth_solve(scene, motion, loads, found, tolerance, stepper.state().time, dt,
                          step_rule(scene.settings.standard, dt));
  });
  parts["factors_of_forces"] = smooth.solves;
  parts["overlaps"] = best(
      [&] { newly_overlapping(scene, motion, vertices_at(scene.model, scene.reference, smooth.q), found, scales); });
  parts["state"] = best([&] { state_of(scene, motion); });
  return parts;
}

Json measured(const Layout& layout, int side, const std::string& profile, double ratio) {
  const Blocks blocks = layout.draw(side);
  const auto count = static_cast<double>(blocks.blocks.size());
  const double before = megabytes_in_use();
  double begin = now();
  const Scene scene = scene_for(blocks, profile, ratio);
  std::unique_ptr<Stepper> stepper = stepper_for(scene);
  Json row{{"layout", layout.name},
           {"profile", profile},
           {"side", side},
           {"ratio", ratio},
           {"blocks", blocks.blocks.size()}};
  const auto step = [&] {
    const auto made = stepper->advance();
    if (const auto* failure = std::get_if<StepFailure>(&made)) throw std::runtime_error(failure->reason);
    return std::get<StepReport>(made);
  };
  int passes = 0;
  for (int i = 0; i < kWarmSteps; ++i) step();
  row["start"] = now() - begin;
  begin = now();
  int steps = 0;
  StepReport last;
  while (steps < kFewestSteps || (now() - begin < kEnough && steps < kMostSteps)) {
    last = step();
    passes += last.passes;
    ++steps;
  }
  const double seconds = (now() - begin) / steps;
  row["step"] = seconds;
  row["passes"] = static_cast<double>(passes) / steps;
  row["contacts"] = last.contacts;
  row["us_per_block_and_pass"] = 1e6 * seconds / count / std::max(1.0, static_cast<double>(passes) / steps);
  if (layout.name != "scatter" && count >= 900 && count <= 1e5)
    row["over_bound"] = 1e-6 * row["us_per_block_and_pass"].get<double>() / bound_of_pass(count);
  row["kilobytes_per_block"] = 1e3 * (megabytes_in_use() - before) / count;
  if (const auto* standard = dynamic_cast<const StandardStepper*>(stepper.get()))
    row["parts"] = parts_of_standard(*standard);
  return row;
}

Json legacy_parts(const Layout& layout, int side, double ratio) {
  const ShiScene scene = shi_scene(scene_for(layout.draw(side), "legacy", ratio));
  Stepping stepping = start(scene);
  for (int i = 0; i < kWarmSteps; ++i) support::step_once(scene, stepping);
  return parts_of_legacy(scene, stepping);
}

int side_of(const Layout& layout, double blocks) {
  const double factor = layout.name == "scatter" ? 1 : 1.02;
  return std::max(2, static_cast<int>(std::lround(std::sqrt(blocks / factor))));
}

void print(const Json& row, const Json& smaller) {
  const auto number = [&](const char* key) { return row[key].get<double>(); };
  std::string growth;
  if (!smaller.is_null())
    growth = fmt::format("{:.2f}", std::log(number("step") / smaller["step"].get<double>()) /
                                       std::log(number("blocks") / smaller["blocks"].get<double>()));
  std::string ratio;
  const int side = row["side"].get<int>();
  if (row["layout"] == "brick" && row["ratio"] == kRatioOfBricks && berkeley_bricks().contains(side))
    ratio = fmt::format("{:.1f}", berkeley_bricks().at(side) / number("step"));
  fmt::print("{:>8} {:>9} {:>8} {:>9.0f} {:>9.2f} {:>11.3f} {:>7.1f} {:>9.2f} {:>6} {:>9.1f} {:>8} {:>10}\n",
             row["layout"].get<std::string>(), row["profile"].get<std::string>(), row["blocks"].get<int>(),
             number("contacts"), number("start"), 1e3 * number("step"), number("passes"),
             number("us_per_block_and_pass"),
             row.contains("over_bound") ? fmt::format("{:.1f}", number("over_bound")) : std::string(),
             number("kilobytes_per_block"), growth, ratio);
  if (row.contains("parts")) {
    std::string text = "          ";
    for (const auto& [name, value] : row["parts"].items())
      text += name == "factors_of_forces" ? fmt::format(" {} {}", name, value.get<int>())
                                          : fmt::format(" {} {:.2f}", name, 1e3 * value.get<double>());
    fmt::print("{} ms\n", text);
  }
  std::fflush(stdout);
}

void search_alone(double most, Json& kept) {
  fmt::print("\nnear pairs of boxes of scattered and of bonded blocks, ns a block\n{:>9} {:>10} {:>10} {:>10}\n",
             "blocks", "scatter", "brick", "growth");
  double last = 0;
  double last_count = 0;
  for (double blocks = 1e3; blocks <= most; blocks *= 10) {
    double ns[2] = {0, 0};
    for (const int which : {0, 1}) {
      const Layout& layout = layouts()[which == 0 ? 2 : 0];
      const ShiScene scene = shi_scene(scene_for(layout.draw(side_of(layout, blocks)), "legacy"));
      const State state = start(scene).state;
      ns[which] =
          1e9 * best([&] { close_pairs(scene.model, state, 0.05); }) / static_cast<double>(scene.model.elements.size());
    }
    const std::string growth =
        last > 0 ? fmt::format("{:.2f}", 1 + std::log(ns[1] / last) / std::log(blocks / last_count)) : "";
    fmt::print("{:>9.0f} {:>10.0f} {:>10.0f} {:>10}\n", blocks, ns[0], ns[1], growth);
    kept["search"].push_back({{"blocks", blocks}, {"scatter_ns", ns[0]}, {"brick_ns", ns[1]}});
    last = ns[1];
    last_count = blocks;
  }
}

}  // namespace
}  // namespace keyblock::bench

int main(int argc, char** argv) {
  using namespace keyblock;
  using namespace keyblock::bench;
  CLI::App app{
      "what a step costs, time on the wall; ratios to what the Berkeley program needed carry ± 30 % and another "
      "machine"};
  double most = 1e4;
  double most_searched = 1e6;
  std::string json;
  int threads = 0;
  int only = 0;
  double ratio = kRatioOfBricks;
  std::vector<std::string> profiles = {"legacy", "standard"};
  std::vector<std::string> names;
  app.add_option("--most", most, "blocks of the largest scene")->capture_default_str();
  app.add_option("--most-searched", most_searched, "blocks of the largest search")->capture_default_str();
  app.add_option("--profile", profiles, "profiles")->capture_default_str();
  app.add_option("--layout", names, "layouts: brick, slope, scatter; all where none is named");
  app.add_option("--side", only, "this many blocks along a side and no other number of them");
  app.add_option("--ratio", ratio, "R = p dt^2 / 2m of a whole brick, by the step")->capture_default_str();
  app.add_option("--threads", threads, "threads of a step; 0: one a processor")->capture_default_str();
  app.add_option("--json", json, "file for the numbers");
  CLI11_PARSE(app, argc, argv);
  context().use_threads(threads);
  Json kept{{"steps", Json::array()}, {"parts_of_legacy", Json::array()}, {"search", Json::array()}};
  fmt::print("{:>8} {:>9} {:>8} {:>9} {:>9} {:>11} {:>7} {:>9} {:>6} {:>9} {:>8} {:>10}\n", "layout", "profile",
             "blocks", "contacts", "start s", "step ms", "passes", "us/b/pass", "/bound", "kB/block", "growth",
             "Berkeley/");
  bool failed = false;
  for (const std::string& profile : profiles) {
    for (const Layout& layout : layouts()) {
      if (!names.empty() && std::ranges::find(names, layout.name) == names.end()) continue;
      std::vector<int> sides = {side_of(layout, 100), 30, 50, 70};
      for (double blocks = 1e4; blocks <= most * 1.001; blocks *= std::sqrt(10))
        sides.push_back(side_of(layout, blocks));
      if (only > 0) sides = {only};
      Json smaller;
      for (const int side : sides) {
        try {
          Json row = measured(layout, side, profile, ratio);
          if (profile == "legacy") row["parts"] = legacy_parts(layout, side, ratio);
          print(row, smaller);
          kept["steps"].push_back(row);
          smaller = row;
        } catch (const std::exception& error) {
          fmt::print("{:>8} {:>9} side {}: {}\n", layout.name, profile, side, error.what());
          failed = true;
        }
      }
    }
  }
  if (most_searched >= 1e3) search_alone(most_searched, kept);
  if (!json.empty()) std::ofstream(json) << kept.dump(1) << '\n';
  return failed ? 1 : 0;
}
