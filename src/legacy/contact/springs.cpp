// Sums the springs of contacts for each pair of elements before adding them to the system.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/contact/springs.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "base/loop.hpp"
#include "legacy/contact/line.hpp"

namespace keyblock {
namespace {

// Number of pairs whose springs up to four threads sum before they are added one by one: a megabyte of sums.
constexpr std::size_t kMadeAtOnce = 4 * kLoopRange;

Eigen::Vector2d vector(Point p) {
  return {p.x, p.y};
}

// Two springs of a contact, normal and shear in one column each. Their lengths change by the sums of `at_k` · u(P_k)
// and are `stretch` at the start of the step. P1 belongs to one element, the line P2 P3 to the other.
struct SpringPair {
  Eigen::Matrix2d at1 = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d at2 = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d at3 = Eigen::Matrix2d::Zero();
  Eigen::Vector2d stretch = Eigen::Vector2d::Zero();
  Eigen::Vector2d stiffness = Eigen::Vector2d::Zero();
};

// Computes e, g, d of legacy-rules 8: change of the distance of P1 from the line (line length not differentiated).
void set_normal(const Line& l, double penalty, SpringPair& springs) {
  const double size = l.size();
  springs.at1.col(0) << (l.p2.y - l.p3.y) / size, (l.p3.x - l.p2.x) / size;
  springs.at2.col(0) << (l.p3.y - l.p1.y) / size, (l.p1.x - l.p3.x) / size;
  springs.at3.col(0) << (l.p1.y - l.p2.y) / size, (l.p2.x - l.p1.x) / size;
  springs.stretch[0] = l.distance();
  springs.stiffness[0] = penalty;
}

// Computes es, gs, s of legacy-rules 8: change of the path of P1 along the line, from the contact point P0 at `ratio`.
void set_shear(const Line& l, double ratio, double penalty, SpringPair& springs) {
  const double size = l.size();
  const Point along = l.along();
  const Point from_p0 = l.p1 - l.at(ratio);
  springs.at1.col(1) = vector(1 / size * along);
  springs.at2.col(1) = vector((-1 / size) * ((1 - ratio) * along + from_p0));
  springs.at3.col(1) = vector((1 / size) * (from_p0 - ratio * along));
  springs.stretch[1] = dot(from_p0, along) / size;
  springs.stiffness[1] = penalty;
}

SpringPair springs_of(const Contact& contact, const Line& line, const ContactRules& rules, double penalty) {
  SpringPair springs;
  set_normal(line, penalty, springs);
  if (contact.state == ContactState::locked) set_shear(line, contact.ratio, penalty / rules.shear_ratio, springs);
  return springs;
}

// Consecutive contacts of the same two elements, `low` before `high`.
struct PairContacts {
  std::size_t begin;
  std::size_t end;
  ElementIndex low;
  ElementIndex high;
};

std::vector<PairContacts> pair_contacts(const Contacts& contacts, const Model& model) {
  std::vector<PairContacts> pairs;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (contacts[c].is_open()) continue;
    const Triple& triple = contacts[c].active();
    const auto& [low, high] = std::minmax(model.vertices[triple.vertex].element, model.vertices[triple.start].element);
    assert(low != high);
    if (pairs.empty() || pairs.back().low != low || pairs.back().high != high)
      pairs.push_back({c, c + 1, low, high});
    else
      pairs.back().end = c + 1;
  }
  return pairs;
}

// Submatrices of all springs between two elements.
struct PairSums {
  UnknownBlock low;
  UnknownBlock high;
  UnknownBlock between;  ///< row of `low`, column of `high`
  Unknowns load_low;
  Unknowns load_high;
};

class SpringSums {
 public:
  SpringSums(const Contacts& contacts, const Model& model, const State& state, const ContactRules& rules,
             double penalty)
      : contacts_(contacts), model_(model), state_(state), rules_(rules), penalty_(penalty) {}

  void operator()(const PairContacts& pair, PairSums& sums) const {
    const int low = basis(pair.low).unknown_count();
    const int high = basis(pair.high).unknown_count();
    sums.low.setZero(low, low);
    sums.high.setZero(high, high);
    sums.between.setZero(low, high);
    sums.load_low.setZero(low);
    sums.load_high.setZero(high);
    for (std::size_t c = pair.begin; c < pair.end; ++c) {
      if (contacts_[c].is_open()) continue;
      if (low == 6 && high == 6)
        add<6>(contacts_[c], pair, sums);
      else if (low == 3 && high == 3)
        add<3>(contacts_[c], pair, sums);
      else
        add<Eigen::Dynamic>(contacts_[c], pair, sums);
    }
  }

 private:
  const Basis& basis(ElementIndex e) const { return *model_.elements[e].basis; }

  // Nearly all blocks have six or three unknowns, so that operators of fixed size sum their springs.
  template <int N>
  using TwoColumns = Eigen::Matrix<double, N, 2, Eigen::ColMajor, N == Eigen::Dynamic ? kMostUnknowns : N, 2>;

  template <int N>
  TwoColumns<N> forces(ElementIndex e, Point p, const Eigen::Matrix2d& pair) const {
    return basis(e).generalised_forces<N>(p - state_.elements[e].centroid, pair);
  }

