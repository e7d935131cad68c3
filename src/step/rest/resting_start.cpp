// Searches for an equilibrium, leaves out bodies without one, and searches again; see resting_start.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rest/resting_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "base/sentences/sentences.hpp"
#include "contact/find/connected_sets.hpp"
#include "model/continuum.hpp"
#include "model/shared_covers.hpp"
#include "step/newton/tolerances.hpp"
#include "step/rest/elements_of_motion.hpp"
#include "step/rest/moving_start.hpp"
#include "step/rest/static_shares.hpp"
#include "step/rest/static_step.hpp"
#include "step/rest/stressed_start.hpp"
#include "step/scene/equilibrium.hpp"
#include "step/scene/touch_search.hpp"

namespace keyblock {
namespace {

using namespace tolerances;

/// Returns the sets of bodies connected by contacts that are no impact, across the rounding of drawings, or by bolts.
ConnectedSets connected_bodies(const StandardScene& scene, const Motion& start) {
  const Scales scales = scales_of(scene, loads_at(scene, start.q, 0), start.q, start.v);
  std::vector<ElementPair> pairs =
      pairs_of(scene.model, meeting_touches(scene, start, scales, of_gaps::kDrawnTogether * scales.size));
  std::vector<ElementIndex> supported;
  const std::vector<int> bodies = body_numbers(scene.model);
  std::vector<ElementIndex> first(bodies.size());
  for (const ElementIndex e : indices(scene.model.elements)) {
    ElementIndex& of_body = first[static_cast<std::size_t>(bodies[static_cast<std::size_t>(e.value)])];
    if (!of_body) of_body = e;
    pairs.push_back({of_body, e});
    if (scene.model.elements[e].can_move() && scene.groups.of(e).is_supported(e)) supported.push_back(e);
  }
  for (const HeldPair& pair : scene.held) supported.push_back(pair.element);
  return {scene.model, std::move(pairs), supported};
}

Stress times(double share, const Stress& s) {
  return {share * s.xx, share * s.yy, share * s.xy, share * s.zz};
}

void scale_stress(std::vector<BlockMaterial>& materials, double share) {
  for (BlockMaterial& material : materials) {
    material.initial_stress = times(share, material.initial_stress);
    material.stress_gradient = times(share, material.stress_gradient);
  }
}

/// Returns the scene with a share of its loads and of its initial stress.
StandardScene with_share(const StandardScene& scene, double share, bool is_stressed) {
  StandardScene small = scene;
  if (is_stressed) {
    Model model = scene.model;
    scale_stress(model.block_materials, share);
    if (model.continuum) {
      const auto continuum = std::make_shared<Continuum>(*model.continuum);
      scale_stress(continuum->materials, share);
      if (const auto whole = continuum->initial_stress)
        continuum->initial_stress = [whole, share](Point x) { return times(share, whole(x)); };
      model.continuum = continuum;
    }
    small = standard_scene(std::move(model), scene.settings);
    small.unloaded = scene.unloaded;
    small.pulls = scene.pulls;
  }
  small.load_share = share;
  return small;
}

class RestSearch {
 public:
  RestSearch(StandardScene& scene, const Motion& start)
      : scene_(scene),
        start_(start),
        still_(at_rest(start)),
        connected_(connected_bodies(scene, still_)),
        left_(scene.model.elements.size(), false) {
    std::vector<ElementIndex> free;
    for (ElementIndex e : movable())
      if (is_moving(e) || !connected_.is_held(e)) free.push_back(e);
    leave_out(free);
  }

  RestingStart run() {
    for (int search = 1; !movable().empty(); ++search) {
      scene_.unloaded = left_;
      StandardStep made = first_equilibrium(scene_, still_, 0, of_resting_start::kMostIterations);
      const bool is_found = made.converged && made.failure.empty();
      const std::vector<ElementIndex> restless = is_found ? elsewhere(made.motion) : to_blame(made);
      if (is_found && restless.empty()) {
        result_.is_found = true;
        return moved(with_kept(left_, start_, std::move(made.motion)));
      }
      tell(is_found ? fmt::format("{} has its equilibrium away from the drawing", in_words(scene_, {restless.front()}))
                    : why_not(made));
      const bool is_last = search == of_resting_start::kMostSearches;
      tell_of_left_out(is_last ? movable() : restless);
      leave_out(is_last ? movable() : restless);
    }
    return moved(start_);
  }

 private:
  static Motion at_rest(Motion motion) {
    motion.v.set_zero();
    return motion;
  }

  bool is_moving(ElementIndex e) const {
    return scene_.model.material_of(scene_.model.elements[e]).initial_velocity != Velocity{};
  }

  /// Returns movable elements that are still in the search.
  std::vector<ElementIndex> movable() const {
    std::vector<ElementIndex> all;
    for (ElementIndex e : indices(scene_.model.elements))
      if (scene_.model.elements[e].can_move() && !left_[static_cast<std::size_t>(e.value)]) all.push_back(e);
    return all;
  }

  void leave_out(const std::vector<ElementIndex>& some) {
    std::set<std::size_t> sets;
    for (const ElementIndex e : some) sets.insert(connected_.of(e));
    for (const ElementIndex e : movable())
      if (sets.contains(connected_.of(e))) left_[static_cast<std::size_t>(e.value)] = true;
  }

