// Patches of linear and quadratic fields, rigid motion, rates of convergence, and refusals, on meshes that no side of
// the body follows.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/bodies/linear_static.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/continuum_benchmarks.hpp"

namespace keyblock::linear_static_test {
namespace {

/// u_i = a_i + G_i x + quadratic terms: constant strain where there are none.
ExactField polynomial_field(double quadratic) {
  ExactField field;
  field.displacement = [=](Point p) {
    return Point{1e-3 * (p.x + p.y / 2) + quadratic * (p.x * p.x - 2 * p.x * p.y),
                 1e-3 * (p.y + p.x / 2) + quadratic * (0.5 * p.y * p.y + p.x * p.y)};
  };
  field.gradient = [=](Point p) {
    Eigen::Matrix2d g;
    g << 1e-3 + quadratic * (2 * p.x - 2 * p.y), 0.5e-3 - 2 * quadratic * p.x, 0.5e-3 + quadratic * p.y,
        1e-3 + quadratic * (p.y + p.x);
    return g;
  };
  return field;
}

/// The benchmark's plate (0.24 × 0.12, nmm-01), every side fixed by the exact field, which a body force keeps in
/// equilibrium.
Continuum patch(CoverFunctions functions, const MeshSetting& mesh, double quadratic, Plane plane = Plane::stress) {
  Continuum continuum;
  const std::vector<Point> corners = rectangle_corners({0, 0}, {0.24, 0.12});
  continuum.manifold = cut_body({corners}, mesh);
  continuum.materials = {elastic_material(1e6, 0.25)};
  continuum.plane = plane;
  continuum.functions = functions;
  continuum.prescribed = {{closed(corners), Held::both, at_any_normal(polynomial_field(quadratic).displacement)}};
  // -div σ of the quadratic terms: strains ex,x = 2q, ey,y = q, gxy,x = q, gxy,y = -2q + q, ex,y = -2q, ey,x = q.
  const Eigen::Matrix3d d = continuum.modulus(0);
  const Eigen::Vector3d by_x(2 * quadratic, quadratic, -2 * quadratic);
  const Eigen::Vector3d by_y(-2 * quadratic, quadratic, quadratic);
  const Eigen::Vector3d sigma_x = d * by_x;
  const Eigen::Vector3d sigma_y = d * by_y;
  const Point force{-sigma_x(0) - sigma_y(2), -sigma_x(2) - sigma_y(1)};
  continuum.body_force = [force](Point) { return force; };
  return continuum;
}

// A row of nodes 1e-8 of a side below the upper edge, another as near to the right: elements of 1e-8 and 1e-16 of a
// triangle.
MeshSetting sliver_mesh(double share) {
  MeshSetting mesh;
  mesh.h = 0.03;
  mesh.angle = 0;
  mesh.through = {0.24 - share * mesh.h, 0.12 - share * mesh.h};
  return mesh;
}

double bound(CoverFunctions functions) {
  return functions == CoverFunctions::quadratic ? 1e-11 : 1e-12;
}

}  // namespace

TEST(LinearStatic, a_linear_field_is_exact_on_a_mesh_that_no_side_follows) {
  for (const CoverFunctions functions : kAllCoverFunctions) {
    for (const Plane plane : {Plane::stress, Plane::strain}) {
      MeshSetting mesh{0.04};
      mesh.through = {0.013, 0.007};
      const Continuum continuum = patch(functions, mesh, 0, plane);
      const ContinuumSolution solution = solve_static(continuum);
      EXPECT_LT(errors_of(continuum, solution, polynomial_field(0)).largest, bound(functions)) << name_of(functions);
      const Stress stress = stress_at(continuum, solution, {0.1, 0.05});
      // E/(1-ν²)·(1+ν)·1e-3 = 1333.33 and G·1e-3 = 400 in plane stress, 1600 and 400 in plane strain (Hooke).
      const double expected = plane == Plane::stress ? 4000.0 / 3 : 1600;
      EXPECT_NEAR(stress.xx, expected, 1e-8 * expected) << name_of(functions);
      EXPECT_NEAR(stress.yy, expected, 1e-8 * expected) << name_of(functions);
      EXPECT_NEAR(stress.xy, 400, 1e-8 * 400) << name_of(functions);
    }
  }
}

TEST(LinearStatic, slivers_down_to_1e_8_of_an_element_leave_the_patch_exact) {
  for (const CoverFunctions functions : kAllCoverFunctions) {
    for (const double share : {1e-2, 1e-4, 1e-6, 1e-8}) {
      const Continuum continuum = patch(functions, sliver_mesh(share), 0);
      const FieldErrors errors = errors_of(continuum, solve_static(continuum), polynomial_field(0));
      EXPECT_LT(errors.largest, bound(functions)) << name_of(functions) << ", sliver " << share;
    }
  }
}

TEST(LinearStatic, a_quadratic_field_is_exact_in_all_but_constant_cover_functions) {
  for (const CoverFunctions functions : {CoverFunctions::derived, CoverFunctions::linear, CoverFunctions::quadratic}) {
    for (const MeshSetting& mesh : {MeshSetting{0.04}, sliver_mesh(1e-8)}) {
      const Continuum continuum = patch(functions, mesh, 0.02);
      const FieldErrors errors = errors_of(continuum, solve_static(continuum), polynomial_field(0.02));
      EXPECT_LT(errors.largest, bound(functions)) << name_of(functions);
    }
  }
  const Continuum first = patch(CoverFunctions::constant, MeshSetting{0.04}, 0.02);
  EXPECT_GT(errors_of(first, solve_static(first), polynomial_field(0.02)).largest, 1e-4) << "the field tells nothing";
}

TEST(LinearStatic, a_rigid_motion_makes_no_stress) {
  for (const CoverFunctions functions : kAllCoverFunctions) {
    Continuum continuum = patch(functions, MeshSetting{0.04}, 0);
    continuum.prescribed[0].value = [](Point p, Point) { return Point{0.3 - p.y, -0.2 + p.x}; };
    const ContinuumSolution solution = solve_static(continuum);
    for (const Point p : {Point{0.01, 0.01}, Point{0.2, 0.1}, Point{0.24, 0.12}}) {
      const Stress stress = stress_at(continuum, solution, p);
      EXPECT_LT(std::abs(stress.xx) + std::abs(stress.yy) + std::abs(stress.xy), 1e6 * bound(functions) * 100)
          << name_of(functions);
      EXPECT_NEAR(displacement_at(continuum, solution, p).x, 0.3 - p.y, bound(functions));
    }
  }
}

// Pulled at both ends by 1000 (ν 0.25), fixed only by lines of symmetry: sxx 1000, u = x/1000, v = -y/4000.
TEST(LinearStatic, tractions_and_lines_of_symmetry_give_a_uniaxial_bar) {
  for (const CoverFunctions functions : kAllCoverFunctions) {
    Continuum continuum = patch(functions, sliver_mesh(1e-8), 0);
    const auto zero = [](Point, Point) { return Point{}; };
    continuum.prescribed = {{{{0, 0}, {0.24, 0}}, Held::normal, zero}, {{{0, 0}, {0, 0.12}}, Held::normal, zero}};
    continuum.tractions = {{{{0.24, 0}, {0.24, 0.12}}, [](Point, Point n) { return 1000 * n; }}};
    const ContinuumSolution solution = solve_static(continuum);
    const Point u = displacement_at(continuum, solution, {0.24, 0.12});
    EXPECT_NEAR(u.x, 0.24e-3, 1e-14) << name_of(functions);
    EXPECT_NEAR(u.y, -0.03e-3, 1e-14) << name_of(functions);
    EXPECT_NEAR(stress_at(continuum, solution, {0.1, 0.1}).xx, 1000, 1e-7);
  }
}

// A corner fixed on both sides and cut small along one or both is where the stabilisation is weakest.
TEST(LinearStatic, corners_cut_small_stay_definite) {
  for (const CoverFunctions functions : kAllCoverFunctions) {
    for (const double share : {0.5, 1e-2, 1e-8}) {
      for (const Point corner : {Point{0, 0}, Point{0.24, 0}, Point{0.24, 0.12}}) {
        MeshSetting mesh = sliver_mesh(1e-4);
        mesh.through = {corner.x > 0 ? corner.x - share * mesh.h : share * mesh.h,
                        corner.y > 0 ? corner.y - 1e-4 * mesh.h : 1e-4 * mesh.h};
        EXPECT_NO_THROW(solve_static(patch(functions, mesh, 0))) << name_of(functions) << ", cut " << share;
      }
    }
  }
}

// L2 and energy errors fall by the powers 2 and 1, 3 and 2, 4 and 3 of h (finite element theory), at least, less 0.1.
TEST(LinearStatic, errors_fall_at_the_rates_of_theory) {
  const struct {
    CoverFunctions functions;
    double h;
    double order;
  } cases[] = {{CoverFunctions::constant, 1.0 / 16, 1},
               {CoverFunctions::derived, 1.0 / 8, 2},
               {CoverFunctions::linear, 1.0 / 8, 2},
               {CoverFunctions::quadratic, 1.0 / 4, 3}};
  for (const auto& [functions, h, order] : cases) {
    FieldErrors errors[2];
    for (const int halvings : {0, 1}) {
      const ContinuumBenchmark square = unit_square(functions, halvings == 0 ? h : h / 2);
      errors[halvings] = errors_of(square.continuum, solve_static(square.continuum), square.exact);
    }
    EXPECT_GT(std::log2(errors[0].l2 / errors[1].l2), order + 0.9) << name_of(functions);
    EXPECT_GT(std::log2(errors[0].energy / errors[1].energy), order - 0.1) << name_of(functions);
  }
}

// The field of Timoshenko & Goodier is cubic.
TEST(LinearStatic, quadratic_cover_functions_bend_a_cantilever_exactly) {
  const ContinuumBenchmark beam = exact_cantilever(CoverFunctions::quadratic, 6);
  const ContinuumSolution solution = solve_static(beam.continuum);
  EXPECT_NEAR(beam.value(beam.continuum, solution), 0.0089, 1e-11 * 0.0089);
  EXPECT_LT(errors_of(beam.continuum, solution, beam.exact).energy, 1e-11);
}

TEST(LinearStatic, derived_gradients_reach_the_benchmarks_with_few_unknowns) {
  const struct {
    ContinuumBenchmark benchmark;
    double tolerance;  // of the reference: that of the problem itself
  } cases[] = {{exact_cantilever(CoverFunctions::derived, 3), 1e-3},
               {clamped_cantilever(CoverFunctions::derived, 4.3), 1e-3},
               {supported_beam(CoverFunctions::derived, 0.25), 5e-3},
               {thick_cylinder(CoverFunctions::derived, 0.125), 1e-3},
               {cook_membrane(CoverFunctions::derived, 1.85), 1e-3}};
  for (const auto& [benchmark, tolerance] : cases) {
    const double value = benchmark.value(benchmark.continuum, solve_static(benchmark.continuum));
    EXPECT_NEAR(value, benchmark.reference, tolerance * benchmark.reference);
  }
}

TEST(LinearStatic, a_body_that_can_still_move_is_refused) {
  Continuum continuum = patch(CoverFunctions::constant, MeshSetting{0.04}, 0);
  continuum.prescribed.clear();
  EXPECT_THROW(solve_static(continuum), NotPositiveDefinite);
}

}  // namespace keyblock::linear_static_test
