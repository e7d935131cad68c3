// Finds the energy that impulses take as a quadratic function of their part with rebound; see impulse_energy.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/impulse_energy.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "contact/find/connected_sets.hpp"

namespace keyblock {
namespace {

// Impulses that gain less than this fraction of their work gain nothing but round-off.
constexpr double kNoGain = 1e-12;

// Energies of connected sets, by the number of a set.
using SetEnergies = std::map<std::size_t, double>;

// Root of c + b x + a x² in [0, 1], where it is ≥ 0 at 0, negative at 1, and a ≤ 0.
double last_root(double c, double b, double a) {
  const double root = std::sqrt(b * b - 4 * a * c);
  const double x = b > 0 ? (b + root) / (-2 * a) : 2 * c / (root - b);
  return std::isfinite(x) ? std::clamp(x, 0.0, 1.0) : 0;
}

// Returns the sets of the contacts, then of the fixed points.
std::vector<std::size_t> sets_of(const JumpRows& of) {
  std::vector<ElementIndex> supported;
  for (const HeldPair& pair : of.scene.held) supported.push_back(pair.element);
  const Model& model = of.scene.model;
  const ConnectedSets sets(model, pairs_of(model, of.touches), supported);
  std::vector<std::size_t> numbers;
  for (const Touch& touch : of.touches) {
    const ElementIndex e = model.vertices[touch.vertex].element;
    numbers.push_back(sets.of(model.elements[e].can_move() ? e : model.vertices[touch.start].element));
  }
  for (const ElementIndex e : supported) numbers.push_back(sets.of(e));
  return numbers;
}

Eigen::VectorXd half_change(const JumpRows& of, const Eigen::VectorXd& impulses) {
  return rates(of.rows, answer(of.rows, of.flexibility, impulses)) / 2;
}

}  // namespace

void take_gain(const JumpRows& of, const std::function<FrictionalSolution()>& stopped, FrictionalSolution& bouncing) {
  const std::vector<std::size_t> sets = sets_of(of);
  const auto taken = [&](const Eigen::VectorXd& p, const Eigen::VectorXd& u) {  // −Σ p·u of the contacts
    SetEnergies energies;
    for (std::size_t i = 0; i < of.touches.size(); ++i) {
      const auto n = static_cast<Eigen::Index>(2 * i);
      energies[sets[i]] -= p.segment<2>(n).dot(u.segment<2>(n));
    }
    return energies;
  };
  const SetEnergies all = taken(bouncing.forces, of.before + half_change(of, bouncing.forces));
  const double round_off = kNoGain * bouncing.forces.cwiseAbs().dot(of.before.cwiseAbs());
  const auto gains = [&](std::size_t set) { return all.contains(set) && all.at(set) < -round_off; };
  if (std::ranges::none_of(sets, gains)) return;
  const FrictionalSolution without = stopped();
  bouncing.solves += without.solves;
  if (!without.converged) return;
  const Eigen::VectorXd way = bouncing.forces - without.forces;
  const Eigen::VectorXd at_first = of.before + half_change(of, without.forces);
  const Eigen::VectorXd change = half_change(of, way);
  SetEnergies first = taken(without.forces, at_first);
  SetEnergies linear = taken(without.forces, change);
  for (const auto& [set, energy] : taken(way, at_first)) linear[set] += energy;
  SetEnergies square = taken(way, change);
  for (std::size_t i = 0; i < sets.size(); ++i) {
    if (!gains(sets[i])) continue;
    const double part = last_root(std::max(0.0, first[sets[i]]), linear[sets[i]], square[sets[i]]);
    const auto n = static_cast<Eigen::Index>(2 * i);
    bouncing.forces.segment<2>(n) = without.forces.segment<2>(n) + part * way.segment<2>(n);
  }
}

}  // namespace keyblock
