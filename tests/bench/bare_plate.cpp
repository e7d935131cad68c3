// Solves a plate at rest with nothing around it: assembly of linear triangles, Cholesky's factor, one solution. It is
// the least that a static run of such a plate can cost. plate_bench.py compares both.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "system/cholmod/sparse_factor.hpp"

namespace keyblock::bench {
namespace {

constexpr double kYoungsModulus = 1000;
constexpr double kPoissonsRatio = 0.3;
constexpr double kPull = -0.001;  // on the free end, down
constexpr double kLength = 2;
constexpr double kFixed = 1e6;  // stiffness of supports over that of an element

using Element = Eigen::Matrix<double, 6, 6>;

// Plane strain; corners (0, 0), (a, 0), (a, b) and the same turned by 180 degrees, which has the same matrix.
Element stiffness(double a, double b) {
  Eigen::Matrix<double, 3, 6> strain = Eigen::Matrix<double, 3, 6>::Zero();
  const double dx[3] = {-1 / a, 1 / a, 0}, dy[3] = {0, -1 / b, 1 / b};
  for (int i = 0; i < 3; ++i) {
    strain(0, 2 * i) = strain(2, 2 * i + 1) = dx[i];
    strain(1, 2 * i + 1) = strain(2, 2 * i) = dy[i];
  }
  const double factor = kYoungsModulus / ((1 + kPoissonsRatio) * (1 - 2 * kPoissonsRatio));
  Eigen::Matrix3d law;
  law << 1 - kPoissonsRatio, kPoissonsRatio, 0, kPoissonsRatio, 1 - kPoissonsRatio, 0, 0, 0, 0.5 - kPoissonsRatio;
  return a * b / 2 * factor * strain.transpose() * law * strain;
}

/// Squares of a plate of length 2 and height 1, each of two triangles.
struct Grid {
  int rows;
  int columns() const { return 2 * rows; }
  int node(int column, int row) const { return column * (rows + 1) + row; }
  int unknowns() const { return 2 * (columns() + 1) * (rows + 1); }
};

Eigen::SparseMatrix<double> assembled(const Grid& grid) {
  const double side = kLength / grid.columns();
  const Element element = stiffness(side, side);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(2 * 21 * grid.columns() * grid.rows));
  const auto add = [&](const int(&nodes)[3]) {
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) {
        const int row = 2 * nodes[i / 2] + i % 2, column = 2 * nodes[j / 2] + j % 2;
        if (row >= column) entries.emplace_back(row, column, element(i, j));
      }
  };
  for (int c = 0; c < grid.columns(); ++c)
    for (int r = 0; r < grid.rows; ++r) {
      add({grid.node(c, r), grid.node(c + 1, r), grid.node(c + 1, r + 1)});
      add({grid.node(c + 1, r + 1), grid.node(c, r + 1), grid.node(c, r)});
    }
  for (int i = 0; i < 2 * (grid.rows + 1); ++i) entries.emplace_back(i, i, kFixed * kYoungsModulus);
  Eigen::SparseMatrix<double> matrix(grid.unknowns(), grid.unknowns());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

int run(int rows) {
  const Grid grid{rows};
  const Eigen::SparseMatrix<double> matrix = assembled(grid);
  SparseFactor factor(matrix, Definiteness::definite);
  factor.factorise(matrix);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(grid.unknowns());
  for (int r = 0; r <= rows; ++r)
    load[2 * grid.node(grid.columns(), r) + 1] = kPull / rows * (r == 0 || r == rows ? 0.5 : 1);
  const Eigen::VectorXd moved = factor.solve(load);
  std::printf("{\"unknowns\": %d, \"displacement\": %.6g}\n", grid.unknowns(),
              moved[2 * grid.node(grid.columns(), rows / 2) + 1]);
  return 0;
}

}  // namespace
}  // namespace keyblock::bench

int main(int count, char** words) {
  return keyblock::bench::run(count > 1 ? std::atoi(words[1]) : 157);
}
