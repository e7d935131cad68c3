// Draws cracks and mesh; the program's own steppers do the rest. See random_cracks.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/random_cracks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <numbers>
#include <utility>

#include "cut/bodies/body_graph.hpp"
#include "cut/mesh/fit_mesh.hpp"
#include "fracture/tip_report.hpp"
#include "geometry/polygon.hpp"
#include "model/continuum.hpp"
#include "run/growth/parents.hpp"
#include "run/growth/solution_of.hpp"
#include "run/prepare.hpp"
#include "run/stages/chain.hpp"
#include "step/linear_stepper.hpp"
#include "step/standard_stepper.hpp"
#include "tests/support/scenes.hpp"
#include "tests/validate/dice.hpp"

namespace keyblock::support {
namespace {

using Chain = std::vector<Point>;

const BlockPolygon kSquare = rectangle({0, 0}, {1, 1});

Formula formula(double value) {
  return {fmt::format("{}", value), {}};
}

class CrackDice {
 public:
  CrackDice(unsigned seed, const MeshPlan& plan) : dice_(seed), mesh_(fitted_mesh(plan, graph_of(kSquare)).mesh) {}

  std::vector<Chain> chains(CrackKind kind) {
    switch (kind) {
      case CrackKind::anywhere:
        return {inside(2 + dice_.below(3))};
      case CrackKind::through_nodes:
        return {through_nodes()};
      case CrackKind::along_sides:
        return {along_sides()};
      case CrackKind::nearly_closed:
        return nearly_closed();
      case CrackKind::near_boundary:
        return {near_boundary()};
      case CrackKind::meeting:
        return meeting_cracks();
      case CrackKind::cutting_in_two:
        return cutting();
    }
    return {};
  }

 private:
  double coordinate() { return dice_.between(0.03, 0.97); }
  Point place() {
    const double x = coordinate();
    return {x, coordinate()};
  }
  Point place_apart_from(Point other) {
    for (;;)
      if (const Point p = place(); distance(p, other) > 0.05) return p;
  }
  double tiny() { return dice_.magnitude_between(1e-12, 1e-3); }

  Chain inside(int count) {
    Chain chain{place()};
    while (static_cast<int>(chain.size()) < count) chain.push_back(place_apart_from(chain.back()));
    return chain;
  }

  static bool is_inside(Point p) { return p.x > 0.03 && p.x < 0.97 && p.y > 0.03 && p.y < 0.97; }
  int node_inside() {
    for (;;) {
      const int n = dice_.below(static_cast<int>(mesh_.nodes.size()));
      if (is_inside(at(n))) return n;
    }
  }
  Point at(int node) const { return mesh_.nodes[static_cast<std::size_t>(node)]; }

  static bool is_new(Point p, const Chain& chain) {
    return std::ranges::all_of(chain, [&](Point other) { return distance(p, other) > 0.05; });
  }

  Chain through_nodes() {
    Chain chain{place()};
    for (int i = 1 + dice_.below(2); i >= 0; --i)
      if (const Point p = at(node_inside()); is_new(p, chain)) chain.push_back(p);
    if (dice_.happens(0.5) || chain.size() < 2) chain.push_back(place_apart_from(chain.back()));
    return chain;
  }

  /// Neighbours of a node within the square.
  std::vector<int> around(int node) const {
    std::vector<int> found;
    for (const auto& t : mesh_.triangles)
      for (std::size_t k = 0; k < 3; ++k)
        if (t[k] == node)
          for (const int other : {t[(k + 1) % 3], t[(k + 2) % 3]})
            if (is_inside(at(other)) && std::ranges::find(found, other) == found.end()) found.push_back(other);
    return found;
  }

  Chain along_sides() {
    for (;;) {
      std::vector<int> nodes{node_inside()};
      for (int i = 1 + dice_.below(3); i > 0; --i) {
        std::vector<int> next = around(nodes.back());
        std::erase_if(next, [&](int n) { return std::ranges::find(nodes, n) != nodes.end(); });
        if (!next.empty()) nodes.push_back(next[static_cast<std::size_t>(dice_.below(static_cast<int>(next.size())))]);
      }
      if (nodes.size() < 2) continue;
      const double turn = dice_.between(0, 2 * std::numbers::pi);
      const double off = dice_.happens(0.5) ? tiny() : 0;
      Chain chain;
      for (const int n : nodes) chain.push_back(at(n) + off * Point{std::cos(turn), std::sin(turn)});
      if (dice_.happens(0.5)) chain.back() = chain[chain.size() - 2] + 0.6 * (chain.back() - chain[chain.size() - 2]);
      return chain;
    }
  }

