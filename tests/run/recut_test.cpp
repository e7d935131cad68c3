// An NMM body remeshed more finely at the tip: unchanged parts are copied, the rest keeps momentum and the span of its
// functions.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cut/mesh/same_triangles.hpp"
#include "geometry/polygon.hpp"
#include "model/continuum.hpp"
#include "run/growth/parents.hpp"
#include "run/prepare.hpp"
#include "step/groups/cover_group.hpp"
#include "step/groups/kept_covers.hpp"
#include "step/standard_stepper.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::recut_test {
namespace {

constexpr double kSide = 0.05;  // of the mesh
constexpr double kFar = 0.6;    // from the tips: no element there has another mesh or another star
constexpr double kRounding = 1e-12;
constexpr Point kTipBefore{0.4, 0.01};
constexpr Point kTipAfter{0.45, 0.01};

Scene plate(Point tip, CoverFunctions functions, bool may_yield = false) {
  Problem problem;
  Blocks blocks;
  blocks.blocks = {support::rectangle({0, -1}, {1, 1})};
  problem.geometry = blocks;
  problem.analysis = support::plain_analysis(1e-4, 1);
  if (may_yield) {
    Strength strength;
    strength.surface = YieldSurface::tresca;
    strength.values.cohesion = 1e8;
    problem.analysis->block_materials[0].strength = std::make_shared<const Strength>(strength);
  }
  problem.covers.emplace();
  problem.covers->functions = functions;
  problem.covers->mesh.side = kSide;
  problem.covers->mesh.tip_side = kSide / 8;
  problem.covers->mesh.angle_deg = 10;
  problem.covers->cracks = {{{{0, 0}, tip}, {}}};
  return prepare(problem, "standard", {}).scene;
}

const CoverGroup& covers_of(const StandardScene& scene) {
  for (const auto& group : scene.groups)
    if (const auto* covers = dynamic_cast<const CoverGroup*>(group.get())) return *covers;
  throw std::logic_error("there are no bodies on covers");
}

Point node_of(const Manifold& manifold, std::size_t cover) {
  return manifold.mesh.nodes[static_cast<std::size_t>(manifold.covers[cover].node)];
}

/// Rotated by 0.3 rad, bent, and of a pattern that no other mesh holds; it flies, rotates and oscillates.
Motion moving(const StandardScene& scene) {
  Motion motion = start_motion(scene);
  const Manifold& manifold = scene.model.continuum->manifold;
  const Eigen::Index per_cover = motion.q.shared.size() / static_cast<Eigen::Index>(2 * manifold.covers.size());
  for (std::size_t c = 0; c < manifold.covers.size(); ++c) {
    const Point x = node_of(manifold, c);
    const auto row = 2 * per_cover * static_cast<Eigen::Index>(c);
    const double noise = 1e-5 * std::sin(1 + 1.7 * static_cast<double>(c * c));
    const Point bent{x.x + 0.01 * x.x * x.y + noise, x.y + 0.02 * x.x * x.x - 0.01 * std::sin(3 * x.y) - noise};
    motion.q.shared.segment<2>(row) << std::cos(0.3) * bent.x - std::sin(0.3) * bent.y - x.x,
        std::sin(0.3) * bent.x + std::cos(0.3) * bent.y - x.y;
    motion.v.shared.segment<2>(row) << 2 - 0.8 * x.y + std::sin(4 * x.x) + noise, 0.8 * x.x - 0.5 + x.y * x.x;
  }
  return motion;
}

/// Momentum, and angular momentum about the origin.
Eigen::Vector3d momenta(const CoverScene& covers, const UnknownsTable& q, const UnknownsTable& v) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const WholeBody& body : covers.whole(q.shared, covers.momentum(v.shared))) {
    sum += body.resultant;
    sum[2] += cross(body.centre, {body.resultant[0], body.resultant[1]});
  }
  return sum;
}

/// One plate and the same with a longer crack, with a motion transferred between them.
class Recut {
 public:
  explicit Recut(CoverFunctions functions, bool may_yield = false)
      : before_(plate(kTipBefore, functions, may_yield)),
        motion_(moving(before_.scene())),
        after_(plate(kTipAfter, functions, may_yield)) {
    for (std::size_t i = 0; i < motion_.points.covers.size(); ++i)
      motion_.points.covers[i].kappa = 1e-3 * (1 + std::sin(static_cast<double>(i * i)));
    parents_ = parents_by_place(before_.model(), after_.model());
    carried_ = start_motion(after_.scene());
    covers_of(after_.scene()).carry(after_.scene().parts(), bodies_before(), carried_);
  }

  BodiesBefore bodies_before() const { return {before_.scene().parts(), before_.scene().groups, motion_, parents_}; }
  const CoverScene& was() const { return covers_of(before_.scene()).bodies(); }
  const CoverScene& is() const { return covers_of(after_.scene()).bodies(); }
  const Motion& motion() const { return motion_; }
  const Motion& carried() const { return carried_; }

