// Prints the cost of a step and of a static solution on covers beside the bare kernels, to compare factorisation and
// conjugate gradients.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/IterativeLinearSolvers>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "step/bodies/linear_static.hpp"
#include "tests/support/continuum_benchmarks.hpp"
#include "tests/support/covers_alone.hpp"

namespace keyblock::bench {
namespace {

using Json = nlohmann::ordered_json;
using Sparse = Eigen::SparseMatrix<double>;

constexpr double kYoungsModulus = 1e9;
constexpr double kDensity = 2500;
// On the end of the beam: it would settle by 1/100 of the length at rest.
constexpr double kPull = 0.1 * kYoungsModulus / (1000 * 4.0238);
constexpr double kSwing = 0.05;  // of the tip, over its static displacement

constexpr int kLaterSteps = 10;
constexpr double kTolerance = 1e-10;
constexpr int kMostIterations = 20000;
constexpr double kSame = 1e-6;  // two solutions of one matrix, one of them of a semidefinite one

// Wall-clock time: several threads share the work.
double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double timed(const std::function<void()>& work) {
  const double begin = now();
  work();
  return now() - begin;
}

// Best of as many as fit into a second, three at least: other programs may delay a single one.
double best(const std::function<void()>& work) {
  double least = 1e300;
  double spent = 0;
  for (int i = 0; i < 3 || (spent < 1 && i < 50); ++i) {
    const double took = timed(work);
    spent += took;
    least = std::min(least, took);
  }
  return least;
}

/// The beam of nmm-06, pulled hard enough to move by more than round-off.
Continuum beam(CoverFunctions functions, double rows) {
  Continuum continuum = clamped_cantilever(functions, rows).continuum;
  continuum.materials[0] = elastic_material(kYoungsModulus, 0.3);
  continuum.materials[0].density = kDensity;
  continuum.tractions[0].force = [](Point, Point) { return Point{0, kPull}; };
  return continuum;
}

/// Returns the rows of a beam with about so many unknowns.
double rows_for(CoverFunctions functions, double unknowns) {
  constexpr double kFewRows = 16;
  const Continuum few = beam(functions, kFewRows);
  return kFewRows * std::sqrt(unknowns / (2 * CoverBasis(few.manifold, functions).function_count()));
}

/// Midpoint rule of the elastic force: no numerical damping.
StepRule rule_of(double dt) {
  StandardChoices choices;
  choices.force_weight = 0.5;
  return step_rule(choices, dt);
}

/// The body oscillates through its straight shape.
CoverMotion swinging(const ElasticBodies& bodies) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(bodies.unknown_count());
  CoverMotion motion{zero, zero, zero, {}};
  SparseSystem stiffness = bodies.ghost;
  stiffness.add_scaled(1, bodies.supports);
  bodies.elasticity.add_static_tangent(motion.q, 1, stiffness);
  SparseFactor factor(stiffness.lower(), definiteness_of(bodies.continuum.functions));
  factor.factorise(stiffness.lower());
  const Eigen::VectorXd bent = factor.solve(bodies.supports.load());
  const double omega = std::sqrt(bent.dot(stiffness.times(bent)) / bent.dot(bodies.mass.times(bent)));
  motion.v = kSwing * omega * bent;
  return motion;
}

/// The matrix that CoverEquations factorises without damping.
void assemble_tangent(const ElasticBodies& bodies, const CoverMotion& start, const Eigen::VectorXd& increment,
                      const StepRule& rule, SparseSystem& tangent) {
  tangent.clear();
  tangent.add_scaled(rule.inertia.increment, bodies.mass);
  tangent.add_scaled(rule.stiffness, bodies.ghost);
  tangent.add_scaled(rule.stiffness, bodies.supports);
  bodies.elasticity.add_tangent(start.q, start.q + increment, rule.stiffness, {}, 1, tangent);
}

// A new factorisation gives other bits: a step reports its iterations, but not if it kept the factorisation. Two in one
// step count as one.
class FactorWatch {
 public:
  explicit FactorWatch(const CoverEquations& equations)
      : equations_(equations), probe_(equations.bodies().supports.load()) {}
  bool is_new() {
    Eigen::VectorXd answer = equations_.solve(probe_);
    const bool is_same = answer.size() == last_.size() && answer == last_;
    last_ = std::move(answer);
    return !is_same;
  }

