// Decides opening, closing, sliding and locking of one contact after another.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/contact/judge.hpp"

#include <algorithm>
#include <cmath>

#include "base/loop.hpp"
#include "legacy/contact/line.hpp"

namespace keyblock {
namespace {

// Friction angle below which a sliding contact never locks again (legacy-rules 10.3).
constexpr double kLockingFrictionDeg = 0.9;
// Fraction of w0 below which a reversal of sliding does not lock (legacy-rules 10.3).
constexpr double kReversalShare = 1e-7;
// Change of (twice the area over w0²) below which the start counts as the instant of touching (legacy-rules 10.3).
constexpr double kStillShare = 1e-9;

class Judge {
 public:
  Judge(const Model& model, const State& state, const Increments& increments, const ContactRules& rules, double penalty)
      : model_(model), state_(state), moved_(model.vertices.size()), rules_(rules), penalty_(penalty) {
    for_each_index(moved_, [&](VertexIndex v) {
      const ElementIndex e = model.vertices[v].element;
      const Point offset = state.vertices[v] - state.elements[e].centroid;
      moved_[v] = model.elements[e].basis->displacement(increments[e], offset);
    });
    for (const JointMaterial& joint : model.joint_materials) tangents_.push_back(joint.friction_tangent());
  }

  void operator()(Contact& contact) const {
    contact.state_before = contact.state;
    contact.penalty = penalty_;
    if (contact.kind == ContactKind::vertex_vertex)
      vertex_vertex(contact);
    else
      vertex_edge(contact);
  }

 private:
  struct Joint {
    const JointMaterial& material;
    double tangent;  ///< of its friction angle
  };

  LineMotion motion(const Triple& t) const { return {moved_[t.vertex], moved_[t.start], moved_[t.end]}; }

  double distance_after(const Triple& triple) const {
    const Line line = line_of(state_, triple);
    return (line.twice_area() + twice_area_change(line, motion(triple))) / line.size();
  }

  void vertex_vertex(Contact& contact) const {
    const double first = distance_after(contact.first);
    const double second = distance_after(contact.second);
    const ContactState nearer = second > first ? ContactState::on_second_line : ContactState::on_first_line;
    contact.distance = std::max(first, second);
    double tested = contact.distance;
    if (contact.state == ContactState::on_first_line) tested = first;
    if (contact.state == ContactState::on_second_line) tested = second;
    contact.spring = tested;
    const bool opens = contact.is_open() ? tested > -rules_.closing_depth : tested > rules_.opening_distance;
    contact.state = opens ? ContactState::open : nearer;
  }

  void vertex_edge(Contact& contact) const {
    const Line line = line_of(state_, contact.first);
    const LineMotion u = motion(contact.first);
    const int material = model_.vertices[contact.first.start].joint_material;
    const Joint joint{model_.joint_material(material), tangents_[static_cast<std::size_t>(material)]};
    const double change = twice_area_change(line, u);
    contact.distance = contact.spring = (line.twice_area() + change) / line.size();
    if (stays_open(contact, joint.material)) {
      contact.state = ContactState::open;
      return;
    }
    if (contact.is_open()) contact.ratio = ratio_at_touch(line, u, change);
    const double old_slip = contact.slip;
    contact.slip = slip_after(line, u, contact.ratio);
    contact.state = sticks(contact, joint, old_slip) ? ContactState::locked : ContactState::sliding;
  }

  bool stays_open(const Contact& contact, const JointMaterial& joint) const {
    if (contact.is_open()) return contact.distance > -rules_.closing_depth;
    const double stretch = contact.bonded ? joint.tensile_strength * contact.length / penalty_ : 0;
    return contact.distance > rules_.opening_distance + stretch;
  }

  // Returns the position of the vertex along the line at the instant when it reaches the line.
  double ratio_at_touch(const Line& l, const LineMotion& u, double change) const {
    const double area = l.twice_area();
    const bool still = std::abs(change) < kStillShare * rules_.scale * rules_.scale;
    const double t = area < 0 || still ? 0 : std::clamp(-area / change, 0.0, 1.0);
    return Line{l.p1 + t * u.u1, l.p2 + t * u.u2, l.p3 + t * u.u3}.projection();
  }

  static double slip_after(const Line& l, const LineMotion& u, double ratio) {
    const Point from_p0 = l.p1 - l.at(ratio);
    const Point u0 = (1 - ratio) * u.u2 + ratio * u.u3;
    return (dot(from_p0, l.along()) + dot(u.u1 - u0, l.along()) + dot(from_p0, u.u3 - u.u2)) / l.size();
  }

  bool sticks(const Contact& contact, const Joint& joint, double old_slip) const {
    const double tangent = joint.tangent;
    const double slip = std::abs(contact.slip);
    switch (contact.state_before) {
      case ContactState::open:
        return slip < std::abs(tangent * contact.distance);
      case ContactState::locked: {
        const double pressure = contact.distance > 0 ? 0 : -contact.distance * tangent;
        const double cohesion = contact.bonded ? joint.material.cohesion * contact.length / penalty_ : 0;
        return pressure + cohesion > slip / rules_.shear_ratio;
      }
      default:
        return sign(old_slip) * contact.slip < -kReversalShare * rules_.scale &&
               joint.material.friction_angle_deg > kLockingFrictionDeg;
    }
  }

  const Model& model_;
  const State& state_;
  Table<VertexIndex, Point> moved_;  ///< displacements: most vertices have several contacts
  std::vector<double> tangents_;     ///< of joint materials
  const ContactRules& rules_;
  double penalty_;
};

}  // namespace

Contacts judge(Contacts contacts, const Model& model, const State& state, const Increments& increments,
               const ContactRules& rules, double penalty) {
  const Judge judge_one(model, state, increments, rules, penalty);
  for_each_entry(contacts.size(), [&](std::size_t i) { judge_one(contacts[i]); });
  return contacts;
}

std::vector<std::size_t> changed(const Contacts& contacts) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (contacts[i].is_open() != (contacts[i].state_before == ContactState::open)) numbers.push_back(i);
  }
  return numbers;
}

}  // namespace keyblock
