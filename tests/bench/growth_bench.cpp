// Prints the cost of growing cracks: a step of growth beside one solution of the same mesh; remeshing a body and
// transferring its motion beside the factorisations of its matrices.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "model/continuum.hpp"
#include "run/growth/parents.hpp"
#include "run/prepare.hpp"
#include "run/stages/chain.hpp"
#include "run/steppers.hpp"
#include "step/bodies/linear_static.hpp"
#include "step/standard_stepper.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kAskedSolves = 3;   // of the same mesh, a step of growth
constexpr double kAskedFactors = 1;  // remeshing and transfer of the state

// Processor time, all threads together: other programs do not count.
double timed(const std::function<void()>& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// Best of several: other programs may delay a single one.
double best(const std::function<void()>& work, int times) {
  double least = 1e300;
  for (int i = 0; i < times; ++i) least = std::min(least, timed(work));
  return least;
}

/// A plate of 1 by 2 with an edge crack, at rest or in motion.
Problem plate(double side, double tip_side) {
  Problem problem;
  Blocks blocks;
  blocks.blocks = {support::rectangle({0, -1}, {1, 1})};
  problem.geometry = blocks;
  problem.analysis = support::plain_analysis(1e-4, 1);
  problem.analysis->gravity = 0;
  problem.analysis->block_materials[0].unit_weight = 0;
  problem.analysis->block_materials[0].toughness.emplace();
  problem.analysis->block_materials[0].toughness->mode_1 = 1;
  problem.covers.emplace();
  problem.covers->mesh.side = side;
  problem.covers->mesh.angle_deg = 10;
  problem.covers->mesh.tip_side = tip_side;
  problem.covers->cracks = {{{{0, 0}, {0.4, 0.01}}, {}}};
  return problem;
}

Json growth_step(double side) {
  constexpr int kSteps = 3;
  Problem problem = plate(side, 0);
  problem.analysis->velocity_carry_over = 0;
  CoverPlan& plan = *problem.covers;
  plan.contact = CoverContact::ignored;
  plan.growth.emplace();
  plan.growth->increment = 0.05;
  plan.tractions = {{{{0, 1}, {1, 1}}, {}, {"1", {}}, {}, {}}, {{{0, -1}, {1, -1}}, {}, {"-1", {}}, {}, {}}};
  plan.springs = {{{1, -1}, {1, 0}, 1e9, {}}, {{1, -1}, {0, 1}, 1e9, {}}, {{1, 1}, {1, 0}, 1e9, {}}};
  const std::unique_ptr<Stepper> stepper = stepper_for(prepare(problem, "standard", {}).scene);
  double step = 1e300;
  for (int i = 0; i <= kSteps; ++i) {
    const double took = timed([&] {
      if (!std::holds_alternative<StepReport>(stepper->advance())) throw std::runtime_error("a step of growth failed");
    });
    if (i > 0) step = std::min(step, took);  // the first begins with the crack as drawn
  }
  const Continuum& continuum = *stepper->model().continuum;
  const double solve = best([&] { solve_static(continuum); }, 5);
  const int unknowns = 2 * basis_of(continuum).function_count();
  fmt::print(
      "growth step: {} elements, {} unknowns: step {:.1f} ms, one solution {:.1f} ms: {:.2f} solutions (limit: {}){}\n",
      continuum.manifold.elements.size(), unknowns, 1e3 * step, 1e3 * solve, step / solve, kAskedSolves,
      step <= kAskedSolves * solve ? "" : "  MISSED");
  return {{"unknowns", unknowns}, {"step_s", step}, {"solution_s", solve}};
}

Problem flying(double side, double tip_side, double end) {
  Problem problem = plate(side, tip_side);
  problem.analysis->velocity_carry_over = 1;
  problem.analysis->block_materials[0].initial_velocity = {1, -0.5, 0.8};
  problem.covers->cracks[0].along[1] = {end, 0.01};
  return problem;
}

// A mesh that is finer about the tip, the default for a growing crack, is another one after each increment. `fineness`
// is its side far from the tip over that at the tip.
Json recut(int elements, double fineness) {
  const double side = std::sqrt(2 * 4 / (std::sqrt(3.0) * elements));
  const double tip_side = fineness > 1 ? side / fineness : 0;
  const Scene first = prepare(flying(side, tip_side, 0.4), "standard", {}).scene;
  const StandardStepper before(first);
  Scene next;
  const double cut = best([&] { next = prepare(flying(side, tip_side, 0.45), "standard", {}).scene; }, 2);
  int number = static_cast<int>(first.model.elements.size());
  SceneChange change;
  const double map = timed([&] {
    const Table<ElementIndex, ElementIndex> parents = parents_by_place(before.model(), next.model);
    change = change_between(before.model(), std::move(next), parents, number);
  });
  const double carry = best([&] { const StandardStepper after(before, change); }, 2);
  const Continuum& continuum = *change.scene.model.continuum;
  const CoverBasis basis = basis_of(continuum);
  const SparseSystem matrix = assemble_static(continuum, basis);
  const auto factorise = [&] {
    SparseFactor factor(matrix.lower(), Definiteness::semidefinite);
    factor.factorise(matrix.lower());
  };
  const double factor = best(factorise, 2);
  const double all = cut + map + carry;
  fmt::print(
      "recut and carried, {} at the tip: {} elements, {} unknowns: cut {:.2f} s, matched {:.2f} s, carried {:.2f} s; "
      "one factorisation {:.2f} s: {:.1f} factorisations (limit: {}){}\n",
      fineness > 1 ? "finer" : "as fine", continuum.manifold.elements.size(), 2 * basis.function_count(), cut, map,
      carry, factor, all / factor, kAskedFactors, all <= kAskedFactors * factor ? "" : "  MISSED");
  return {{"elements", continuum.manifold.elements.size()},
          {"cut_s", cut},
          {"matched_s", map},
          {"carried_s", carry},
          {"factor_s", factor}};
}

}  // namespace
}  // namespace keyblock::bench

int main(int argc, char** argv) {
  using namespace keyblock::bench;
  CLI::App app{"What growing cracks cost: printed, not judged"};
  std::string json;
  int elements = 100000;
  app.add_option("--json", json, "file for the numbers");
  app.add_option("--elements", elements, "of the plate that is cut anew")->check(CLI::Range(100, 1000000));
  CLI11_PARSE(app, argc, argv);
  Json all;
  for (const double side : {0.1, 0.05, 0.025}) all["growth_steps"].push_back(growth_step(side));
  all["recut"] = recut(elements, 1);
  all["recut_finer_at_tip"] = recut(elements, 4);
  if (!json.empty()) std::ofstream(json) << all.dump(1) << '\n';
  return 0;
}
