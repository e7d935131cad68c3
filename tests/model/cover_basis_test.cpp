// Span of the functions of covers: constants, linear and quadratic fields; gradients derived from values.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cover_basis.hpp"

#include <gtest/gtest.h>

#include "tests/support/continuum_scenes.hpp"

namespace keyblock::cover_basis_test {
namespace {

Manifold plate() {
  MeshSetting mesh;
  mesh.h = 0.3;
  return cut_body({rectangle_corners({0, 0}, {1, 0.7})}, mesh);
}

/// Unknowns (one component) of the field q at the nodes: its values if functions are nodal.
Eigen::VectorXd nodal(const Manifold& manifold, double (*q)(Point)) {
  Eigen::VectorXd d(static_cast<Eigen::Index>(manifold.covers.size()));
  for (std::size_t c = 0; c < manifold.covers.size(); ++c)
    d(static_cast<Eigen::Index>(c)) = q(manifold.mesh.nodes[static_cast<std::size_t>(manifold.covers[c].node)]);
  return d;
}

double value(const ElementShape& shape, const Eigen::VectorXd& d, Point x) {
  const Eigen::RowVectorXd n = shape.values(x);
  double sum = 0;
  for (std::size_t a = 0; a < shape.functions.size(); ++a)
    sum += n(static_cast<Eigen::Index>(a)) * d(shape.functions[a]);
  return sum;
}

}  // namespace

TEST(CoverBasis, nodal_values_say_what_the_order_allows) {
  const Manifold manifold = plate();
  const auto linear = [](Point p) { return 1 + 2 * p.x - 3 * p.y; };
  const auto quadratic = [](Point p) { return 1 + p.x * p.x - 2 * p.x * p.y + 3 * p.y * p.y; };
  const CoverBasis constant(manifold, CoverFunctions::constant);
  const CoverBasis derived(manifold, CoverFunctions::derived);
  for (int e = 0; e < constant.element_count(); ++e) {
    const Point x = constant.shape(e).frame.origin + Point{0.02, -0.03};
    EXPECT_NEAR(value(constant.shape(e), nodal(manifold, linear), x), linear(x), 1e-14);
    EXPECT_NEAR(value(derived.shape(e), nodal(manifold, linear), x), linear(x), 1e-13);
    EXPECT_NEAR(value(derived.shape(e), nodal(manifold, quadratic), x), quadratic(x), 1e-13);
  }
}

// One triangle has three covers: they cannot determine a quadratic field, but a linear one.
TEST(CoverBasis, derived_gradients_of_a_single_element_are_linear) {
  MeshSetting mesh;
  mesh.h = 5;
  mesh.angle = 0;
  mesh.through = {-2, -1};
  const Manifold manifold = cut_body({rectangle_corners({0, 0}, {0.5, 0.5})}, mesh);
  ASSERT_EQ(manifold.elements.size(), 1U);
  const CoverBasis derived(manifold, CoverFunctions::derived);
  const auto linear = [](Point p) { return 1 + 2 * p.x - 3 * p.y; };
  EXPECT_NEAR(value(derived.shape(0), nodal(manifold, linear), {0.1, 0.4}), linear({0.1, 0.4}), 1e-13);
}

TEST(CoverBasis, gradients_are_those_of_the_values) {
  const Manifold manifold = plate();
  for (const CoverFunctions functions : kAllCoverFunctions) {
    const CoverBasis basis(manifold, functions);
    const ElementShape shape = basis.shape(3);
    const Point x = shape.frame.origin + Point{0.02, -0.03};
    const double step = 1e-6;
    const Eigen::RowVectorXd by_x = shape.values(x + Point{step, 0}) - shape.values(x - Point{step, 0});
    EXPECT_LT((shape.gradients(x).row(0) - by_x / (2 * step)).norm(), 1e-8) << name_of(functions);
    EXPECT_EQ(shape.displacement(x).cols(), 2 * shape.function_count());
    EXPECT_EQ((shape.strain(x).row(2).head(1) - shape.strain(x).row(1).segment(1, 1)).norm(), 0)
        << "the shear of dx is the normal strain of dy";
  }
}

}  // namespace keyblock::cover_basis_test
