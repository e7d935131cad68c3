// Solves weighted least squares over stars; see derived_gradients.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/derived_gradients.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace keyblock {
namespace {

constexpr int kFewestNeighbours = 6;
constexpr double kWorstCondition = 50;

using Neighbours = std::vector<std::vector<int>>;

/// Returns, per cover, the covers that share an element with it, ascending, without itself.
Neighbours neighbours_of(const Manifold& manifold) {
  Neighbours all(manifold.covers.size());
  for (std::size_t c = 0; c < all.size(); ++c) {
    for (const int e : manifold.elements_of(manifold.covers[c])) {
      for (const int other : manifold.elements[static_cast<std::size_t>(e)].covers) {
        if (other != static_cast<int>(c)) all[c].push_back(other);
      }
    }
    std::sort(all[c].begin(), all[c].end());
    all[c].erase(std::unique(all[c].begin(), all[c].end()), all[c].end());
  }
  return all;
}

std::vector<int> with_second_ring(const Neighbours& neighbours, int cover) {
  std::vector<int> both;
  for (const int near : neighbours[static_cast<std::size_t>(cover)]) {
    both.push_back(near);
    const std::vector<int>& beyond = neighbours[static_cast<std::size_t>(near)];
    both.insert(both.end(), beyond.begin(), beyond.end());
  }
  std::sort(both.begin(), both.end());
  both.erase(std::unique(both.begin(), both.end()), both.end());
  both.erase(std::remove(both.begin(), both.end(), cover), both.end());
  return both;
}

/// Fits d_j - d_0 by g·x + quadratic terms: rows √w (x, y | x², xy, y²).
class Fit {
 public:
  Fit(const std::vector<Point>& offsets, double h) : h_(h) {
    const auto n = static_cast<Eigen::Index>(offsets.size());
    assert(n >= kLinear);  // the other corners of an element
    columns_.resize(n, kLinear + kQuadratic);
    root_weights_.resize(n);
    for (Eigen::Index j = 0; j < n; ++j) {
      const Point p = (1 / h) * offsets[static_cast<std::size_t>(j)];
      root_weights_(j) = 1 / std::max(length(p), 0.5);
      columns_.row(j) = root_weights_(j) * Eigen::RowVector<double, 5>(p.x, p.y, p.x * p.x, p.x * p.y, p.y * p.y);
    }
    qr_.compute(columns_);
    // The triangle of QR below its first two rows holds the part of the quadratic terms beyond linear ones. A small
    // part is not determined.
    Eigen::Matrix3d beyond = Eigen::Matrix3d::Zero();
    const Eigen::Index rows = std::min<Eigen::Index>(n - kLinear, kQuadratic);
    if (rows > 0)
      beyond.topRows(rows) = qr_.matrixQR().block(kLinear, kLinear, rows, kQuadratic).triangularView<Eigen::Upper>();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(beyond, Eigen::ComputeFullV);
    const double threshold = columns_.leftCols<kLinear>().norm() / kWorstCondition;
    while (rank_ < kQuadratic && svd.singularValues()(rank_) > threshold) ++rank_;
    determined_ = svd.matrixV();
  }

  bool is_complete() const { return rank_ == kQuadratic; }

  /// Returns the gradient from the differences d_j - d_0, 2 × n.
  Eigen::Matrix2Xd gradient() const {
    if (is_complete()) return first_rows_of_inverse(qr_);
    Eigen::MatrixXd columns(columns_.rows(), kLinear + rank_);
    columns << columns_.leftCols<kLinear>(), columns_.rightCols<kQuadratic>() * determined_.leftCols(rank_);
    return first_rows_of_inverse(columns.householderQr());
  }

 private:
  static constexpr Eigen::Index kLinear = 2;
  static constexpr Eigen::Index kQuadratic = 3;

  // Returns the rows of R⁻¹ Qᵀ that give x and y, times the weights.
  template <typename Qr>
  Eigen::Matrix2Xd first_rows_of_inverse(const Qr& qr) const {
    const Eigen::Index count = qr.cols();
    Eigen::MatrixX2d rows = Eigen::MatrixX2d::Identity(qr.rows(), kLinear);
    const auto triangle = qr.matrixQR().topLeftCorner(count, count).template triangularView<Eigen::Upper>();
    triangle.transpose().solveInPlace(rows.topRows(count));
    rows.applyOnTheLeft(qr.householderQ());
    return (root_weights_.asDiagonal() * rows).transpose() / h_;
  }

  double h_;
  Eigen::Index rank_ = 0;
  Eigen::VectorXd root_weights_;
  Eigen::Matrix<double, Eigen::Dynamic, 5> columns_;
  Eigen::HouseholderQR<Eigen::Matrix<double, Eigen::Dynamic, 5>> qr_;
  Eigen::Matrix3d determined_;  ///< combinations of the quadratic terms, the best determined first
};

}  // namespace

std::vector<CoverGradient> derived_gradients(const Manifold& manifold) {
  const Neighbours neighbours = neighbours_of(manifold);
  const auto node = [&](int c) {
    return manifold.mesh.nodes[static_cast<std::size_t>(manifold.covers[static_cast<std::size_t>(c)].node)];
  };
  std::vector<CoverGradient> gradients(manifold.covers.size());
  for (int c = 0; c < static_cast<int>(manifold.covers.size()); ++c) {
    const auto offsets_of = [&](const std::vector<int>& covers) {
      std::vector<Point> offsets;
      for (const int j : covers) offsets.push_back(node(j) - node(c));
      return offsets;
    };
    std::vector<int> star = neighbours[static_cast<std::size_t>(c)];
    double h = 0;
    for (const Point& p : offsets_of(star)) h += length(p) / static_cast<double>(star.size());
    const Fit near(offsets_of(star), h);
    const bool is_enough = star.size() >= kFewestNeighbours && near.is_complete();
    if (!is_enough) star = with_second_ring(neighbours, c);
    const Eigen::Matrix2Xd weights = is_enough ? near.gradient() : Fit(offsets_of(star), h).gradient();
    std::vector<CoverGradient::Share>& shares = gradients[static_cast<std::size_t>(c)].shares;
    Point sum;
    for (std::size_t j = 0; j < star.size(); ++j) {
      const Point weight{weights(0, static_cast<Eigen::Index>(j)), weights(1, static_cast<Eigen::Index>(j))};
      shares.push_back({star[j], weight});
      sum = sum + weight;
    }
    shares.push_back({c, -1 * sum});
  }
  return gradients;
}

}  // namespace keyblock
