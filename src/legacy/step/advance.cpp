// Performs a step: detect, transfer, assemble, open-close, accept or redo, update (legacy-rules 1).
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/step/advance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/listed.hpp"
#include "base/words/plain_number.hpp"
#include "geometry/polygon.hpp"
#include "legacy/contact/carry.hpp"
#include "legacy/contact/detect.hpp"
#include "legacy/step/motion.hpp"
#include "legacy/step/open_close.hpp"
#include "legacy/step/penalty.hpp"
#include "legacy/step/start_state.hpp"
#include "legacy/step/update.hpp"
#include "model/material_choices.hpp"
#include "model/shared_covers.hpp"

namespace keyblock {
namespace {

constexpr double kGreatestRatio = 3;     // a larger displacement over the allowance cuts the step
constexpr double kUnsettledCut = 0.3;    // automatic step: cut after passes without an end
constexpr double kSmallestShare = 0.01;  // smallest fraction of the given step after a cut

// In the published source only acceptance leaves the loop around a step.

// The Berkeley program updates its contact count only for contacts that were not exchanged. A step that finds none of
// these keeps the last list, as open contacts (legacy-rules 3, stale list).
Contacts with_stale_contacts(Detection found, const Contacts& previous) {
  if (!found.all_exchanged) return std::move(found.contacts);
  Contacts contacts = previous;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (i < found.contacts.size()) {
      contacts[i] = found.contacts[i];
      continue;
    }
    contacts[i].state = contacts[i].state_before = ContactState::open;
    contacts[i].bonded = false;
    contacts[i].ratio = contacts[i].length = 0;
  }
  return contacts;
}

Contacts contacts_of_step(const ShiScene& scene, Stepping& stepping) {
  if (!scene.has_contact) return {};
  const State& state = stepping.state;
  const BerkeleyQuirks& quirks = scene.settings.quirks;
  Detection found = detect(scene.model, state, scene.settings, scene.rules, stepping.near);
  Contacts contacts =
      quirks.stale_contact_list ? with_stale_contacts(std::move(found), stepping.contacts) : std::move(found.contacts);
  contacts = carry(std::move(contacts), stepping.contacts, state, scene.rules, quirks);
  if (state.step > 0) return contacts;
  return is_static(scene.settings, scene.model) ? start_open(std::move(contacts))
                                                : start_closed(std::move(contacts), state, scene.rules);
}

double step_size(const ShiScene& scene, const Stepping& stepping) {
  if (stepping.state.step > 0) return next_step_size(scene.model, stepping.state, scene.settings, stepping.history);
  const double speed = greatest_start_speed(scene.model, scene.settings);
  return first_step_size(scene.model, stepping.state, scene.settings, speed);
}

// Returns pairs of elements with a contact, open ones included, or a bolt between them.
BlockMatrix::Pairs coupled_elements(const Model& model, const Contacts& contacts) {
  BlockMatrix::Pairs pairs;
  const auto couple = [&](ElementIndex a, ElementIndex b) {
    if (a == b) return;
    const std::pair<int, int> pair = std::minmax(a.value, b.value);
    if (pairs.empty() || pairs.back() != pair) pairs.push_back(pair);  // contacts of a pair are consecutive
  };
  for (const Contact& contact : contacts)
    couple(model.vertices[contact.first.vertex].element, model.vertices[contact.first.start].element);
  for (const Bolt& bolt : model.bolts) couple(bolt.first.element, bolt.second.element);
  std::ranges::sort(pairs);
  const auto repeated = std::ranges::unique(pairs);
  pairs.erase(repeated.begin(), repeated.end());
  return pairs;
}

// Returns the number of matrix blocks in a step: covers, and pairs of covers that share an element or a coupling.
int matrix_blocks(const Model& model, const BlockMatrix::Pairs& coupled) {
  const auto elements = static_cast<int>(model.elements.size());
  if (model.nodes.empty()) return elements + static_cast<int>(coupled.size());
  BlockMatrix::Pairs pairs;
  const auto couple = [&](ElementIndex first, ElementIndex second) {
    for (const int a : model.elements[first].covers)
      for (const int b : model.elements[second].covers)
        if (a != b) pairs.push_back(std::minmax(a, b));
  };
  const std::vector<bool> nodes = carrying_nodes(model);
  auto covers = static_cast<std::size_t>(std::ranges::count(nodes, true));
  for (ElementIndex e : indices(model.elements)) {
    if (model.elements[e].is_on_covers())
      couple(e, e);
    else
      ++covers;
  }
  for (const auto& [a, b] : coupled) couple(ElementIndex{a}, ElementIndex{b});
  std::ranges::sort(pairs);
  const auto repeated = std::ranges::unique(pairs);
  return static_cast<int>(covers + pairs.size() - repeated.size());
}

enum class Verdict { accepted, contacts_unsettled, moved_too_far, too_deep };

// Tries the same step repeatedly, each time with its own step size and stiffness.
class Attempts {
 public:
  Attempts(const ShiScene& scene, Stepping& stepping)
      : scene_(scene),
        settings_(scene.settings),
        stepping_(stepping),
        start_(stepping.state),
        contacts_(contacts_of_step(scene, stepping)),
        coupled_(coupled_elements(scene.model, contacts_)),
        dt_(step_size(scene, stepping)),
        penalty_(stepping.penalty) {}

