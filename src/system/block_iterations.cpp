// Implements the iterations once per block size; vectors are padded as the blocks are.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/block_iterations.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "base/context.hpp"
#include "base/loop.hpp"
#include "system/fours.hpp"
#include "system/incomplete_factor.hpp"

namespace keyblock {

namespace {

// Residual at which a correction in single precision ends and the residual is recomputed in double precision. Later,
// the directions would not fit the residual and would be lost. Iterations of step_bench --side 30 --ratio 100: 1815
// with 1e-5, 72 with 1e-3, 69 with this value.
constexpr double kInnerTolerance = 1e-2;
// Ratio of the true residual to that of the recurrence above which directions begin anew.
constexpr double kRestartRatio = 2;
// Iterations without a smaller residual after which a correction has reached the limit of single precision, or of the
// matrix.
constexpr int kIdleIterations = 100;
// Share of the residual left by a correction above which no further one is made.
constexpr double kLeastGain = 0.5;
// Factor on the target within which a residual is accepted if no further correction is made.
constexpr double kShortOfGoal = 10;
using namespace padded_rows;

// Returns the greatest entry of the diagonal, which is the greatest of a positive definite matrix.
double greatest_entry(const BlockMatrix& matrix) {
  double greatest = 0;
  for (int i = 0; i < matrix.block_count(); ++i)
    if (matrix.size(i) > 0) greatest = std::max(greatest, matrix.row(i).front().block.diagonal().cwiseAbs().maxCoeff());
  return greatest;
}

// Solves A y = r for one residual after another by conjugate gradients in single precision; search directions continue.
template <int N>
class InnerGradients {
 public:
  using Vector = PaddedVector<N, float>;
  using Vectors = std::vector<Vector>;

  explicit InnerGradients(std::size_t count) : y_(count), z_(count), p_(count), q_(count) {}

  // Divides the unit of the residual by this factor.
  void rescale(double factor) {
    if (squared_ == 0) return;
    squared_ *= factor * factor;
    for_each_entry(
        p_.size(), [&](std::size_t i) { p_[i].vector() *= static_cast<float>(factor); }, Work::light);
  }

  void restart() { squared_ = 0; }

  struct Correction {
    int iterations = 0;
    double residual_norm = 1;  ///< from the recurrence
  };

  // Solves for the unit residual r until its norm is at most `target`, or finds no smaller one.
  Correction correct(const Rows<N, float>& a, const IncompleteFactor<N>& factor, Vectors r, double target, int most) {
    std::ranges::fill(y_, Vector{});
    Correction made;
    double least = 1;
    int idle = 0;
    while (made.residual_norm > target && made.iterations < most && idle < kIdleIterations) {
      leave_if_stopped();
      const double squared = factor.solve(r, z_);
      if (!(squared > 0)) break;
      const auto beta = static_cast<float>(squared_ > 0 ? squared / squared_ : 0);
      squared_ = squared;
      for_each_entry(
          p_.size(),
          [&](std::size_t i) {
            z_[i].add(beta, p_[i]);
            p_[i] = z_[i];
          },
          Work::light);
      const auto [curvature] = sums_over<1>(p_.size(), [&](std::size_t i) {
        q_[i] = a.times(static_cast<int>(i), p_);
        return std::array{static_cast<double>(dot(p_[i], q_[i]))};
      });
      const auto alpha = static_cast<float>(squared / curvature);
      if (!(curvature > 0) || !std::isfinite(alpha)) break;
      const auto [norm_squared] = sums_over<1>(
          p_.size(),
          [&](std::size_t i) {
            y_[i].add(alpha, p_[i]);
            r[i].add(-alpha, q_[i]);
            return std::array{static_cast<double>(dot(r[i], r[i]))};
          },
          Work::light);
      made.residual_norm = std::sqrt(norm_squared);
      ++made.iterations;
      ++idle;
      if (made.residual_norm < least) {
        least = made.residual_norm;
        idle = 0;
      }
    }
    return made;
  }
  const Vectors& correction() const { return y_; }

