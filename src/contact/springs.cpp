// The submatrices of one contact, and their sum.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/springs.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/loop.hpp"
#include "contact/line.hpp"

namespace keyblock {
namespace {

// Springs that are made by up to 16 threads before they are added one by one: a megabyte of them.
constexpr std::size_t kMadeAtOnce = 16 * kLoopRange;

// The elements of a contact and the operators of its three points: i carries P1, j carries the line.
struct Ends {
  int i;
  int j;
  DisplacementOperator t1;  // of element i at P1
  DisplacementOperator t2;  // of element j at P2 and P3
  DisplacementOperator t3;
};

Ends ends_of(const Triple& triple, const Line& line, const Model& model, const State& state) {
  const ElementIndex i = model.vertices[triple.vertex].element;
  const ElementIndex j = model.vertices[triple.start].element;
  return {i.value, j.value, basis_at(model, state, i, line.p1), basis_at(model, state, j, line.p2),
          basis_at(model, state, j, line.p3)};
}

Eigen::Vector2d vector(Point p) {
  return {p.x, p.y};
}

// One spring: a length whose change is  on_i·D_i + on_j·D_j, and which is `stretch` at the start of the step.
struct Spring {
  Unknowns on_i;
  Unknowns on_j;
  double stretch;
};

// e, g, d of legacy-rules 8: change of the distance of P1 from the line (line length not differentiated).
Spring normal_spring(const Line& l, const Ends& ends) {
  const double size = l.size();
  const Point e{(l.p2.y - l.p3.y) / size, (l.p3.x - l.p2.x) / size};
  const Point g2{(l.p3.y - l.p1.y) / size, (l.p1.x - l.p3.x) / size};
  const Point g3{(l.p1.y - l.p2.y) / size, (l.p2.x - l.p1.x) / size};
  return {ends.t1.transpose() * vector(e), ends.t2.transpose() * vector(g2) + ends.t3.transpose() * vector(g3),
          l.distance()};
}

// es, gs, s of legacy-rules 8: change of the way of P1 along the line, from the contact point P0 at `ratio`.
Spring shear_spring(const Line& l, const Ends& ends, double ratio) {
  const double size = l.size();
  const Point along = l.along();
  const Point from_p0 = l.p1 - l.at(ratio);
  const Point g2 = (-1 / size) * ((1 - ratio) * along + from_p0);
  const Point g3 = (1 / size) * (from_p0 - ratio * along);
  return {ends.t1.transpose() * vector(1 / size * along),
          ends.t2.transpose() * vector(g2) + ends.t3.transpose() * vector(g3), dot(from_p0, along) / size};
}

// Of both springs of a contact: a column each.
struct SpringPair {
  using Columns = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::ColMajor, kMostUnknowns, 2>;
  Columns on_i;
  Columns on_j;
  Eigen::Vector2d stiffness = Eigen::Vector2d::Zero();
  Eigen::Vector2d stretch = Eigen::Vector2d::Zero();

  explicit SpringPair(const Ends& ends)
      : on_i(Columns::Zero(ends.t1.cols(), 2)), on_j(Columns::Zero(ends.t2.cols(), 2)) {}
  void set(Eigen::Index column, const Spring& spring, double p) {
    on_i.col(column) = spring.on_i;
    on_j.col(column) = spring.on_j;
    stiffness[column] = p;
    stretch[column] = spring.stretch;
  }
};

// sum += a bᵀ. Blocks of six are what nearly all are.
void add_product(const SpringPair::Columns& a, const SpringPair::Columns& b, BlockMatrix::Block& sum) {
  if (a.rows() == kMostUnknowns && b.rows() == kMostUnknowns) {
    using Six = Eigen::Matrix<double, kMostUnknowns, 2>;
    Eigen::Map<Eigen::Matrix<double, kMostUnknowns, kMostUnknowns>>(sum.data()).noalias() +=
        Eigen::Map<const Six>(a.data()) * Eigen::Map<const Six>(b.data()).transpose();
  } else {
    sum.noalias() += a * b.transpose();
  }
}

struct ContactSprings {
  int i;
  int j;
  SpringPair springs;
};

// Nothing of an open contact.
std::optional<ContactSprings> springs_of(const Contact& contact, const Model& model, const State& state,
                                         const ContactRules& rules, double penalty) {
  if (contact.is_open()) return std::nullopt;
  const Line line = line_of(state, contact.active());
  const Ends ends = ends_of(contact.active(), line, model, state);
  ContactSprings made{ends.i, ends.j, SpringPair(ends)};
  made.springs.set(0, normal_spring(line, ends), penalty);
  if (contact.state == ContactState::locked)
    made.springs.set(1, shear_spring(line, ends, contact.ratio), penalty / rules.shear_ratio);
  return made;
}

void add(const ContactSprings& contact, System& system) {
  const auto& [i, j, springs] = contact;
  const SpringPair::Columns scaled_i = springs.on_i * springs.stiffness.asDiagonal();
  const SpringPair::Columns scaled_j = springs.on_j * springs.stiffness.asDiagonal();
  add_product(scaled_i, springs.on_i, system.matrix.block(i, i));
  add_product(scaled_j, springs.on_j, system.matrix.block(j, j));
  if (i < j)
    add_product(scaled_i, springs.on_j, system.matrix.block(i, j));
  else
    add_product(scaled_j, springs.on_i, system.matrix.block(j, i));
  system.load_of(i) -= scaled_i * springs.stretch;
  system.load_of(j) -= scaled_j * springs.stretch;
}

double friction_force(const Contact& contact, const JointMaterial& joint) {
  const double tangent = joint.friction_tangent();
  const double cohesion = contact.bonded ? joint.cohesion * contact.length : 0;
  return std::abs(std::min(contact.distance, 0.0)) * contact.penalty * tangent + cohesion;
}

}  // namespace

void add_springs(const Contacts& contacts, const Model& model, const State& state, const ContactRules& rules,
                 double penalty, System& system) {
  std::vector<std::optional<ContactSprings>> made(std::min(contacts.size(), kMadeAtOnce));
  for (std::size_t begin = 0; begin < contacts.size(); begin += made.size()) {
    const std::size_t count = std::min(made.size(), contacts.size() - begin);
    for_each_entry(count,
                   [&](std::size_t k) { made[k] = springs_of(contacts[begin + k], model, state, rules, penalty); });
    for (std::size_t k = 0; k < count; ++k)
      if (made[k]) add(*made[k], system);
  }
}

void add_friction(const Contacts& contacts, const std::vector<bool>& acts, const Model& model, const State& state,
                  System& system) {
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Contact& contact = contacts[c];
    if (!acts[c] || contact.state != ContactState::sliding) continue;
    const Line line = line_of(state, contact.first);
    const Ends ends = ends_of(contact.first, line, model, state);
    const JointMaterial& joint = model.joint_at(contact.first.start);
    const double force = friction_force(contact, joint) * sign(contact.slip);
    const Eigen::Vector2d along = force / line.size() * vector(line.along());
    system.load_of(ends.i) -= ends.t1.transpose() * along;
    system.load_of(ends.j) += ((1 - contact.ratio) * ends.t2 + contact.ratio * ends.t3).transpose() * along;
  }
}

}  // namespace keyblock