  std::variant<StepReport, StepFailure> run() {
    for (report_.redos = 0; report_.redos <= settings_.redo_limit; ++report_.redos) {
      const OpenCloseOutcome outcome = attempt();
      if (!outcome.failure.empty()) return failure(outcome.failure);
      contacts_ = outcome.contacts;
      unsettled_ = outcome.still_changing;
      verdict_ = judge_step(outcome);
      if (verdict_ == Verdict::accepted) return accept(outcome);
      if (at_floor_again_) return moved_too_far("blocks_move_too_far");
    }
    if (verdict_ == Verdict::moved_too_far) return moved_too_far("blocks_move_too_far:in_attempts");
    StepFailure found = failure(why_no_end());
    found.contacts = unsettled_;
    return found;
  }

 private:
  OpenCloseOutcome attempt() {
    if (start_.step > 0 && settings_.quirks.velocity_from_coming_step)
      start_ = with_velocity_of_last_step(scene_.model, std::move(start_), settings_, dt_);
    const System system = assemble(scene_.terms, {scene_.model, start_, settings_, dt_}, coupled_);
    const Attempt kind = !stepping_.has_solved ? Attempt::first_of_run
                         : report_.redos == 0  ? Attempt::first_of_step
                                               : Attempt::redone;
    OpenCloseOutcome outcome = open_close(system, contacts_, scene_.model, start_, settings_, scene_.rules, penalty_,
                                          dt_, kind, stepping_.solver);
    stepping_.has_solved = true;
    report_.passes += outcome.passes;
    report_.residual = std::max(report_.residual, outcome.residual);
    return outcome;
  }

  // The order is that of legacy-rules 11: passes without an end, displacement, penetration.
  Verdict judge_step(const OpenCloseOutcome& outcome) {
    const FarthestElement farthest = farthest_element(scene_.model, start_, outcome.increments, settings_.rotation);
    farthest_ = farthest.element;
    ratio_ = farthest.displacement / allowed();
    const double floor = kSmallestShare * settings_.time_step;
    const bool accepts_unfinished = settings_.quirks.fixed_pass_bound && settings_.pass_limit != kBerkeleyPassBound;
    if (!outcome.still_changing.empty() && !accepts_unfinished) {
      if (settings_.step_control == StepControl::shi) dt_ = std::max(kUnsettledCut * dt_, floor);
      return Verdict::contacts_unsettled;
    }
    if (!(ratio_ <= kGreatestRatio)) {  // also if it is NaN
      at_floor_again_ = dt_ <= floor;
      dt_ = std::max(floor, dt_ / std::sqrt(ratio_));  // the floor if it is NaN
      return Verdict::moved_too_far;
    }
    const AdaptedPenalty adapted = adapt(penalty_, misfit(contacts_), scene_.model.scale, settings_);
    used_penalty_ = penalty_;
    penalty_ = adapted.penalty;
    return adapted.redo ? Verdict::too_deep : Verdict::accepted;
  }

  std::variant<StepReport, StepFailure> accept(const OpenCloseOutcome& outcome) {
    State end = update(scene_.model, std::move(start_), settings_, outcome.increments, dt_, outcome.node_steps);
    if (const std::optional<ElementIndex> bad = impossible(end)) return gone_wrong(*bad);
    stepping_.state = std::move(end);
    stepping_.contacts = std::move(contacts_);
    report_.step = stepping_.state.step;
    report_.time = stepping_.state.time;
    report_.dt = dt_;
    report_.contacts = static_cast<int>(stepping_.contacts.size());
    report_.closed =
        static_cast<int>(std::ranges::count_if(stepping_.contacts, [](const Contact& c) { return !c.is_open(); }));
    report_.matrix_blocks = matrix_blocks(scene_.model, coupled_);
    report_.penalty = used_penalty_;
    report_.displacement_ratio = ratio_;
    report_.greatest_penetration = misfit(stepping_.contacts).penetration;
    report_.penetration_share = penetration_share(stepping_.contacts, scene_.model, stepping_.state);
    report_.unsettled_contacts = static_cast<int>(outcome.still_changing.size());
    stepping_.history = {dt_, ratio_, report_.greatest_penetration, used_penalty_};
    stepping_.penalty = penalty_;
    return report_;
  }