  /// κ in the middle of an element, before and after.
  std::pair<double, double> hardening(ElementIndex e) const {
    const Manifold& manifold = is().continuum().manifold;
    const Point middle = centroid(manifold.polygon(manifold.elements[static_cast<std::size_t>(e.value)]).front());
    return {covers_of(before_.scene()).memory_at(parents_[e], motion_, middle).kappa,
            covers_of(after_.scene()).memory_at(e, carried_, middle).kappa};
  }

  std::vector<std::vector<FieldPoint>> fields() const {
    std::vector<std::vector<FieldPoint>> fields;
    const Manifold& manifold = is().continuum().manifold;
    for (std::size_t e = 0; e < manifold.elements.size(); ++e)
      fields.push_back(covers_of(before_.scene())
                           .field_over(before_.scene().parts(), parents_[{static_cast<int>(e)}],
                                       manifold.polygon(manifold.elements[e]), is().basis().degree(), motion_));
    return fields;
  }

 private:
  StandardStepper before_;
  Motion motion_;
  StandardStepper after_;
  Table<ElementIndex, ElementIndex> parents_;
  Motion carried_;
};

/// Unknowns of the first function of covers of nodes far from both tips and from the crack, which has two per node.
std::map<std::pair<double, double>, Eigen::Vector2d> far_unknowns(const CoverScene& covers,
                                                                  const Eigen::VectorXd& field) {
  std::map<std::pair<double, double>, Eigen::Vector2d> found;
  const Manifold& manifold = covers.continuum().manifold;
  const Eigen::Index size = field.size() / static_cast<Eigen::Index>(manifold.covers.size());
  for (std::size_t c = 0; c < manifold.covers.size(); ++c) {
    const Point x = node_of(manifold, c);
    if (std::abs(x.y) < kFar || distance(x, kTipAfter) < kFar) continue;
    found[{x.x, x.y}] = field.segment<2>(size * static_cast<Eigen::Index>(c));
  }
  return found;
}

/// Difference between a velocity and a gradient of the unknowns and those of points: the root of the means of their
/// squares.
std::pair<double, double> errors(const CoverScene& covers, const std::vector<std::vector<FieldPoint>>& fields,
                                 const Eigen::VectorXd& d, const Eigen::VectorXd& v) {
  double of_velocity = 0, of_gradient = 0;
  for (std::size_t e = 0; e < fields.size(); ++e) {
    const ElementShape shape = covers.basis().shape(static_cast<int>(e));
    for (const FieldPoint& point : fields[e]) {
      const Eigen::RowVectorXd values = shape.values(point.start);
      const Eigen::Matrix2Xd gradients = shape.gradients(point.start);
      Eigen::Vector2d velocity(-point.velocity.x, -point.velocity.y);
      Eigen::Matrix2d gradient = Eigen::Matrix2d::Identity() - point.gradient;
      for (int a = 0; a < shape.function_count(); ++a) {
        const int f = 2 * shape.functions[static_cast<std::size_t>(a)];
        velocity += values(a) * v.segment<2>(f);
        gradient += d.segment<2>(f) * gradients.col(a).transpose();
      }
      of_velocity += point.area * velocity.squaredNorm();
      of_gradient += point.area * gradient.squaredNorm();
    }
  }
  return {std::sqrt(of_velocity), std::sqrt(of_gradient)};
}

class RecutOf : public testing::TestWithParam<CoverFunctions> {};

TEST_P(RecutOf, copies_what_is_far_from_the_tips_to_the_bit) {
  const Recut recut(GetParam());
  const auto were = far_unknowns(recut.was(), recut.motion().q.shared);
  const auto are = far_unknowns(recut.is(), recut.carried().q.shared);
  ASSERT_GT(were.size(), 300U);
  EXPECT_EQ(were, are);
  if (GetParam() == CoverFunctions::linear) return;  // they depend on each other: only the field is determined
  const auto speeds = far_unknowns(recut.is(), recut.carried().v.shared);
  for (const auto& [node, v] : far_unknowns(recut.was(), recut.motion().v.shared))
    EXPECT_LT((speeds.at(node) - v).norm(), 1e-6);  // the body is rotated to keep its angular momentum
}

TEST_P(RecutOf, keeps_momentum_and_angular_momentum) {
  const Recut recut(GetParam());
  const Eigen::Vector3d was = momenta(recut.was(), recut.motion().q, recut.motion().v);
  const Eigen::Vector3d is = momenta(recut.is(), recut.carried().q, recut.carried().v);
  EXPECT_GT(was.cwiseAbs().minCoeff(), 100);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(is[i] / was[i], 1, kRounding) << i;
}