 private:
  const CoverEquations& equations_;
  Eigen::VectorXd probe_;
  Eigen::VectorXd last_;
};

/// The first step, which makes the factorisation, and the steps after it; `motion` ends where they do.
Json steps_of(const support::CoversAlone& alone, const StepRule& rule, double dt, CoverMotion& motion) {
  const Eigen::VectorXd& load = alone.equations().bodies().supports.load();
  FactorWatch watch(alone.equations());
  int rounds = 0;
  const auto step = [&] {
    support::CoversAlone::Step made = alone.step(motion, load, rule, dt);
    if (!made.is_solved) throw std::runtime_error("a step is not solved");
    rounds = made.rounds;
    motion = std::move(made.end);
  };
  Json row;
  row["first_step"] = timed(step);
  row["first_rounds"] = rounds;
  watch.is_new();
  double least = 1e300;
  double all = 0;
  int all_rounds = 0;
  int factors = 0;
  for (int k = 0; k < kLaterSteps; ++k) {
    const double took = timed(step);
    all += took;
    all_rounds += rounds;
    factors += watch.is_new() ? 1 : 0;
    if (took < least) row["step_rounds"] = rounds;
    least = std::min(least, took);
  }
  row["step"] = least;
  row["mean_step"] = all / kLaterSteps;
  row["rounds"] = static_cast<double>(all_rounds) / kLaterSteps;
  row["factors"] = static_cast<double>(factors) / kLaterSteps;
  return row;
}

/// Conjugate gradients from zero. The cost of the preconditioner is separate, because it could be kept like the
/// factorisation.
template <class Preconditioner>
Json gradients(const Sparse& lower, const Eigen::VectorXd& right) {
  Eigen::ConjugateGradient<Sparse, Eigen::Lower, Preconditioner> solver;
  solver.setTolerance(kTolerance);
  solver.setMaxIterations(kMostIterations);
  Json row;
  row["setup"] = best([&] { solver.compute(lower); });
  Eigen::VectorXd x;
  row["solve"] = best([&] { x = solver.solve(right); });
  row["iterations"] = solver.iterations();
  row["converged"] = solver.info() == Eigen::Success;
  return row;
}

/// Times each part of a step alone, and conjugate gradients instead of the factorisation, for the first Newton
/// iteration of the step from `start`.
Json kernels_of(CoverEquations& equations, const StepRule& rule, double dt, const CoverMotion& start) {
  const ElasticBodies& bodies = equations.bodies();
  const Eigen::VectorXd increment = dt * start.v;
  equations.begin(start, bodies.supports.load(), rule, dt);
  equations.linearise(increment);
  const Eigen::VectorXd right = equations.residual();
  SparseSystem tangent = bodies.mass;
  Json row;
  row["tangent"] = best([&] { assemble_tangent(bodies, start, increment, rule, tangent); });
  row["force"] = best([&] { equations.evaluate(increment); });
  const Definiteness definiteness = definiteness_of(bodies.continuum.functions);
  SparseFactor factor(tangent.lower(), definiteness);
  row["factor"] = best([&] { factor.factorise(tangent.lower()); });
  Eigen::VectorXd x;
  row["solve"] = best([&] { x = factor.solve(right); });
  row["refinements"] = definiteness == Definiteness::semidefinite ? factor.solve_refined(right).refinements : 0;
  row["factor_entries"] = factor.entries();
  const Eigen::VectorXd off = tangent.times(x - equations.solve(right));
  if (!(off.norm() <= kSame * right.norm())) throw std::runtime_error("the tangent is not that of the step");
  row["diagonal"] = gradients<Eigen::DiagonalPreconditioner<double>>(tangent.lower(), right);
  row["cholesky"] = gradients<Eigen::IncompleteCholesky<double, Eigen::Lower>>(tangent.lower(), right);
  return row;
}

double number(const Json& row, const char* key) {
  return row[key].get<double>();
}

/// Prints the ratios: a step over the kernels that it calls, and conjugate gradients over the cost of the kept
/// factorisation in a step.
void add_ratios(Json& row) {
  const double solve = number(row, "solve");
  row["first_over_kernel"] = number(row, "first_step") / (number(row, "factor") + number(row, "first_rounds") * solve);
  row["step_over_kernel"] = number(row, "step") / (number(row, "step_rounds") * solve);
  // The lower bound: one solution per step to the tolerance, with a preconditioner that is kept.
  const double kept = number(row, "rounds") * solve + number(row, "factors") * number(row, "factor");
  row["kept"] = kept;
  for (const char* name : {"diagonal", "cholesky"}) {
    Json& run = row[name];
    run["over_solve"] = number(run, "solve") / solve;
    run["over_factor"] = number(run, "solve") / number(row, "factor");
    run["over_kept"] = number(run, "solve") / kept;
  }
}

Json dynamic_row(const Continuum& continuum, const CoverMotion& start, double side, double tau) {
  const support::CoversAlone alone(continuum);
  const ElasticBodies& bodies = alone.equations().bodies();
  const double dt = tau * side / std::sqrt(kYoungsModulus / kDensity);
  const StepRule rule = rule_of(dt);
  fmt::print(stderr, "{} functions, {} unknowns, tau {}\n", name_of(bodies.continuum.functions), bodies.unknown_count(),
             tau);
  Json row{{"functions", name_of(bodies.continuum.functions)},
           {"unknowns", bodies.unknown_count()},
           {"tau", tau},
           {"dt", dt}};
  CoverMotion motion = start;
  row.update(steps_of(alone, rule, dt, motion));
  row.update(kernels_of(alone.equations(), rule, dt, motion));
  add_ratios(row);
  return row;
}

Json static_row(const Continuum& continuum) {
  const Definiteness definiteness = definiteness_of(continuum.functions);
  const CoverBasis basis(continuum.manifold, continuum.functions);
  fmt::print(stderr, "{} functions, {} unknowns, static\n", name_of(continuum.functions), 2 * basis.function_count());
  Json row{{"functions", name_of(continuum.functions)}, {"unknowns", 2 * basis.function_count()}};
  row["whole"] = best([&] { solve_static(continuum); });
  const SparseSystem system = assemble_static(continuum, basis);
  row["assembly"] = best([&] { assemble_static(continuum, basis); });
  row["analysis"] = best([&] { SparseFactor(system.lower(), definiteness); });
  SparseFactor factor(system.lower(), definiteness);
  row["factor"] = best([&] { factor.factorise(system.lower()); });
  row["solve"] = best([&] { factor.solve_refined(system.load()); });
  row["refinements"] = factor.solve_refined(system.load()).refinements;
  row["factor_entries"] = factor.entries();
  const double bare = number(row, "factor") + number(row, "solve");
  row["whole_over_kernel"] = number(row, "whole") / bare;
  row["whole_over_analysed_kernel"] = number(row, "whole") / (number(row, "analysis") + bare);
  return row;
}

void print_steps(const Json& rows) {
  fmt::print(
      "\na step beside its kernels, ms on the wall; the first step makes the factor; step: the best of {} after it,\n"
      "rounds and factors their means; kernels: one factor, one solve (with its refinements), alone\n"
      "{:>9} {:>8} {:>4} | {:>8} {:>6} {:>8} {:>6} {:>7} | {:>8} {:>8} {:>7} {:>7} {:>7} | {:>13} {:>12}\n",
      kLaterSteps, "functions", "unknowns", "tau", "first", "rounds", "step", "rounds", "factors", "factor", "solve",
      "refined", "force", "tangent", "first/kernels", "step/kernels");
  for (const Json& row : rows)
    fmt::print(
        "{:>9} {:>8} {:>4} | {:>8.1f} {:>6} {:>8.1f} {:>6.1f} {:>7.1f} | {:>8.1f} {:>8.2f} {:>7} {:>7.1f} {:>7.1f} | "
        "{:>13.2f} {:>12.2f}\n",
        row["functions"].get<std::string>(), row["unknowns"].get<int>(), number(row, "tau"),
        1e3 * number(row, "first_step"), row["first_rounds"].get<int>(), 1e3 * number(row, "step"),
        number(row, "rounds"), number(row, "factors"), 1e3 * number(row, "factor"), 1e3 * number(row, "solve"),
        row["refinements"].get<int>(), 1e3 * number(row, "force"), 1e3 * number(row, "tangent"),
        number(row, "first_over_kernel"), number(row, "step_over_kernel"));
}

void print_gradients(const Json& rows) {
  fmt::print(
      "\nconjugate gradients to {:.0e} from zero on the same tangent, over one solve by the factor, one factor, and "
      "what\n"
      "the kept factor costs a step (rounds x solve + factors x factor) if one such solution were enough for a step\n"
      "{:>9} {:>8} {:>4} | {:>10} {:>8} {:>11} {:>9} | {:>7} {:>8} {:>7}\n",
      kTolerance, "functions", "unknowns", "tau", "scaled by", "setup ms", "iterations", "solve ms", "/ solve",
      "/ factor", "/ kept");
  for (const Json& row : rows)
    for (const char* name : {"diagonal", "cholesky"}) {
      const Json& run = row[name];
      fmt::print("{:>9} {:>8} {:>4} | {:>10} {:>8.1f} {:>10}{} {:>9.1f} | {:>7.1f} {:>8.2f} {:>7.2f}\n",
                 row["functions"].get<std::string>(), row["unknowns"].get<int>(), number(row, "tau"), name,
                 1e3 * number(run, "setup"), run["iterations"].get<int>(), run["converged"].get<bool>() ? ' ' : '!',
                 1e3 * number(run, "solve"), number(run, "over_solve"), number(run, "over_factor"),
                 number(run, "over_kept"));
    }
}

void print_statics(const Json& rows) {
  fmt::print(
      "\na static solution beside its kernels, ms on the wall; the pattern is analysed before the kernels\n"
      "{:>9} {:>8} | {:>8} {:>8} {:>8} {:>8} {:>8} {:>7} | {:>13} {:>13}\n",
      "functions", "unknowns", "whole", "assembly", "analysis", "factor", "solve", "refined", "whole/kernels",
      "with analysis");
  for (const Json& row : rows)
    fmt::print("{:>9} {:>8} | {:>8.1f} {:>8.1f} {:>8.1f} {:>8.1f} {:>8.1f} {:>7} | {:>13.2f} {:>13.2f}\n",
               row["functions"].get<std::string>(), row["unknowns"].get<int>(), 1e3 * number(row, "whole"),
               1e3 * number(row, "assembly"), 1e3 * number(row, "analysis"), 1e3 * number(row, "factor"),
               1e3 * number(row, "solve"), row["refinements"].get<int>(), number(row, "whole_over_kernel"),
               number(row, "whole_over_analysed_kernel"));
}

std::vector<double> sizes_to(double most) {
  std::vector<double> sizes;
  for (double unknowns = 1e4; unknowns <= most * 1.001; unknowns *= 10) sizes.push_back(unknowns);
  if (sizes.empty()) sizes.push_back(most);
  return sizes;
}

Json measured(const std::vector<std::string>& names, double most, const std::vector<double>& taus) {
  Json kept{{"steps", Json::array()}, {"statics", Json::array()}};
  for (const CoverFunctions functions : kAllCoverFunctions) {
    if (std::ranges::find(names, name_of(functions)) == names.end()) continue;
    for (const double unknowns : sizes_to(most)) {
      const double rows = rows_for(functions, unknowns);
      const Continuum continuum = beam(functions, rows);
      kept["statics"].push_back(static_row(continuum));
      const CoverMotion start = swinging(ElasticBodies(continuum));
      for (const double tau : taus) kept["steps"].push_back(dynamic_row(continuum, start, 1.3 / rows, tau));
    }
  }
  return kept;
}

}  // namespace
}  // namespace keyblock::bench

int main(int argc, char** argv) {
  using namespace keyblock::bench;
  CLI::App app{"what bodies on covers cost beside a factor, a solve and conjugate gradients on the same matrix"};
  double most = 1e5;
  std::string json;
  std::vector<double> taus = {2, 20};
  std::vector<std::string> names = {"constant", "linear"};
  app.add_option("--functions", names, "kinds of cover functions: constant, derived, linear, quadratic")
      ->capture_default_str();
  app.add_option("--most", most, "unknowns of the largest body")->capture_default_str();
  app.add_option("--tau", taus, "steps, as sides of an element that a wave runs along one")->capture_default_str();
  app.add_option("--json", json, "file for the numbers");
  CLI11_PARSE(app, argc, argv);
  const Json kept = measured(names, most, taus);
  print_steps(kept["steps"]);
  print_gradients(kept["steps"]);
  print_statics(kept["statics"]);
  if (!json.empty()) std::ofstream(json) << kept.dump(1) << '\n';
  return 0;
}