  Finding why_no_end() const {
    if (verdict_ != Verdict::contacts_unsettled) return {"contacts_stay_deep", {{{"attempts", report_.redos}}}};
    return {"contacts_without_end",
            {{{"unsettled", unsettled_.size()}, {"contacts", contacts_.size()}}, {{"names", unsettled_in_words()}}}};
  }

  StepFailure failure(Finding cause, FailureKind kind = FailureKind::undecided) const {
    return failed("in_step:shi", {{{"step", stepping_.state.step + 1}, {"time", stepping_.state.time}, {"dt", dt_}}},
                  std::move(cause), kind);
  }

  // Reports Shi's limit on the displacement of a step, with the block that exceeds it.
  StepFailure moved_too_far(const char* form) const {
    Facts facts = facts_of(farthest_);
    facts.numbers.insert(facts.numbers.end(), {{"displacement", ratio_ * allowed()},
                                               {"limit", kGreatestRatio * allowed()},
                                               {"limit_ratio", kGreatestRatio},
                                               {"attempts", report_.redos}});
    if (no_step_is_short_enough()) facts.numbers.emplace_back("last_ratio", stepping_.history.displacement_ratio);
    StepFailure found = failure({form, std::move(facts)});
    found.elements = {farthest_};
    return found;
  }

  // Bodies without forces move by D = v0 dt, with v0 = 2 D'/dt - v' from the last displacement D' (legacy-rules 7.4). D
  // tends to 2 D' as dt vanishes.
  bool no_step_is_short_enough() const {
    return settings_.quirks.velocity_from_coming_step && start_.step != 0 &&
           2 * stepping_.history.displacement_ratio > kGreatestRatio;
  }

  StepFailure gone_wrong(ElementIndex bad) const {
    StepFailure found = failure({"turned_inside_out:shi", facts_of(bad)}, FailureKind::inside_out);
    found.elements = {bad};
    return found;
  }

  double drawn_area(ElementIndex e) const {
    std::vector<Point> outline;
    const Element& element = scene_.model.elements[e];
    for (int i = 0; i < element.loop_sizes.front(); ++i)
      outline.push_back(scene_.model.start_vertices[static_cast<std::size_t>(element.first_vertex.value + i)]);
    return area(outline);
  }

  // Areas change as blocks rotate under Shi's rules, so that only the drawn area shows whether a block is a sliver.
  Facts facts_of(ElementIndex e) const {
    const ElementState& block = stepping_.state.elements[e];
    const double drawn = drawn_area(e);
    return {{{"area", block.moments.area},
             {"drawn_area", drawn},
             {"percent_of_mean", 100 * drawn / scene_.model.mean_area}},
            {},
            {e.value + 1},
            {{{block.centroid.x, block.centroid.y}}}};
  }

  double allowed() const { return settings_.allowed_displacement_ratio * scene_.model.scale; }

  // Names the first few contacts, with their blocks and positions.
  std::string unsettled_in_words() const {
    constexpr std::size_t kNamed = 3;
    std::string words;
    for (std::size_t i = 0; i < std::min(kNamed, unsettled_.size()); ++i) {
      const Triple& end = contacts_[unsettled_[i]].first;
      const Point at = start_.vertices[end.vertex];
      words += fmt::format("{}{} (block {} on block {} at {}, {})", i == 0 ? "" : ", ", unsettled_[i] + 1,
                           scene_.model.vertices[end.vertex].element.value + 1,
                           scene_.model.vertices[end.start].element.value + 1, plain(at.x), plain(at.y));
    }
    if (unsettled_.size() > kNamed) words += fmt::format(" and {} more", unsettled_.size() - kNamed);
    return words;
  }

  const ShiScene& scene_;
  const Settings& settings_;
  Stepping& stepping_;
  State start_;
  Contacts contacts_;
  BlockMatrix::Pairs coupled_;
  double dt_;
  double penalty_;
  double used_penalty_ = 0;
  double ratio_ = 0;
  ElementIndex farthest_;
  Verdict verdict_ = Verdict::accepted;
  bool at_floor_again_ = false;
  std::vector<std::size_t> unsettled_;
  StepReport report_;
};

}  // namespace

ShiScene shi_scene(Scene scene) {
  const Requirements needs = requirements(scene.model, scene.settings);
  const ContactRules rules = contact_rules(scene.model, scene.settings);
  return {std::move(scene), rules, terms_for(needs), needs.has(TermKind::contact)};
}

Stepping start(const ShiScene& scene) {
  Stepping stepping;
  stepping.state = start_state(scene.model, scene.settings);
  stepping.history = {scene.settings.time_step, 0, 0, scene.settings.contact_penalty};
  stepping.penalty = scene.settings.contact_penalty;
  stepping.solver.method = scene.settings.linear_method;
  return stepping;
}

std::variant<StepReport, StepFailure> advance(const ShiScene& scene, Stepping& stepping) {
  return Attempts(scene, stepping).run();
}

}  // namespace keyblock