  std::vector<Chain> nearly_closed() {
    const Point middle{dice_.between(0.3, 0.7), dice_.between(0.3, 0.7)};
    const double radius = dice_.between(0.05, 0.25), first = dice_.between(0, 2 * std::numbers::pi);
    if (dice_.happens(0.5)) {
      Chain chain;
      const int count = 3 + dice_.below(3);
      for (int i = 0; i < count; ++i) {
        const double angle = first + 2 * std::numbers::pi * i / count;
        chain.push_back(middle + radius * Point{std::cos(angle), std::sin(angle)});
      }
      const Point last = chain.back() - chain.front();
      chain.push_back(chain.front() + (tiny() / length(last)) * last);
      return {chain};
    }
    const Point along{std::cos(first), std::sin(first)}, beside{-along.y, along.x};
    const double apart = tiny();
    return {{middle - radius * along, middle + radius * along},
            {middle - 0.8 * radius * along + apart * beside, middle + 1.1 * radius * along + apart * beside}};
  }

  Chain near_boundary() {
    const double gap = dice_.magnitude_between(1e-12, 1e-6), across = coordinate();
    const Chain ends{{gap, across}, {1 - gap, across}, {across, gap}, {across, 1 - gap}};
    const Point end = ends[static_cast<std::size_t>(dice_.below(4))];
    return {place_apart_from(end), end};
  }

  std::vector<Chain> meeting_cracks() {
    const Chain one = inside(2);
    const Point between = one[0] + dice_.between(0.2, 0.8) * (one[1] - one[0]);
    const Point away = place_apart_from(between);
    switch (dice_.below(4)) {
      case 0:
        return {one, {between, away}};
      case 1:
        return {one, {away, between + 0.3 * (between - away)}};
      case 2:
        return {one, {one[1], place_apart_from(one[1])}};
      default:
        return {one, {away, between + tiny() * (1 / distance(away, between)) * (away - between)}};
    }
  }

  std::vector<Chain> cutting() {
    const Point left{0, coordinate()}, right{1, coordinate()};
    const Point low{coordinate(), 0}, high{coordinate(), 1};
    switch (dice_.below(4)) {
      case 0:
        return {{left, right}};
      case 1:
        return {{low, place(), right}};
      case 2:
        return {{left, right}, {low, high}};
      default:
        return {{left, Point{dice_.between(0.3, 0.7), dice_.between(0.3, 0.7)}, high}};
    }
  }

