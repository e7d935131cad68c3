// The springs and the friction of one contact compared with energies and virtual work of its moved points; lists
// compared with their contacts.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/contact/springs.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <numbers>

#include "legacy/contact/line.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::springs_test {
namespace {

using support::legacy_scene;
using support::plain_analysis;

constexpr double kNormal = 7e6;
constexpr double kShearRatio = 2.5;
constexpr double kRatio = 0.45;

/// All unknowns of two blocks, those of the block that carries the line first.
using Vector = Eigen::Matrix<double, 12, 1>;
using Matrix = Eigen::Matrix<double, 12, 12>;

/// Two skew blocks in general position, so that no term of a spring vanishes. Line 3 → 2 is the top of the lower one.
struct SkewPair {
  ShiScene scene;
  State state;
  Contact contact;

  SkewPair() : scene(make()), state(start(scene).state) {
    contact.first = {{4}, {3}, {2}};
    contact.second = {{0}, {5}, {4}};
    contact.ratio = kRatio;
  }

  static ShiScene make() {
    const BlockPolygon lower{0, {{{-2, -1.1}, 0}, {{3, -0.8}, 0}, {{2.9, 0.1}, 0}, {{-1.9, -0.05}, 1}}, {}};
    const BlockPolygon upper{0, {{{0.3, 0.02}, 0}, {{1.2, 0.9}, 0}, {{-0.1, 0.8}, 0}}, {}};
    Analysis analysis = plain_analysis(1e-3, 1);
    analysis.joint_materials = {{89, 1e9, 0, {}},
                                {30, 400, 0, {}}};  // the line's material is that of vertex 3: the second
    return legacy_scene({{lower, upper}, {}, {}, {}, {}, {}}, analysis);
  }

  /// The points of a triple after both blocks have moved by `d`.
  Line moved(const Triple& triple, const Vector& d) const {
    const auto at = [&](VertexIndex v) {
      const ElementIndex e = scene.model.vertices[v].element;
      const Unknowns own = d.segment<6>(6 * e.value);
      return state.vertices[v] + affine_basis().displacement(own, state.vertices[v] - state.elements[e].centroid);
    };
    return {at(triple.vertex), at(triple.start), at(triple.end)};
  }
  double size(const Triple& triple) const { return line_of(state, triple).size(); }

  System springs() const {
    System system({6, 6});
    add_springs({contact}, scene.model, state, scene.rules, kNormal, system);
    return system;
  }
  Vector friction(bool acts = true) const {
    System system({6, 6});
    add_friction(with_friction({contact}, {acts}, scene.model), scene.model, state, system);
    return system.load;
  }
};

Vector gradient(const std::function<double(const Vector&)>& f) {
  constexpr double kStep = 1e-4;
  Vector g;
  for (int k = 0; k < 12; ++k) g[k] = (f(kStep * Vector::Unit(k)) - f(-kStep * Vector::Unit(k))) / (2 * kStep);
  return g;
}

Matrix dense(const BlockMatrix& matrix) {
  Matrix full;
  for (int k = 0; k < 12; ++k) full.col(k) = matrix * Eigen::VectorXd(Vector::Unit(k));
  return full;
}

/// `length` is stretched by the moved points; the force is the gradient of ½ k length², the stiffness k ∇length
/// ∇lengthᵀ.
void expect_springs(const System& found,
                    const std::vector<std::pair<double, std::function<double(const Vector&)>>>& springs) {
  Vector load = Vector::Zero();
  Matrix stiffness = Matrix::Zero();
  for (const auto& [k, length] : springs) {
    load -= gradient([&](const Vector& d) { return k / 2 * length(d) * length(d); });
    const Vector change = gradient(length);
    stiffness += k * change * change.transpose();
  }
  EXPECT_LT((found.load - load).norm(), 1e-6 * load.norm());
  EXPECT_LT((dense(found.matrix) - stiffness).norm(), 1e-9 * stiffness.norm());
}

}  // namespace

TEST(Springs, a_sliding_contact_is_a_normal_spring_of_the_energy_of_its_distance) {
  SkewPair pair;
  pair.contact.state = ContactState::sliding;
  const auto distance = [&](const Vector& d) {
    return pair.moved(pair.contact.first, d).twice_area() / pair.size(pair.contact.first);
  };
  expect_springs(pair.springs(), {{kNormal, distance}});
}

// Legacy-rules 8: ks = kn / 2.5, s = (P1 - P0)·(P3 - P2) / L with P0 moving with the line.
TEST(Springs, a_locked_contact_has_a_shear_spring_too) {
  SkewPair pair;
  pair.contact.state = ContactState::locked;
  const double size = pair.size(pair.contact.first);
  const auto distance = [&](const Vector& d) { return pair.moved(pair.contact.first, d).twice_area() / size; };
  const auto slip = [&](const Vector& d) {
    const Line l = pair.moved(pair.contact.first, d);
    return dot(l.p1 - l.at(kRatio), l.along()) / size;
  };
  ASSERT_GT(std::abs(slip(Vector::Zero())), 0.01);
  expect_springs(pair.springs(), {{kNormal, distance}, {kNormal / kShearRatio, slip}});
}