  int count_of(const ChosenElements& chosen) const {
    const std::vector<int> bodies = body_numbers(scene_.model);
    std::set<int> counted;
    for (std::size_t i = 0; i < chosen.size(); ++i)
      if (chosen[i]) counted.insert(bodies[i]);
    return static_cast<int>(counted.size());
  }

  // Returns the elements that the search names; if none of them is in the search, all that are.
  std::vector<ElementIndex> to_blame(const StandardStep& made) const {
    std::vector<ElementIndex> named = made.moving;
    if (named.empty() && made.converged) named = balance_of(scene_, at_rest(made.motion), 0).blocks;
    std::erase_if(named, [&](ElementIndex e) { return left_[static_cast<std::size_t>(e.value)]; });
    return named.empty() ? movable() : named;
  }

  static std::string why_not(const StandardStep& made) {
    return sentence_of(made.failure.empty() ? Finding{"no_contact_forces_found"} : made.failure);
  }

  void tell(const std::string& why) { result_.unbalanced += (result_.unbalanced.empty() ? "" : "; ") + why; }
  void tell_of_left_out(const std::vector<ElementIndex>& some) {
    named_.push_back(some.size() == movable().size()
                         ? "all remaining bodies"
                         : fmt::format("{} and bodies connected to it", in_words(scene_, some)));
  }

  /// Greatest displacement of a vertex over the size of its body, per connected set, with the element that moved so
  /// far.
  struct Way {
    double share = 0;
    ElementIndex element;
  };
  std::vector<Way> ways_to(const Motion& motion) {
    const auto before = vertices_at(scene_.model, scene_.reference, still_.q);
    const auto after = vertices_at(scene_.model, scene_.reference, motion.q);
    std::vector<Way> ways(scene_.model.elements.size());
    for (const ElementIndex e : movable())
      for (const VertexIndex v : scene_.model.elements[e].vertices()) {
        const double share = distance(before[v], after[v]) / scene_.bodies()[e].size;
        if (Way& way = ways[connected_.of(e)]; share > way.share) way = {share, e};
      }
    return ways;
  }

  // Returns one element per connected set that moved to another place and did not merely deform.
  std::vector<ElementIndex> elsewhere(const Motion& motion) {
    std::vector<Way> ways = ways_to(motion);
    std::erase_if(ways, [](const Way& way) { return !(way.share > of_resting_start::kInPlace); });
    if (ways.empty()) return {};
    const bool is_stressed = keyblock::is_stressed(scene_, still_.q);
    const StandardScene small = with_share(scene_, of_resting_start::kSmallShare, is_stressed);
    Motion from = still_;
    if (is_stressed) {
      from.points = start_motion(small).points;
      if (from.closed.size() > 0) from.closed = stressed_contacts(small, from);
    }
    std::vector<Way> small_ways;
    const StandardStep made = static_step(small, from, 0, of_resting_start::kMostIterations);
    if (made.converged && made.failure.empty()) small_ways = ways_to(made.motion);
    std::vector<ElementIndex> away;
    for (const Way& way : ways)
      if (small_ways.empty() ? way.share > of_resting_start::kInPlaceUntried
                             : small_ways[connected_.of(way.element)].share > of_resting_start::kSameWay * way.share)
        away.push_back(way.element);
    return away;
  }

  // Lets supported sets without equilibrium begin to move, and returns the result. Bodies that strike others at once
  // have no contact that could carry them: they stay as they are.
  RestingStart moved(Motion rested) {
    const ConnectedSets touching = connected_bodies(scene_, start_);
    ChosenElements moving(left_.size(), false), flying = moving, others = moving;
    for (const ElementIndex e : indices(scene_.model.elements)) {
      const auto i = static_cast<std::size_t>(e.value);
      moving[i] = left_[i] && touching.is_held(e);
      flying[i] = left_[i] && !moving[i];
      others[i] = scene_.model.elements[e].can_move() && !moving[i];
    }
    scene_.unloaded = flying;
    std::optional<Motion> made;
    if (std::ranges::find(moving, true) != moving.end()) made = moving_start(scene_, rested);
    if (made) {
      result_.moving = count_of(moving);
      result_.motion = with_kept(others, rested, std::move(*made));
    } else {
      result_.motion = std::move(rested);
    }
    result_.sudden = count_of(made ? flying : left_);
    if (!named_.empty())
      result_.unbalanced += fmt::format("; {} {}", fmt::join(named_, ", "),
                                        made ? "begin to move under contact forces that fit" : "are suddenly loaded");
    return std::move(result_);
  }

  // Returns `motion` with the chosen elements as in `from`, and the velocities of the start.
  Motion with_kept(const ChosenElements& chosen, const Motion& from, Motion motion) const {
    motion = with_elements_of(scene_, chosen, from, std::move(motion));
    motion.v = start_.v;
    return motion;
  }

  StandardScene& scene_;
  const Motion& start_;
  Motion still_;  ///< initial state without velocities
  ConnectedSets connected_;
  ChosenElements left_;             ///< elements out of the search
  std::vector<std::string> named_;  ///< bodies that it left out
  RestingStart result_;
};

}  // namespace

RestingStart resting_start(StandardScene scene, const Motion& start) {
  return RestSearch(scene, start).run();
}

}  // namespace keyblock
