// Sorts connected sets by force, and fixes all others in the scene of a lot; see lots.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/lots.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "contact/find/connected_sets.hpp"
#include "model/basis.hpp"
#include "step/newton/tolerances.hpp"
#include "step/scene/set_shares.hpp"
#include "step/scene/touch_search.hpp"

namespace keyblock {
namespace {

Motion at_rest(Motion motion) {
  motion.v.set_zero();
  return motion;
}

// Returns the model in which the other elements cannot move, without their bolts and supports.
Model with_others_fixed(Model model, const ChosenElements& others) {
  const auto is_other = [&](ElementIndex e) { return others[static_cast<std::size_t>(e.value)]; };
  const auto holds = [&](ElementIndex e) { return is_other(e) || !model.elements[e].can_move(); };
  std::erase_if(model.bolts, [&](const Bolt& bolt) { return holds(bolt.first.element) && holds(bolt.second.element); });
  std::erase_if(model.support_rows, [&](const SupportRow& row) { return is_other(row.element); });
  for (const ElementIndex e : indices(model.elements))
    if (is_other(e)) model.elements[e].basis = &fixed_basis();
  return model;
}

ChosenElements others_of(const StandardScene& scene, const ChosenElements& chosen) {
  ChosenElements others(chosen.size());
  for (const ElementIndex e : indices(scene.model.elements)) {
    const auto i = static_cast<std::size_t>(e.value);
    others[i] = !chosen[i] && scene.model.elements[e].can_move();
  }
  return others;
}

void add(StandardStep& all, StandardStep&& own) {
  all.solves += own.solves;
  all.fallbacks += own.fallbacks;
  all.halvings += own.halvings;
  all.account += own.account;
  all.keep_larger_residual(own);
  for (const std::size_t i : own.undecided) all.undecided.push_back(all.touches.size() + i);
  all.touches.insert(all.touches.end(), own.touches.begin(), own.touches.end());
  all.converged = own.converged;
  all.end = own.end;
  all.failure = std::move(own.failure);
  all.moving = std::move(own.moving);
}

}  // namespace

std::vector<ChosenElements> lots_of(const StandardScene& scene, const Motion& motion, double time) {
  if (scene.model.shares_unknowns() || may_yield(scene)) return {};
  const Motion still = at_rest(motion);
  const UnknownsTable loads = loads_at(scene, still.q, time);
  const Scales scales = scales_of(scene, loads, still.q, still.v);
  Touches touches = meeting_touches(scene, still, scales, tolerances::of_gaps::kDrawnTogether * scales.size);
  for (const ClosedContact& contact : still.closed.all()) touches.push_back(contact.touch);
  const ConnectedSets sets(scene.model, pairs_of(scene.model, touches), {});
  std::map<std::size_t, double> forces;
  for (const ElementIndex e : indices(scene.bodies())) {
    if (loads[e].size() == 0) continue;
    double& force = forces[sets.of(e)];
    force = std::max(force, largest_load(scene.bodies()[e], loads[e]));
  }
  std::vector<std::pair<double, std::size_t>> sorted;
  for (const auto& [set, force] : forces) sorted.emplace_back(force, set);
  std::ranges::sort(sorted);
  std::vector<std::size_t> lot_of(scene.model.elements.size());
  std::size_t count = 0;
  double least = 0;  // of the lot
  for (const auto& [force, set] : sorted) {
    if (count == 0 || force > kAlikeForces * least) {
      ++count;
      least = force;
    }
    lot_of[set] = count - 1;
  }
  if (count < 2) return {};
  std::vector<ChosenElements> lots(count, ChosenElements(scene.model.elements.size(), false));
  for (const ElementIndex e : indices(scene.bodies()))
    if (loads[e].size() > 0) lots[lot_of[sets.of(e)]][static_cast<std::size_t>(e.value)] = true;
  return lots;
}

bool one_meets_another(const StandardScene& scene, const std::vector<ChosenElements>& lots, const Motion& motion) {
  const Motion still = at_rest(motion);
  const Scales scales = scales_at(scene, still, 0);
  const std::vector<ElementPair> pairs = pairs_of(scene.model, touches_of(scene, still, scales, 0));
  return std::ranges::any_of(pairs, [&](const ElementPair& pair) {
    if (!scene.model.elements[pair.lower].can_move() || !scene.model.elements[pair.upper].can_move()) return false;
    const auto has = [](const ChosenElements& lot, ElementIndex e) { return lot[static_cast<std::size_t>(e.value)]; };
    return std::ranges::any_of(lots,
                               [&](const ChosenElements& lot) { return has(lot, pair.lower) != has(lot, pair.upper); });
  });
}

Lot::Lot(const StandardScene& whole, ChosenElements chosen) : whole_(whole), chosen_(std::move(chosen)) {
  const ChosenElements others = others_of(whole, chosen_);
  scene_ = standard_scene(with_others_fixed(whole.model, others), whole.settings);
  scene_.load_share = whole.load_share;
  std::erase_if(scene_.with_faces, [&](ElementIndex e) { return others[static_cast<std::size_t>(e.value)]; });
  const auto is_chosen = [&](ElementIndex e) { return chosen_[static_cast<std::size_t>(e.value)]; };
  for (std::size_t i = 0; i < whole.model.bolts.size(); ++i)
    if (is_chosen(whole.model.bolts[i].first.element) || is_chosen(whole.model.bolts[i].second.element))
      bolts_.push_back(i);
  for (std::size_t i = 0; i < whole.held.size(); ++i)
    if (is_chosen(whole.held[i].element)) held_.push_back(i);
}

bool Lot::is_own(VertexIndex one, VertexIndex other) const {
  const auto is_chosen = [&](VertexIndex v) {
    return chosen_[static_cast<std::size_t>(whole_.model.vertices[v].element.value)];
  };
  return is_chosen(one) || is_chosen(other);
}

void Lot::copy(const Motion& from, Motion& to) const {
  for (const auto& group : whole_.groups) group->put_back(chosen_, from, to);
  for (const ElementIndex e : indices(whole_.model.elements))
    if (chosen_[static_cast<std::size_t>(e.value)]) to.v[e] = from.v[e];
  std::vector<ClosedContact> closed = to.closed.all();
  for (const ClosedContact& contact : from.closed.all())
    if (is_own(contact.touch.vertex, contact.touch.start)) closed.push_back(contact);
  to.closed = ClosedContacts(std::move(closed));
  for (const auto& bond : from.bonds)
    if (is_own(bond.first.lower, bond.first.upper)) to.bonds.insert(bond);
}

Motion Lot::part_of(const Motion& all) const {
  Motion own = start_motion(scene_);
  copy(all, own);
  for (std::size_t i = 0; i < bolts_.size(); ++i) {
    own.constraints.bolt_forces[i] = all.constraints.bolt_forces[bolts_[i]];
    own.constraints.broken[i] = all.constraints.broken[bolts_[i]];
  }
  for (std::size_t i = 0; i < held_.size(); ++i)
    own.constraints.point_forces.segment<2>(static_cast<Eigen::Index>(2 * i)) =
        all.constraints.point_forces.segment<2>(static_cast<Eigen::Index>(2 * held_[i]));
  return own;
}

void Lot::put(const Motion& own, Motion& all) const {
  copy(own, all);
  for (std::size_t i = 0; i < bolts_.size(); ++i) {
    all.constraints.bolt_forces[bolts_[i]] = own.constraints.bolt_forces[i];
    all.constraints.broken[bolts_[i]] = own.constraints.broken[i];
  }
  for (std::size_t i = 0; i < held_.size(); ++i)
    all.constraints.point_forces.segment<2>(static_cast<Eigen::Index>(2 * held_[i])) =
        own.constraints.point_forces.segment<2>(static_cast<Eigen::Index>(2 * i));
}

StandardStep equilibrium_of_lots(StandardScene& scene, const Motion& motion, const LoadStep& step) {
  const std::vector<ChosenElements> lots = lots_of(scene, motion, step.to);
  if (lots.empty()) return static_equilibrium(scene, motion, step);
  StandardStep all;
  all.motion = motion;
  all.motion.closed = {};
  all.motion.bonds = {};
  double load_share = 1;
  for (const ChosenElements& chosen : lots) {
    Lot lot(scene, chosen);
    StandardStep made = static_equilibrium(lot.scene(), lot.part_of(motion), step);
    load_share = lot.scene().load_share;
    lot.put(made.motion, all.motion);
    add(all, std::move(made));
    if (!all.converged || !all.failure.empty()) break;
  }
  const bool is_found = all.converged && all.failure.empty();
  if (!is_found || one_meets_another(scene, lots, all.motion)) {
    StandardStep whole = static_equilibrium(scene, motion, step);  // names all blocks that move, not those of one lot
    if (is_found || !whole.converged || !whole.failure.empty()) return whole;
  }
  scene.load_share = load_share;
  return all;
}

}  // namespace keyblock