TEST(Springs, on_the_second_line_the_second_triple_acts_with_a_normal_spring_alone) {
  SkewPair pair;
  pair.contact.kind = ContactKind::vertex_vertex;
  pair.contact.state = ContactState::on_second_line;
  const auto distance = [&](const Vector& d) {
    return pair.moved(pair.contact.second, d).twice_area() / pair.size(pair.contact.second);
  };
  expect_springs(pair.springs(), {{kNormal, distance}});
}

TEST(Springs, an_open_contact_has_none) {
  const System system = SkewPair().springs();
  EXPECT_EQ(system.load.norm(), 0);
  EXPECT_EQ(dense(system.matrix).norm(), 0);
}

// Legacy-rules 9: f along the line on P0 of one block, against it on P1 of the other, f = |p| kn tan(phi).
TEST(Friction, does_the_work_of_a_force_pair_along_the_line) {
  SkewPair pair;
  pair.contact.state = ContactState::sliding;
  pair.contact.distance = -1e-3;
  pair.contact.penalty = 2e6;
  const Line before = line_of(pair.state, pair.contact.first);
  for (double slip : {0.2, -0.2}) {
    pair.contact.slip = slip;
    const double force = 1e-3 * 2e6 * std::tan(std::numbers::pi / 6) * (slip > 0 ? 1 : -1);
    const auto work = [&](const Vector& d) {
      const Line l = pair.moved(pair.contact.first, d);
      const Point advance = (l.p1 - before.p1) - (l.at(kRatio) - before.at(kRatio));
      return -force * dot(advance, before.along()) / before.size();
    };
    const Vector expected = gradient(work);
    EXPECT_LT((pair.friction() - expected).norm(), 1e-9 * expected.norm()) << slip;
  }
}

TEST(Friction, of_a_bonded_contact_is_greater_by_cohesion_times_length) {
  SkewPair pair;
  pair.contact.state = ContactState::sliding;
  pair.contact.distance = 1e-3;  // drawn apart: no pressure
  pair.contact.penalty = 2e6;
  pair.contact.slip = 1;
  pair.contact.length = 0.5;
  EXPECT_EQ(pair.friction().norm(), 0);
  pair.contact.bonded = true;
  EXPECT_NEAR(pair.friction().segment<2>(6).norm(), 400 * 0.5, 1e-9);
  pair.contact.distance = -1e-3;
  EXPECT_NEAR(pair.friction().segment<2>(6).norm(), 400 * 0.5 + 2e3 * std::tan(std::numbers::pi / 6), 1e-9);
}

TEST(Friction, needs_sliding_a_direction_and_leave_to_act) {
  SkewPair pair;
  pair.contact.state = ContactState::sliding;
  pair.contact.distance = -1e-3;
  pair.contact.penalty = 2e6;
  pair.contact.slip = 1;
  EXPECT_GT(pair.friction().norm(), 0);
  EXPECT_EQ(pair.friction(false).norm(), 0);
  pair.contact.slip = 0;
  EXPECT_EQ(pair.friction().norm(), 0);
  pair.contact.slip = 1;
  pair.contact.state = ContactState::locked;
  EXPECT_EQ(pair.friction().norm(), 0);
}

// A list equals the sum of its contacts: several of a pair, one of them open, lines on either element, both orders.
// Blocks have six unknowns, three, both, or none.
TEST(Springs, a_list_adds_up_to_its_contacts_whatever_the_bases) {
  for (const auto& [lower, upper] : {std::pair{&affine_basis(), &affine_basis()},
                                     {&rigid_basis(), &rigid_basis()},
                                     {&affine_basis(), &rigid_basis()},
                                     {&fixed_basis(), &rigid_basis()}}) {
    SkewPair pair;
    pair.scene.model.elements[ElementIndex{0}].basis = lower;
    pair.scene.model.elements[ElementIndex{1}].basis = upper;
    Contact open = pair.contact;
    Contact locked = pair.contact;
    locked.state = ContactState::locked;
    Contact sliding = pair.contact;
    sliding.state = ContactState::sliding;
    sliding.first = {{2}, {5}, {4}};  // the line is on the upper block
    const Contacts all{locked, open, sliding, locked};
    const std::vector<int> sizes{lower->unknown_count(), upper->unknown_count()};
    const auto springs = [&](const Contacts& contacts) {
      System system(sizes);
      add_springs(contacts, pair.scene.model, pair.state, pair.scene.rules, kNormal, system);
      return system;
    };
    const System together = springs(all);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(together.load.size());
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(load.size(), -1, 2);
    Eigen::VectorXd product = load;
    for (const Contact& one : all) {
      const System alone = springs({one});
      load += alone.load;
      product += alone.matrix * x;
    }
    EXPECT_GT(load.norm(), 0);
    EXPECT_LT((together.load - load).norm(), 1e-12 * load.norm());
    EXPECT_LT((together.matrix * x - product).norm(), 1e-12 * product.norm());
  }
}

}  // namespace keyblock::springs_test