 private:
  Vectors y_;
  Vectors z_;
  Vectors p_;
  Vectors q_;
  double squared_ = 0;  ///< r · z of the last iteration; 0 before the first direction
};

// Solves corrections A y = b − A x one after another. Directions are in single precision, which halves the memory
// traffic of an iteration, and each residual of x is in double precision. Compared with gradients all in double
// precision this adds no iterations at R = 2 and a sixth at R = 100. It needs two to three times as many where only the
// factorisation is useful (random walls whose springs are 1e4 to 1e5 of inertia).
template <int N>
IterationResult gradients(const BlockMatrix& matrix, const Eigen::VectorXd& b, const Eigen::VectorXd& start,
                          const IterationLimits& limits) {
  IterationResult result{start};
  const double size = b.norm();
  const double scale = greatest_entry(matrix);  // unit of A, because single precision has a smaller range than double
  if (!(scale > 0) || !std::isfinite(size)) return result;
  const Rows<N, float> rows = full_rows<N, float>(matrix, scale);
  const std::optional<IncompleteFactor<N>> factor = incomplete_factor(rows);
  if (!factor) return result;
  const double goal = limits.residual * size;
  InnerGradients<N> inner(at(matrix.block_count()));
  Eigen::VectorXd x = start;
  double before = std::numeric_limits<double>::infinity();
  double by_recurrence = before;
  while (true) {
    const Eigen::VectorXd residual = b - matrix * x;
    const double norm = residual.norm();
    if (norm / size < result.residual) {
      result.residual = norm / size;
      result.x = x;
    }
    const bool goes_on = norm <= kLeastGain * before && result.iterations < limits.count;
    result.converged = result.residual <= (goes_on ? 1 : kShortOfGoal) * limits.residual;
    if (result.converged || !goes_on) return result;
    if (norm > kRestartRatio * by_recurrence)
      inner.restart();
    else
      inner.rescale(before / norm);
    const auto correction = inner.correct(rows, *factor, with_padding<N, float>(matrix, residual / norm),
                                          std::max(goal / norm, kInnerTolerance), limits.count - result.iterations);
    result.iterations += correction.iterations;
    x += norm / scale * without_padding(matrix, inner.correction());
    before = norm;
    by_recurrence = correction.residual_norm * norm;
  }
}

template <int N>
IterationResult sweeps(const BlockMatrix& matrix, const Eigen::VectorXd& b, const Eigen::VectorXd& start, double omega,
                       const IterationLimits& limits) {
  IterationResult result{start};
  const Rows<N, double> rows = full_rows<N, double>(matrix, 1);
  std::vector<Padded<N>> inverse(at(rows.count()));
  for (int i = 0; i < rows.count(); ++i) inverse[at(i)].square() = rows.blocks[at(rows.diagonal(i))].square().inverse();
  auto x = with_padding<N, double>(matrix, start);
  const auto right = with_padding<N, double>(matrix, b);
  const double size = b.norm();
  const auto residual = [&] {
    const auto [sum] = sums_over<1>(x.size(), [&](std::size_t i) {
      PaddedVector<N> r = rows.times(static_cast<int>(i), x);
      r.add(-1, right[i]);
      return std::array{dot(r, r)};
    });
    return std::sqrt(sum) / size;
  };
  while (!(result.converged = (result.residual = residual()) <= limits.residual) && result.iterations < limits.count) {
    leave_if_stopped();
    for (int i = 0; i < rows.count(); ++i) {
      PaddedVector<N> r = right[at(i)];
      r.add(-1, rows.times(i, x));
      x[at(i)].add(omega, inverse[at(i)] * r);
    }
    ++result.iterations;
  }
  result.x = without_padding(matrix, x);
  return result;
}

// Without a load the solution is zero for any matrix.
bool is_nothing(const Eigen::VectorXd& b) {
  return (b.array() == 0).all();
}

IterationResult nothing(const Eigen::VectorXd& b) {
  return {Eigen::VectorXd::Zero(b.size()), 0, 0, true};
}

int largest_block(const BlockMatrix& matrix) {
  int largest = 0;
  for (int i = 0; i < matrix.block_count(); ++i) largest = std::max(largest, matrix.size(i));
  return largest;
}

}  // namespace

IterationResult conjugate_gradients(const BlockMatrix& matrix, const Eigen::VectorXd& b, const Eigen::VectorXd& start,
                                    const IterationLimits& limits) {
  if (is_nothing(b)) return nothing(b);
  const int largest = largest_block(matrix);
  if (largest <= 2) return gradients<2>(matrix, b, start, limits);
  if (largest <= 3) return gradients<3>(matrix, b, start, limits);
  return gradients<kMostBlockRows>(matrix, b, start, limits);
}

IterationResult over_relaxation(const BlockMatrix& matrix, const Eigen::VectorXd& b, const Eigen::VectorXd& start,
                                double omega, const IterationLimits& limits) {
  if (is_nothing(b)) return nothing(b);
  const int largest = largest_block(matrix);
  if (largest <= 2) return sweeps<2>(matrix, b, start, omega, limits);
  if (largest <= 3) return sweeps<3>(matrix, b, start, omega, limits);
  return sweeps<kMostBlockRows>(matrix, b, start, omega, limits);
}

}  // namespace keyblock