// Transfer by points everywhere is the nearest in the energy of strain: transfer of a part is as near.
TEST_P(RecutOf, is_as_near_to_the_field_as_if_everything_was_projected) {
  const Recut recut(GetParam());
  const std::vector<std::vector<FieldPoint>> fields = recut.fields();
  const KeptCovers none = nothing_kept(recut.is());
  const ChangedPart all = changed_part(recut.is(), none.elements);
  ASSERT_EQ(all.elements.size(), fields.size());
  const CarriedCovers projected = carried_covers(
      {copied(none, recut.motion().q.shared), copied(none, recut.motion().v.shared)}, all, fields, recut.is());
  const auto [velocity, gradient] = errors(recut.is(), fields, projected.d, projected.v);
  const auto [velocity_is, gradient_is] =
      errors(recut.is(), fields, recut.carried().q.shared, recut.carried().v.shared);
  EXPECT_GT(gradient, 1e-6) << "nothing was lost that could be";
  EXPECT_LT(velocity_is, (1 + 1e-6) * velocity);
  EXPECT_LT(gradient_is, 1.01 * gradient);
  const double energy = recut.was().strain_energy(recut.motion().q.shared, {});
  const double energy_is = recut.is().strain_energy(recut.carried().q.shared, {});
  const double energy_of_all = recut.is().strain_energy(projected.d, {});
  EXPECT_GT(1 - energy_is / energy, 0);
  EXPECT_LT(1 - energy_is / energy, 1.5 * (1 - energy_of_all / energy));
}

TEST_P(RecutOf, changes_a_small_part) {
  const Recut recut(GetParam());
  std::vector<int> parents;
  for (const ElementIndex parent : recut.bodies_before().parents) parents.push_back(parent.value);
  const KeptCovers kept = kept_covers(recut.was(), parents, recut.is());
  const auto all = static_cast<double>(kept.elements.size());
  EXPECT_GT(static_cast<double>(std::ranges::count(kept.elements, 1)), 0.6 * all);
  EXPECT_LT(static_cast<double>(changed_part(recut.is(), kept.elements).elements.size()), 0.7 * all);
}

TEST(Recut, keeps_what_rock_remembers_where_nothing_changed) {
  const Recut recut(CoverFunctions::constant, true);
  const Manifold& manifold = recut.is().continuum().manifold;
  int far = 0;
  for (ElementIndex e : indices(recut.bodies_before().parents)) {
    const auto [was, is] = recut.hardening(e);
    EXPECT_GT(is, 0);
    EXPECT_LT(is, 2e-3);
    const std::array<Point, 3> triangle = manifold.triangle(manifold.elements[static_cast<std::size_t>(e.value)]);
    if (std::ranges::any_of(triangle, [](Point p) { return distance(p, kTipAfter) < kFar; })) continue;
    ++far;
    EXPECT_EQ(is, was) << e.value;
  }
  EXPECT_GT(far, 500);
}

INSTANTIATE_TEST_SUITE_P(EveryKind, RecutOf,
                         testing::Values(CoverFunctions::constant, CoverFunctions::derived, CoverFunctions::linear),
                         [](const auto& kind) { return std::string(name_of(kind.param)); });

TEST(SameTriangles, are_found_under_other_numbers) {
  const TriangleMesh was{{{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {{0, 1, 2}, {1, 3, 2}}};
  const TriangleMesh is{{{1, 1}, {0, 1}, {1, 0}, {-0.0, 0}, {0.5, 0}}, {{2, 0, 1}, {3, 4, 1}, {2, 1, 3}, {3, 2, 1}}};
  EXPECT_EQ(same_triangles(was, is), (std::vector<int>{1, -1, -1, 0}));
}

TEST(ParentsByPlace, hold_a_point_inside_each_piece_where_the_mesh_changed) {
  const Scene before = plate(kTipBefore, CoverFunctions::constant);
  const Scene after = plate(kTipAfter, CoverFunctions::constant);
  const Manifold& was = before.model.continuum->manifold;
  const Manifold& is = after.model.continuum->manifold;
  const Table<ElementIndex, ElementIndex> parents = parents_by_place(before.model, after.model);
  for (ElementIndex e : indices(parents)) {
    const auto piece = is.polygon(is.elements[static_cast<std::size_t>(e.value)]);
    const std::optional<Point> inside = point_inside(piece);
    ASSERT_TRUE(inside);
    const auto of_parent = was.polygon(was.elements[static_cast<std::size_t>(parents[e].value)]);
    // The middle of the piece, or the point off it by which parents are chosen.
    const Point off = *inside + 0.1387 * (piece.front().front() - *inside);
    EXPECT_TRUE(side(of_parent.front(), *inside) != Side::outside || side(of_parent.front(), off) != Side::outside)
        << "element " << e.value;
  }
}

}  // namespace
}  // namespace keyblock::recut_test
