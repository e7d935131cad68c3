// Builds one benchmark per function; see continuum_benchmarks.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/continuum_benchmarks.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "cut/covers/to_cover.hpp"

namespace keyblock {
namespace {

constexpr double kPi = std::numbers::pi;

Point zero(Point, Point) {
  return {};
}

Continuum continuum_of(Manifold manifold, const BlockMaterial& material, Plane plane, CoverFunctions functions) {
  Continuum continuum;
  continuum.manifold = std::move(manifold);
  continuum.materials = {material};
  continuum.plane = plane;
  continuum.functions = functions;
  return continuum;
}

auto deflection_at(Point x) {
  return [x](const Continuum& continuum, const ContinuumSolution& solution) {
    return displacement_at(continuum, solution, x).y;
  };
}

/// Points from `from` to `to` (rad) about the origin, both ends included, 64 chords.
std::vector<Point> arc(double radius, double from, double to) {
  constexpr int kChords = 64;
  std::vector<Point> points;
  for (int i = 0; i <= kChords; ++i) {
    const double angle = from + (to - from) * i / kChords;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  if (from == kPi / 2) points.front().x = 0;
  if (to == kPi / 2) points.back().x = 0;
  return points;
}

/// Kirsch's stresses in polar coordinates, rotated: tension 1 along x at infinity, hole of radius 1.
Stress kirsch_stress(Point x) {
  const double q = 1 / dot(x, x);
  const double t = std::atan2(x.y, x.x);
  const double rr = (1 - q) / 2 + (1 - 4 * q + 3 * q * q) / 2 * std::cos(2 * t);
  const double tt = (1 + q) / 2 - (1 + 3 * q * q) / 2 * std::cos(2 * t);
  const double rt = -(1 + 2 * q - 3 * q * q) / 2 * std::sin(2 * t);
  const double c = std::cos(t);
  const double s = std::sin(t);
  return {rr * c * c + tt * s * s - 2 * rt * s * c, rr * s * s + tt * c * c + 2 * rt * s * c,
          (rr - tt) * s * c + rt * (c * c - s * s)};
}

}  // namespace

ContinuumBenchmark unit_square(CoverFunctions functions, double h) {
  const std::vector<Point> corners = rectangle_corners({0, 0}, {1, 1});
  MeshSetting mesh;
  mesh.h = h;
  ContinuumBenchmark b;
  b.continuum = continuum_of(cut_body({corners}, mesh), elastic_material(1, 0.3), Plane::strain, functions);
  b.exact.displacement = [](Point p) {
    const double s = std::sin(kPi * p.x) * std::sin(kPi * p.y);
    return Point{s, s};
  };
  b.exact.gradient = [](Point p) {
    const double by_x = kPi * std::cos(kPi * p.x) * std::sin(kPi * p.y);
    const double by_y = kPi * std::sin(kPi * p.x) * std::cos(kPi * p.y);
    Eigen::Matrix2d g;
    g << by_x, by_y, by_x, by_y;
    return g;
  };
  // -div σ = -μ Δu - (λ + μ) grad div u.
  const double mu = 1 / 2.6;
  const double lambda = 0.3 / (1.3 * 0.4);
  b.continuum.body_force = [=](Point p) {
    const double s = std::sin(kPi * p.x) * std::sin(kPi * p.y);
    const double c = std::cos(kPi * p.x) * std::cos(kPi * p.y);
    const double each = kPi * kPi * (2 * mu * s + (lambda + mu) * (s - c));
    return Point{each, each};
  };
  b.continuum.prescribed = {{closed(corners), Held::both, at_any_normal(b.exact.displacement)}};
  return b;
}

ContinuumBenchmark exact_cantilever(CoverFunctions functions, double h) {
  const double length = 48, depth = 12, p = 1000, e = 3e7, nu = 0.3;
  const double inertia = depth * depth * depth / 12;
  const std::vector<Point> corners = rectangle_corners({0, -depth / 2}, {length, depth / 2});
  MeshSetting mesh;
  mesh.h = h;
  ContinuumBenchmark b;
  b.continuum = continuum_of(cut_body({corners}, mesh), elastic_material(e, nu), Plane::stress, functions);
  const double k = p / (6 * e * inertia);
  b.exact.displacement = [=](Point x) {
    return Point{-k * x.y * ((6 * length - 3 * x.x) * x.x + (2 + nu) * (x.y * x.y - depth * depth / 4)),
                 k * (3 * nu * x.y * x.y * (length - x.x) + (4 + 5 * nu) * depth * depth * x.x / 4 +
                      (3 * length - x.x) * x.x * x.x)};
  };
  b.exact.gradient = [=](Point x) {
    Eigen::Matrix2d g;
    g(0, 0) = -k * x.y * (6 * length - 6 * x.x);
    g(0, 1) = -k * ((6 * length - 3 * x.x) * x.x + (2 + nu) * (3 * x.y * x.y - depth * depth / 4));
    g(1, 0) = k * (-3 * nu * x.y * x.y + (4 + 5 * nu) * depth * depth / 4 + (6 * length - 3 * x.x) * x.x);
    g(1, 1) = k * 6 * nu * x.y * (length - x.x);
    return g;
  };
  b.continuum.prescribed = {{{corners[3], corners[0]}, Held::both, at_any_normal(b.exact.displacement)}};
  b.continuum.tractions = {{{corners[1], corners[2]}, [=](Point x, Point) {
                              return Point{0, p / (2 * inertia) * (depth * depth / 4 - x.y * x.y)};
                            }}};
  b.value = deflection_at({length, 0});
  b.reference =
      p * length * length * length / (3 * e * inertia) + (4 + 5 * nu) * p * depth * depth * length / (24 * e * inertia);
  return b;
}

ContinuumBenchmark clamped_cantilever(CoverFunctions functions, double rows) {
  const std::vector<Point> corners = rectangle_corners({0, 0}, {10, 1});
  MeshSetting mesh;
  mesh.side_over_row = 1.3;
  mesh.h = mesh.side_over_row / rows;
  mesh.angle = 0;
  mesh.through = {0.3 * mesh.h, 0.4 * mesh.h};
  ContinuumBenchmark b;
  b.continuum = continuum_of(cut_body({corners}, mesh), elastic_material(1000, 0.3), Plane::stress, functions);
  b.continuum.prescribed = {{{corners[3], corners[0]}, Held::both, zero}};
  b.continuum.tractions = {{{corners[1], corners[2]}, [](Point, Point) { return Point{0, 1}; }}};
  b.value = deflection_at({10, 0.5});
  b.reference = 4.0238;
  return b;
}

ContinuumBenchmark supported_beam(CoverFunctions functions, double h) {
  const std::vector<Point> corners = rectangle_corners({0, 0}, {5, 1});
  MeshSetting mesh;
  mesh.h = h;
  ContinuumBenchmark b;
  b.continuum = continuum_of(cut_body({corners}, mesh), elastic_material(1000, 0.3), Plane::stress, functions);
  b.continuum.prescribed = {{{corners[1], corners[2]}, Held::normal, zero}};
  b.continuum.tractions = {{{corners[3], corners[0]}, [](Point x, Point) { return Point{0, 3 * x.y * (1 - x.y)}; }}};
  const auto element = [&](Point x) { return element_at(b.continuum.manifold, 0, x); };
  b.continuum.point_forces = {{element({5, 1}), {5, 1}, {0, -0.5}}};
  b.continuum.point_springs = {{element({0, 0.5}), {0, 0.5}, {0, 1}, 1000}};
  b.value = [](const Continuum& continuum, const ContinuumSolution& solution) {
    return displacement_at(continuum, solution, {0, 0.5}).y - displacement_at(continuum, solution, {5, 0.5}).y;
  };
  b.reference = 0.25 * (1 + 2.85 / 100 - 0.84 / 1000);
  return b;
}

ContinuumBenchmark thick_cylinder(CoverFunctions functions, double h, double poissons_ratio) {
  const std::vector<Point> outer = arc(2, 0, kPi / 2);
  const std::vector<Point> inner = arc(1, kPi / 2, 0);
  std::vector<Point> corners = outer;
  corners.insert(corners.end(), inner.begin(), inner.end());
  MeshSetting mesh;
  mesh.h = h;
  ContinuumBenchmark b;
  b.continuum =
      continuum_of(cut_body({corners}, mesh), elastic_material(1000, poissons_ratio), Plane::strain, functions);
  b.continuum.prescribed = {{{inner.back(), outer.front()}, Held::normal, zero},
                            {{outer.back(), inner.front()}, Held::normal, zero}};
  b.continuum.tractions = {{inner, [](Point, Point n) { return -1 * n; }}};
  b.value = [](const Continuum& continuum, const ContinuumSolution& solution) {
    const Point x{std::sqrt(0.5), std::sqrt(0.5)};
    return dot(displacement_at(continuum, solution, x), x);
  };
  b.reference = (1 + poissons_ratio) / 1000 / 3 * (1 - 2 * poissons_ratio + 4);
  return b;
}

ContinuumBenchmark kirsch_plate(CoverFunctions functions, double h) {
  const std::vector<Point> hole = arc(1, kPi / 2, 0);
  std::vector<Point> corners = {{5, 0}, {5, 5}, {0, 5}};
  corners.insert(corners.end(), hole.begin(), hole.end());
  MeshSetting mesh;
  mesh.h = h;
  ContinuumBenchmark b;
  b.continuum = continuum_of(cut_body({corners}, mesh), elastic_material(1, 0.3), Plane::stress, functions);
  b.continuum.prescribed = {{{{1, 0}, {5, 0}}, Held::normal, zero}, {{{0, 5}, {0, 1}}, Held::normal, zero}};
  b.continuum.tractions = {{{{5, 0}, {5, 5}, {0, 5}}, [](Point x, Point n) {
                              const Stress s = kirsch_stress(x);
                              return Point{s.xx * n.x + s.xy * n.y, s.xy * n.x + s.yy * n.y};
                            }}};
  b.value = [](const Continuum& continuum, const ContinuumSolution& solution) {
    return stress_at(continuum, solution, {0, 1}).xx;
  };
  b.reference = 3;
  return b;
}

ContinuumBenchmark cook_membrane(CoverFunctions functions, double h) {
  const std::vector<Point> corners = {{0, 0}, {48, 44}, {48, 60}, {0, 44}};
  MeshSetting mesh;
  mesh.h = h;
  ContinuumBenchmark b;
  b.continuum = continuum_of(cut_body({corners}, mesh), elastic_material(1, 1.0 / 3), Plane::stress, functions);
  b.continuum.prescribed = {{{corners[3], corners[0]}, Held::both, zero}};
  b.continuum.tractions = {{{corners[1], corners[2]}, [](Point, Point) { return Point{0, 1.0 / 16}; }}};
  b.value = deflection_at({48, 52});
  b.reference = 23.966;
  return b;
}

Continuum swept_plate(CoverFunctions functions, double share) {
  const std::vector<Point> corners = rectangle_corners({0, 0}, {1, 0.5});
  MeshSetting mesh;
  mesh.h = 0.125;
  mesh.angle = 0;
  mesh.through = {1 - share * mesh.h, 0.5 - share * mesh.h / mesh.side_over_row};
  Continuum continuum = continuum_of(cut_body({corners}, mesh), elastic_material(1, 0.3), Plane::stress, functions);
  continuum.prescribed = {{{corners[3], corners[0]}, Held::both, zero}};
  continuum.tractions = {{{corners[1], corners[2]}, [](Point, Point) { return Point{0, -1}; }}};
  return continuum;
}

GradientRun conjugate_gradients(const Continuum& continuum, GradientScaling scaling) {
  constexpr double kNull = 1e-12;  // of the largest eigenvalue of a block: below it round-off
  constexpr int kMost = 100000;
  const CoverBasis basis(continuum.manifold, continuum.functions);
  const SparseSystem system = assemble_static(continuum, basis);
  const Eigen::SparseMatrix<double>& lower = system.lower();
  const auto covers = static_cast<Eigen::Index>(continuum.manifold.covers.size());
  const Eigen::Index size = scaling == GradientScaling::diagonal ? 1 : lower.rows() / covers;
  std::vector<Eigen::MatrixXd> inverses;
  for (Eigen::Index first = 0; first < lower.rows(); first += size) {
    const Eigen::MatrixXd block =
        Eigen::MatrixXd(lower.block(first, first, size, size)).selfadjointView<Eigen::Lower>();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> parts(block);
    const double least = kNull * parts.eigenvalues().maxCoeff();
    const Eigen::VectorXd inverse =
        parts.eigenvalues().unaryExpr([&](double value) { return value > least ? 1 / value : 0; });
    inverses.push_back(parts.eigenvectors() * inverse.asDiagonal() * parts.eigenvectors().transpose());
  }
  const auto scaled = [&](const Eigen::VectorXd& r) {
    Eigen::VectorXd z(r.size());
    for (std::size_t b = 0; b < inverses.size(); ++b) {
      const Eigen::Index first = static_cast<Eigen::Index>(b) * size;
      z.segment(first, size) = inverses[b] * r.segment(first, size);
    }
    return z;
  };
  Eigen::VectorXd r = system.load();
  Eigen::VectorXd z = scaled(r);
  Eigen::VectorXd p = z;
  double rho = r.dot(z);
  const double wanted = 1e-8 * r.norm();
  std::vector<double> diagonal;  // of Lanczos' tridiagonal matrix
  std::vector<double> beside;
  double last_alpha = 1;
  double beta = 0;
  while (r.norm() > wanted && static_cast<int>(diagonal.size()) < kMost) {
    const Eigen::VectorXd kp = lower.selfadjointView<Eigen::Lower>() * p;
    const double alpha = rho / p.dot(kp);
    diagonal.push_back(1 / alpha + (diagonal.empty() ? 0 : beta / last_alpha));
    r -= alpha * kp;
    z = scaled(r);
    const double next = r.dot(z);
    beta = next / rho;
    rho = next;
    beside.push_back(std::sqrt(beta) / alpha);
    last_alpha = alpha;
    p = z + beta * p;
  }
  const auto n = static_cast<Eigen::Index>(diagonal.size());
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> values;
  values.computeFromTridiagonal(Eigen::Map<Eigen::VectorXd>(diagonal.data(), n),
                                Eigen::Map<Eigen::VectorXd>(beside.data(), n - 1), Eigen::EigenvaluesOnly);
  return {static_cast<int>(n), values.eigenvalues().maxCoeff() / values.eigenvalues().minCoeff()};
}

}  // namespace keyblock
