// Finds the meetings, makes the velocities jump and separates overlaps; see strike.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/strike.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "contact/rows/gap.hpp"
#include "step/newton/tolerances.hpp"
#include "step/scene/touch_search.hpp"
#include "step/time/impact.hpp"

namespace keyblock {
namespace {

// Gap, relative to block size, below which a contact takes part in the jump like overlapping ones. The corners of a
// flat impact meet within round-off.
constexpr double kMeeting = 1e-10;

// Drops corners that passed the end of their edge within the step. They meet the next edge in the next step; the line
// that they left would push them in a direction without a face. Returns the former places of the remaining contacts.
std::vector<std::size_t> drop_passed(const SmoothStep& of, ImpactTouches& impacts) {
  const auto vertices = vertices_at(of.scene.model, of.scene.reference, of.smooth.q);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < impacts.touches.size(); ++i) {
    if (!lies_over_edge(impacts.touches[i], vertices)) continue;
    impacts.touches[kept.size()] = impacts.touches[i];
    impacts.speeds[kept.size()] = impacts.speeds[i];
    kept.push_back(i);
  }
  impacts.touches.resize(kept.size());
  impacts.speeds.resize(kept.size());
  return kept;
}

// Computes the speed when the surfaces met, not at the end of the step: v² = v1² + 2 a d. a is the acceleration of the
// step and d the overshoot, covered at the mean of both speeds.
ImpactMeeting meeting(const Touch& touch, double dt, double at_start, double at_end, double overshoot) {
  if (at_end >= 0) return {touch, 0, 0};
  const double acceleration = (at_end - at_start) / dt;
  const double at_surface = std::sqrt(std::max(0.0, at_end * at_end + 2 * acceleration * overshoot));
  return {touch, std::min(dt, 2 * overshoot / (at_surface - at_end)), -at_end - at_surface};
}

// Removes overlaps against the loads only as far as the energy lost in the jump suffices. The rest of the overlap
// stays. That energy is the contacts' own, which a moving support does not change.
void put_back_by_energy(const SmoothStep& of, const Jump& jump, UnknownsTable& separated) {
  const UnknownsTable way = plus(separated, -1, jump.q);
  const double lifted = -dot(loads_at(of.scene, of.smooth.q, of.time + of.dt), way);
  if (lifted > jump.lost) separated = plus(jump.q, jump.lost / lifted, way);
}

}  // namespace

bool is_within_one_body(const StandardScene& scene, const Touch& touch) {
  return scene.groups.are_one_body(scene.model.vertices[touch.vertex].element,
                                   scene.model.vertices[touch.start].element);
}

double strike(const SmoothStep& of, ImpactTouches impacts, const OtherTouches& others, StandardStep& step) {
  const std::vector<std::size_t> kept = drop_passed(of, impacts);
  const auto vertices = vertices_at(of.scene.model, of.scene.reference, of.smooth.q);
  const Eigen::VectorXd speeds =
      rates(contact_rows(of.scene.model, of.scene.reference, of.smooth.q, impacts.touches), rigid_part(step.motion.v));
  Impacts struck;
  std::vector<std::size_t> met;
  for (std::size_t i = 0; i < impacts.touches.size(); ++i) {
    const double gap = gap_of(impacts.touches[i], vertices) - impacts.touches[i].rest_gap;
    if (gap > kMeeting * of.size) continue;
    met.push_back(kept[i]);
    struck.meetings.push_back(meeting(impacts.touches[i], of.dt, impacts.speeds[i],
                                      speeds[static_cast<Eigen::Index>(2 * i)], std::max(0.0, -gap)));
  }
  if (struck.meetings.empty()) return 0;
  step.struck = std::ranges::max_element(struck.meetings, {}, &ImpactMeeting::since)->since;
  struck.touching = others.touching;
  std::erase_if(struck.touching, [&](const Touch& touch) { return is_within_one_body(of.scene, touch); });
  const Flexibility flexibility = impact_flexibility(of.scene, of.smooth.flexibility, of.rule);
  struck.bonds = of.smooth.bonds;
  struck.slow = of.slow;
  Jump jump = after_jump(of.scene, of.smooth.q, step.motion.v, struck, flexibility);
  double given = jump.given;
  for (std::size_t i : jump.undecided) step.undecided.push_back(of.touches + met[i]);
  step.motion.v = std::move(jump.v);
  if (!jump.undecided.empty()) {  // fixed points take no part in unsettled impulses
    PushedVelocities pushed = with_held_velocities(of.scene, of.smooth.q, std::move(step.motion.v), {}, {}, of.time,
                                                   of.dt, {of.smooth.flexibility, of.rule.end_velocity.increment});
    step.motion.v = std::move(pushed.v);
    given += pushed.given;
  }
  Separated separated{.q = jump.q};
  Touches not_driven_in;
  std::set<Touch> known;
  // Repeats the separation while it drives others into one another.
  for (int search = 0; search < tolerances::of_steps::kMostSearches; ++search) {
    const std::size_t before = not_driven_in.size();
    for (const Touch& touch : others.not_driven_in(separated.q))
      if (known.insert(touch).second) not_driven_in.push_back(touch);
    if (search > 0 && not_driven_in.size() == before) break;
    Separated next =
        without_overlap(of.scene, std::move(separated.q), impacts.touches, not_driven_in, of.smooth.q, flexibility);
    const bool has_pushed = next.solves > 0;
    next.solves += separated.solves;
    separated = std::move(next);
    if (!has_pushed) break;
  }
  put_back_by_energy(of, jump, separated.q);
  step.motion.q = with_points_in_place(of.scene, std::move(separated.q), of.time + of.dt, flexibility);
  step.solves += jump.solves + separated.solves;
  step.locked_overlaps += separated.locked;
  return given;
}

}  // namespace keyblock