  template <int N>
  void add(const Contact& contact, const PairContacts& pair, PairSums& sums) const {
    const Triple& triple = contact.active();
    const Line line = line_of(state_, triple);
    const SpringPair springs = springs_of(contact, line, rules_, penalty_);
    const ElementIndex i = model_.vertices[triple.vertex].element;
    const ElementIndex j = model_.vertices[triple.start].element;
    const TwoColumns<N> on_i = forces<N>(i, line.p1, springs.at1);
    const TwoColumns<N> on_j = forces<N>(j, line.p2, springs.at2) + forces<N>(j, line.p3, springs.at3);
    const TwoColumns<N>& on_low = i == pair.low ? on_i : on_j;
    const TwoColumns<N>& on_high = i == pair.low ? on_j : on_i;
    const TwoColumns<N> scaled_low = on_low * springs.stiffness.asDiagonal();
    const TwoColumns<N> scaled_high = on_high * springs.stiffness.asDiagonal();
    add_product<N>(scaled_low, on_low, sums.low);
    add_product<N>(scaled_high, on_high, sums.high);
    add_product<N>(scaled_low, on_high, sums.between);
    sums.load_low -= scaled_low * springs.stretch;
    sums.load_high -= scaled_high * springs.stretch;
  }

  // Adds a bᵀ, column by column: the compiler inlines such products.
  template <int N>
  static void add_product(const TwoColumns<N>& a, const TwoColumns<N>& b, UnknownBlock& sum) {
    Eigen::Map<Eigen::Matrix<double, N, N>> to(sum.data(), sum.rows(), sum.cols());
    for (Eigen::Index j = 0; j < to.cols(); ++j) to.col(j).noalias() += a * b.row(j).transpose();
  }

  const Contacts& contacts_;
  const Model& model_;
  const State& state_;
  const ContactRules& rules_;
  double penalty_;
};

// Blocks have up to six rows: 36 entries are six by six, nine are three by three.
template <int N>
void add_square(const UnknownBlock& from, UnknownBlock& to) {
  using Square = Eigen::Matrix<double, N, N>;
  Eigen::Map<Square>(to.data()) += Eigen::Map<const Square>(from.data());
}

void add(const UnknownBlock& from, UnknownBlock& to) {
  if (from.size() == 36)
    add_square<6>(from, to);
  else if (from.size() == 9)
    add_square<3>(from, to);
  else
    to += from;
}

void add(const PairContacts& pair, const PairSums& sums, System& system) {
  const int low = pair.low.value;
  const int high = pair.high.value;
  add(sums.low, system.matrix.block(low, low));
  add(sums.high, system.matrix.block(high, high));
  add(sums.between, system.matrix.block(low, high));
  system.load_of(low) += sums.load_low;
  system.load_of(high) += sums.load_high;
}

double friction_force(const Contact& contact, const JointMaterial& joint) {
  const double tangent = joint.friction_tangent();
  const double cohesion = contact.bonded ? joint.cohesion * contact.length : 0;
  return std::abs(std::min(contact.distance, 0.0)) * contact.penalty * tangent + cohesion;
}

}  // namespace

void add_springs(const Contacts& contacts, const Model& model, const State& state, const ContactRules& rules,
                 double penalty, System& system) {
  const SpringSums sum(contacts, model, state, rules, penalty);
  const std::vector<PairContacts> pairs = pair_contacts(contacts, model);
  std::vector<PairSums> made(std::min(pairs.size(), kMadeAtOnce));
  for (std::size_t begin = 0; begin < pairs.size(); begin += made.size()) {
    const std::size_t count = std::min(made.size(), pairs.size() - begin);
    for_each_entry(count, [&](std::size_t k) { sum(pairs[begin + k], made[k]); });
    for (std::size_t k = 0; k < count; ++k) add(pairs[begin + k], made[k], system);
  }
}

Contacts with_friction(Contacts contacts, const std::vector<bool>& acts, const Model& model) {
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    Contact& contact = contacts[c];
    const bool rubs = acts[c] && contact.state == ContactState::sliding;
    contact.friction = rubs ? friction_force(contact, model.joint_at(contact.first.start)) * sign(contact.slip) : 0;
  }
  return contacts;
}

void add_friction(const Contacts& contacts, const Model& model, const State& state, System& system) {
  for (const Contact& contact : contacts) {
    if (contact.friction == 0 || contact.state != ContactState::sliding) continue;
    const Line line = line_of(state, contact.first);
    const ElementIndex i = model.vertices[contact.first.vertex].element;
    const ElementIndex j = model.vertices[contact.first.start].element;
    const Eigen::Vector2d along = contact.friction / line.size() * vector(line.along());
    system.load_of(i.value) -= basis_at(model, state, i, line.p1).transpose() * along;
    system.load_of(j.value) +=
        ((1 - contact.ratio) * basis_at(model, state, j, line.p2) + contact.ratio * basis_at(model, state, j, line.p3))
            .transpose() *
        along;
  }
}

}  // namespace keyblock