  Dice dice_;
  TriangleMesh mesh_;
};

MeshPlan mesh_of(Dice& dice, CrackKind kind) {
  MeshPlan plan;
  plan.side = dice.between(0.12, 0.25);
  const bool is_along = kind == CrackKind::along_sides && dice.happens(0.5);
  plan.angle_deg = is_along ? 0 : dice.between(0, 60);
  if (dice.happens(0.6)) plan.tip_side = dice.magnitude_between(0.005, 0.05);
  if (dice.happens(0.2)) plan.kind = MeshKind::unstructured;
  return plan;
}

CoverFunctions functions_by(Dice& dice) {
  if (dice.happens(0.7)) return CoverFunctions::derived;
  return dice.happens(0.5) ? CoverFunctions::constant : CoverFunctions::linear;
}

/// In flight there are no supports and loads: it rotates, and an initial stress makes it oscillate.
Problem flying(const Problem& at_rest) {
  Problem problem = at_rest;
  problem.analysis->velocity_carry_over = 1;
  problem.analysis->block_materials[0].initial_velocity = {1, -0.5, 0.8};
  problem.analysis->block_materials[0].initial_stress = {2e4, -1e4, 5e3};
  problem.covers->contact = CoverContact::felt;
  problem.covers->mesh.tip_functions = {};
  problem.covers->tractions.clear();
  problem.covers->displacements.clear();
  return problem;
}

double area_of(const Manifold& manifold) {
  double sum = 0;
  for (const ManifoldElement& element : manifold.elements)
    for (const Chain& loop : manifold.polygon(element)) sum += area(loop);
  return sum;
}

void look_at_tip(const TipReport& report, CracksTold& told) {
  ++told.tips;
  for (const DomainResult& domain : report.domains) {
    ++told.domains;
    const std::string name = name_of(domain.choice);
    if (!domain.factors) {
      ++told.refused_domains;
      const std::string nearest = report.tip.nearest;
      if (nearest.empty() || domain.refusal.find(nearest) == std::string::npos)
        told.failed.push_back(fmt::format("{} is refused and does not say why: '{}'", name, domain.refusal));
    } else if (!std::isfinite(domain.factors->k.mode_1 + domain.factors->k.mode_2 + domain.factors->j)) {
      told.failed.push_back(fmt::format("{} has no finite factors", name));
    }
  }
}

void rest(Scene scene, CracksTold& told) {
  told.area = std::abs(area_of(scene.model.continuum->manifold) - 1);
  LinearStepper stepper(std::move(scene));
  const auto made = stepper.advance();
  if (const auto* failure = std::get_if<StepFailure>(&made)) {
    told.has_free_piece = failure->reason.find("it has no support") != std::string::npos;
    if (!told.has_free_piece) told.failed.push_back(failure->reason);
    return;
  }
  told.residual = std::get<StepReport>(made).residual;
  const CoverSolution solution = *solution_of(stepper);
  for (const CrackTip& tip : solution.continuum.manifold.tips) look_at_tip(tip_report(solution, tip), told);
}

bool steps(StandardStepper& stepper, LedgerSums& sums, CracksTold& told) {
  for (int i = 0; i < 2; ++i) {
    const auto made = stepper.advance();
    sums.add(stepper.ledger());
    if (const auto* failure = std::get_if<StepFailure>(&made)) {
      told.failed.push_back(fmt::format("in flight: {}", failure->reason));
      return false;
    }
  }
  return true;
}

void fly(const Scene& whole, Scene cracked, CracksTold& told) {
  StandardStepper before(whole);
  LedgerSums sums;
  sums.add(before.ledger());
  if (!steps(before, sums, told)) return;
  int number = static_cast<int>(whole.model.elements.size());
  const Table<ElementIndex, ElementIndex> parents = parents_by_place(before.model(), cracked.model);
  StandardStepper after(before, change_between(before.model(), std::move(cracked), parents, number));
  const LedgerRow then = before.ledger(), now = after.ledger();
  told.carried = std::max(distance(now.momentum.linear, then.momentum.linear) / then.momentum_size.linear,
                          std::abs(now.momentum.angular - then.momentum.angular) / then.momentum_size.angular);
  if (!steps(after, sums, told)) return;
  told.linear = sums.linear_momentum_closure();
  told.angular = sums.angular_momentum_closure();
  told.energy = sums.energy_closure();
}

}  // namespace

const char* name_of(CrackKind kind) {
  constexpr const char* kNames[kCrackKinds] = {"anywhere",      "through nodes", "along sides",   "nearly closed",
                                               "near boundary", "meeting",       "cutting in two"};
  return kNames[static_cast<int>(kind)];
}

Problem random_cracks(CrackKind kind, unsigned seed) {
  Dice dice(1000 * static_cast<unsigned>(kind) + seed);
  Problem problem;
  Blocks blocks;
  blocks.blocks = {kSquare};
  problem.geometry = blocks;
  problem.analysis = plain_analysis(1e-4, 1);
  problem.analysis->gravity = 0;
  problem.analysis->velocity_carry_over = 0;
  problem.analysis->block_materials[0].unit_weight = 0;
  problem.analysis->joint_materials[0].friction_angle_deg = 30;
  CoverPlan plan;
  plan.functions = functions_by(dice);
  plan.contact = CoverContact::ignored;
  plan.mesh = mesh_of(dice, kind);
  if (plan.functions != CoverFunctions::constant && dice.happens(0.3))
    plan.mesh.tip_functions = {TipFunctions::williams, dice.happens(0.5) ? 0.1 : 0};
  plan.displacements = {{{{0, 0}, {1, 0}}, Held::both, formula(0), formula(0), formula(0), {}},
                        {{{1, 1}, {0, 1}}, Held::both, formula(2e-4), formula(1e-3), formula(0), {}}};
  plan.tractions = {{{{1, 0}, {1, 1}}, formula(1e6), formula(0), formula(0), {}},
                    {{{0, 1}, {0, 0}}, formula(-5e5), formula(2e5), formula(0), {}}};
  for (Chain& chain : CrackDice(seed, plan.mesh).chains(kind)) plan.cracks.push_back({std::move(chain), {}});
  problem.covers = plan;
  return problem;
}

CracksTold told_of_cracks(const Problem& problem) {
  CracksTold told;
  Scene at_rest;
  try {
    at_rest = prepare(problem, "standard", {}).scene;
  } catch (const InputError& error) {
    told.refused = error.what();
    return told;
  }
  try {
    rest(std::move(at_rest), told);
  } catch (const std::exception& error) {
    told.failed.push_back(fmt::format("at rest: {}", error.what()));
  }
  try {
    const Problem cracked = flying(problem);
    Problem whole = cracked;
    whole.covers->cracks.clear();
    fly(prepare(whole, "standard", {}).scene, prepare(cracked, "standard", {}).scene, told);
  } catch (const InputError& error) {
    told.unfit_to_fly = *problem.covers->functions == CoverFunctions::linear;
    if (!told.unfit_to_fly) told.failed.push_back(fmt::format("in flight: {}", error.what()));
  } catch (const std::exception& error) {
    told.failed.push_back(fmt::format("in flight: {}", error.what()));
  }
  return told;
}

}  // namespace keyblock::support
