// Finds the energy of impulses and pushes, by connected set, as quadratic functions of a part of them; see
// impulse_energy.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/impulse_energy.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "contact/find/connected_sets.hpp"
#include "contact/rows/gap.hpp"
#include "step/time/ledger.hpp"

namespace keyblock {
namespace {

// Impulses that gain less than this fraction of their work gain nothing but round-off.
constexpr double kNoGain = 1e-12;

// Pushes may raise the kinetic energy of a set by this fraction of it beyond what its contacts took. Bodies that slide
// gain as much by round-off, and their contacts must keep no velocity.
constexpr double kGainOfPushes = 1e-6;

bool may_pull(const ContactLaw& law) {
  return law.is_bonded || law.force.least < 0;
}

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

PushedSets::PushedSets(const ClosingStep& of) : of_(of) {
  const Model& model = of.scene.model;
  Touches closed;
  for (std::size_t i = 0; i < of.touches.size(); ++i)
    if (of.closed[i]) closed.push_back(of.touches[i]);
  numbers_ = ConnectedSets(model, pairs_of(model, closed), {}).numbers();
  has_bond_.resize(numbers_.size());
  for (std::size_t i = 0; i < of.touches.size(); ++i)
    if (of.closed[i] && may_pull(of.smooth.laws[i])) has_bond_[set_of(i)] = true;
}

std::size_t PushedSets::set_of(std::size_t contact) const {
  const Model& model = of_.scene.model;
  const Touch& touch = of_.touches[contact];
  const ElementIndex e = model.vertices[touch.vertex].element;
  const ElementIndex movable = model.elements[e].can_move() ? e : model.vertices[touch.start].element;
  return numbers_[static_cast<std::size_t>(movable.value)];
}

std::vector<double> PushedSets::taken_by(const std::vector<std::size_t>& contacts) const {
  const auto at_start = vertices_at(of_.scene.model, of_.scene.reference, of_.start.q);
  const auto at_end = vertices_at(of_.scene.model, of_.scene.reference, of_.smooth.q);
  const Eigen::VectorXd way = rates(of_.smooth.rows, plus(of_.smooth.q, -1, of_.start.q));
  std::vector<double> taken(numbers_.size());
  for (const std::size_t i : contacts) {
    const auto t = static_cast<Eigen::Index>(2 * i + 1);
    taken[set_of(i)] += energy_of_closing(of_, i, at_start, at_end) - of_.smooth.forces[t] * way[t];
  }
  return taken;
}

double PushedSets::take_gain(const UnknownsTable& before, const std::vector<std::size_t>& pushed,
                             UnknownsTable& velocities) const {
  UnknownsTable change = plus(velocities, -1, before);
  const UnknownsTable had = momentum(of_.scene, before);
  const UnknownsTable given = momentum(of_.scene, change);
  std::vector<double> energy(numbers_.size()), slope(numbers_.size()), curvature(numbers_.size());
  for (const ElementIndex e : indices(before)) {
    const std::size_t set = numbers_[static_cast<std::size_t>(e.value)];
    energy[set] += before[e].dot(had[e]) / 2;
    slope[set] += before[e].dot(given[e]);
    curvature[set] += change[e].dot(given[e]);
  }
  const auto gains = [&](std::size_t s) { return slope[s] + curvature[s] / 2 > kGainOfPushes * energy[s]; };
  std::vector<std::size_t> gaining;
  for (std::size_t s = 0; s < numbers_.size(); ++s)
    if (gains(s)) gaining.push_back(s);
  if (gaining.empty()) return 1;
  const std::vector<double> taken = taken_by(pushed);
  std::vector<double> part(numbers_.size(), 1);
  for (const std::size_t s : gaining) {
    const double most = std::max(0.0, taken[s]);
    if (slope[s] + curvature[s] / 2 <= kGainOfPushes * energy[s] + most) continue;
    part[s] = (std::sqrt(slope[s] * slope[s] + 2 * curvature[s] * most) - slope[s]) / curvature[s];
  }
  for (const ElementIndex e : indices(change)) change[e] *= part[numbers_[static_cast<std::size_t>(e.value)]];
  velocities = plus(before, 1, change);
  return std::ranges::min(part);
}

double energy_of_closing(const ClosingStep& of, std::size_t contact, const Table<VertexIndex, Point>& at_start,
                         const Table<VertexIndex, Point>& at_end) {
  const Touch& touch = of.touches[contact];
  const ContactLaw& law = of.smooth.laws[contact];
  const double gap = gap_of(touch, at_end);
  const double kept = law.normal_compliance > 0 ? std::max(0.0, law.rest_gap - gap) : 0;
  return -of.smooth.forces[static_cast<Eigen::Index>(2 * contact)] * (gap - gap_of(touch, at_start) + kept);
}

}  // namespace keyblock
