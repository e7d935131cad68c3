// Edges fixed on a mesh that they cut: by means over stretches, which an affine motion meets and which permit flow.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/held_edges.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "system/whole_system.hpp"
#include "tests/support/continuum_scenes.hpp"

namespace keyblock::held_edges_test {
namespace {

constexpr double kWidth = 0.24, kHeight = 0.12;

/// A plate whose upper edge is fixed in the direction y.
struct Plate {
  Continuum continuum;
  CoverBasis basis;
  HeldEdges held;
  SparseSystem system;

  explicit Plate(double angle)
      : continuum(made(angle)),
        basis(continuum.manifold, CoverFunctions::constant),
        held(continuum, basis),
        system(basis.function_count(), groups(held)) {
    held.add_stiffness(system);
  }

  static FunctionGroups groups(const HeldEdges& held) {
    FunctionGroups groups;
    held.add_groups(groups);
    return groups;
  }

  static Continuum made(double angle) {
    Continuum continuum;
    MeshSetting mesh{0.03};
    mesh.angle = angle;
    mesh.through = angle == 0 ? Point{0, 0} : Point{0.013, 0.007};
    continuum.manifold = cut_body({rectangle_corners({0, 0}, {kWidth, kHeight})}, mesh);
    continuum.materials = {elastic_material(1e6, 0.25)};
    continuum.functions = CoverFunctions::constant;
    continuum.prescribed = {{{{{0, kHeight}, {kWidth, kHeight}}}, Held::y, [](Point p, Point) {
                               return Point{0, 0.1 + 0.2 * p.x + 0.3 * p.y};
                             }}};
    return continuum;
  }

  Eigen::VectorXd affine() const {
    Eigen::VectorXd d(2 * basis.function_count());
    for (int f = 0; f < basis.function_count(); ++f) {
      const Point node =
          continuum.manifold.mesh
              .nodes[static_cast<std::size_t>(continuum.manifold.covers[static_cast<std::size_t>(f)].node)];
      d.segment<2>(2 * f) << 0.7 * node.y, 0.1 + 0.2 * node.x + 0.3 * node.y;
    }
    return d;
  }

  /// Motions that the edge excludes.
  int constraints() const {
    const Eigen::MatrixXd whole = Eigen::MatrixXd(WholeSystem(system).matrix());
    const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(whole).eigenvalues();
    return static_cast<int>((values.array() > 1e-9 * values.maxCoeff()).count());
  }

  /// Elements at the edge.
  int pieces() const { return static_cast<int>(sides_along(continuum.manifold, continuum.prescribed[0].along).size()); }
};

}  // namespace

TEST(HeldEdges, an_affine_motion_meets_what_a_cut_edge_is_held_to) {
  for (const double angle : {0.0, 0.2, 0.6}) {
    const Plate plate(angle);
    const Eigen::VectorXd d = plate.affine();
    const Eigen::VectorXd pull = plate.held.pull(1, d.size());
    EXPECT_LT((plate.system.times(d) - pull).norm(), 1e-12 * pull.norm()) << angle;
    EXPECT_LT(std::abs(plate.held.reactions(d, 1)[0].force.y), 1e-12 * pull.norm()) << angle;
  }
}

// An edge with the same error everywhere is pulled evenly: as by one force in its middle.
TEST(HeldEdges, an_even_pull_has_its_moment_about_the_middle_of_the_edge) {
  for (const double angle : {0.0, 0.2, 0.6}) {
    const Plate plate(angle);
    Eigen::VectorXd d = plate.affine();
    for (Eigen::Index i = 1; i < d.size(); i += 2) d[i] += 0.01;
    const auto reaction = plate.held.reactions(d, 1)[0];
    EXPECT_NEAR(reaction.moment / reaction.force.y, kWidth / 2, 1e-9 * kWidth) << angle;
  }
}

// Fixed point by point, a cut edge excludes as many motions as it has pieces and one more: all that their covers have.
TEST(HeldEdges, a_cut_edge_is_held_in_fewer_ways_than_it_has_pieces) {
  for (const double angle : {0.2, 0.6}) {
    const Plate plate(angle);
    EXPECT_LT(plate.constraints(), 0.75 * plate.pieces()) << angle;
    EXPECT_GT(plate.constraints(), 0.3 * plate.pieces()) << angle;
  }
}

}  // namespace keyblock::held_edges_test
