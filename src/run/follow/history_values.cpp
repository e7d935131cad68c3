// Takes the values of a history from the state at the end of a step, and from the contacts of that step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/follow/history_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "problem/units/measure.hpp"
#include "run/follow/resultant.hpp"

namespace keyblock {
namespace {

/// Returns the velocity of a point of an element: by all its unknowns, or by rigid motion if it has none of its own.
Point velocity_at(const Stepper& stepper, ElementIndex e, Point at) {
  const Model& model = stepper.model();
  const State& state = stepper.state();
  const ElementState& element = state.elements[e];
  const Unknowns rates = end_velocity(element, state, stepper.settings(), model.elements[e].material);
  const Eigen::Vector2d own = basis_at(model, state, e, at) * rates;
  const Point arm = at - element.centroid;
  const Velocity& carried = element.carried;
  return {own.x() + carried.x - carried.rotation * arm.y, own.y() + carried.y + carried.rotation * arm.x};
}

double spin_of(const Stepper& stepper, ElementIndex e) {
  const Model& model = stepper.model();
  const ElementState& element = stepper.state().elements[e];
  const int spin = model.elements[e].basis->rotation_unknown;
  const Unknowns rates = end_velocity(element, stepper.state(), stepper.settings(), model.elements[e].material);
  return element.carried.rotation + (spin < 0 ? 0 : rates[spin]);
}

/// Sum over the contacts of one history.
struct ContactSum {
  int closed = 0;
  int sliding = 0;
  double least_gap = std::numeric_limits<double>::infinity();
  double greatest_slip = 0;
  double normal_force = 0;
  double shear_force = 0;

  void add(const ContactFrame& contact) {
    closed += contact.condition != ContactCondition::open ? 1 : 0;
    sliding += contact.condition == ContactCondition::slide ? 1 : 0;
    least_gap = std::min(least_gap, contact.gap);
    if (std::abs(contact.slip) > std::abs(greatest_slip)) greatest_slip = contact.slip;
    normal_force += contact.normal_force;
    shear_force += contact.shear_force;
  }
};

/// Takes the values of one history.
class ValuesAtStep {
 public:
  ValuesAtStep(const FollowedItem& item, const Stepper& stepper, const ItemsByNumber& numbered,
               const ContactFrames& contacts, const FollowedUnits& units)
      : item_(item), stepper_(stepper), numbered_(numbered), contacts_(contacts), units_(units) {}

  HistoryValues take() {
    const HistoryPlan& plan = item_.plan;
    if (plan.point) point(item_.point);
    if (plan.block) block(*plan.block);
    if (plan.contact) pair(*plan.contact);
    if (plan.joint) joint(*plan.joint);
    if (plan.line) resultant(*plan.line);
    if (plan.bolt) bolt(*plan.bolt);
    return std::move(taken_);
  }

 private:
  void point(int number) {
    const auto found = numbered_.points.find(number);
    if (found == numbered_.points.end()) return;
    const PointState& now = stepper_.state().measured_points[found->second];
    const CarriedPoint& point = stepper_.model().measured_points[found->second];
    displacement(now.displacement);
    velocity(velocity_at(stepper_, point.element, now.position));
    stress(stepper_.stress_at(point.element, point.start));
  }

  void block(int number) {
    const auto found = numbered_.elements.find(number);
    if (found == numbered_.elements.end()) return;
    const ElementIndex e = found->second;
    const ElementState& now = stepper_.state().elements[e];
    displacement(now.centroid - stepper_.unloaded().elements[e].centroid);
    put("rotation", now.rotation, "rad");
    velocity(velocity_at(stepper_, e, now.centroid));
    put("rotation_rate", spin_of(stepper_, e), units_.rotation_rate);
    stress(now.stress);
    Point sum;
    for (const ContactFrame& contact : contacts_) {
      if (contact.element == number) sum = sum + contact.force();
      if (contact.other == number) sum = sum - contact.force();
    }
    force("contact_force", sum);
  }

  void pair(const BlockPair& pair) {
    ContactSum sum;
    Point on_first;
    for (const ContactFrame& contact : contacts_) {
      if (!is_between(contact, pair)) continue;
      sum.add(contact);
      on_first = on_first + (contact.element == pair.first ? 1.0 : -1.0) * contact.force();
    }
    put(sum);
    force("force", on_first);
  }

  void joint(int line) {
    ContactSum sum;
    for (const ContactFrame& contact : contacts_)
      if (contact.joint_line == line) sum.add(contact);
    put(sum);
  }

  void resultant(const Segment& line) {
    const LineResultant found = resultant_across(line, stepper_, contacts_);
    const Point along = (1 / distance(line.start, line.end)) * (line.end - line.start);
    taken_.bears = found.closed > 0 || found.bolts > 0;
    put("closed_contacts", found.closed, "1");
    put("bolts", found.bolts, "1");
    force("force", found.force);
    put("normal_force", cross(along, found.force), units_.force);  // pushes the left side away from the line
    put("shear_force", dot(along, found.force), units_.force);
    put("moment", found.moment, units_.moment);
  }

  // The elongation is relative to the drawn length, also after the bolt broke and its force is 0.
  void bolt(int number) {
    const auto found = numbered_.bolts.find(number);
    if (found == numbered_.bolts.end()) return;
    const BoltState& now = stepper_.state().bolts[found->second];
    put("force", now.force, units_.force);
    put("elongation", distance(now.first, now.second) - stepper_.model().bolts[found->second].start_length(),
        units_.length);
    put("is_broken", now.is_broken ? 1 : 0, "1");
  }

  void put(std::string_view quantity, double value, const std::string& unit) {
    taken_.values.push_back({item_.what, item_.name, std::string(quantity), value, unit});
  }
  void displacement(Point u) {
    put("displacement_x", u.x, units_.length);
    put("displacement_y", u.y, units_.length);
  }
  void velocity(Point v) {
    put("velocity_x", v.x, units_.velocity);
    put("velocity_y", v.y, units_.velocity);
  }
  void stress(const Stress& stress) {
    put("stress_xx", stress.xx, units_.stress);
    put("stress_yy", stress.yy, units_.stress);
    put("stress_xy", stress.xy, units_.stress);
  }
  void force(const std::string& name, Point force) {
    put(name + "_x", force.x, units_.force);
    put(name + "_y", force.y, units_.force);
  }
  void put(const ContactSum& sum) {
    taken_.bears = sum.closed > 0;
    if (std::isfinite(sum.least_gap)) taken_.least_gap = sum.least_gap;
    put("closed_contacts", sum.closed, "1");
    put("sliding_contacts", sum.sliding, "1");
    if (std::isfinite(sum.least_gap)) put("least_gap", sum.least_gap, units_.length);
    put("greatest_slip", sum.greatest_slip, units_.length);
    put("normal_force", sum.normal_force, units_.force);
    put("shear_force", sum.shear_force, units_.force);
  }

  const FollowedItem& item_;
  const Stepper& stepper_;
  const ItemsByNumber& numbered_;
  const ContactFrames& contacts_;
  const FollowedUnits& units_;
  HistoryValues taken_;
};

}  // namespace

FollowedUnits::FollowedUnits(const Units& units)
    : length(unit_of(measures::kLength, units)),
      velocity(unit_of(measures::kVelocity, units)),
      rotation_rate(unit_of(measures::kRotationRate, units)),
      force(unit_of(measures::kForce, units)),
      stress(unit_of(measures::kStress, units)),
      moment(unit_of(measures::kMoment, units)) {}

ItemsByNumber::ItemsByNumber(const Model& model) {
  for (const ElementIndex e : indices(model.elements)) elements.emplace(model.identities.of_element(e.value).number, e);
  for (std::size_t i = 0; i < model.measured_points.size(); ++i)
    points.emplace(model.identities.of_measured_point(i), i);
  for (std::size_t i = 0; i < model.bolts.size(); ++i) bolts.emplace(model.identities.of_bolt(i), i);
}

HistoryValues values_of(const FollowedItem& item, const Stepper& stepper, const ItemsByNumber& numbered,
                        const ContactFrames& contacts, const FollowedUnits& units) {
  return ValuesAtStep(item, stepper, numbered, contacts, units).take();
}

bool is_between(const ContactFrame& contact, const BlockPair& pair) {
  return (contact.element == pair.first && contact.other == pair.second) ||
         (contact.element == pair.second && contact.other == pair.first);
}

}  // namespace keyblock
