// Computes a product in two passes: forces pair by pair, then their sum block by block, so that nothing is written
// twice. Corrections use single precision, with less than half the memory traffic; residuals use double precision.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solve/pair_system.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/context.hpp"
#include "base/loop.hpp"
#include "contact/solve/pair_operator.hpp"

namespace keyblock {

class PairSystem::Kernel {
 public:
  virtual ~Kernel() = default;
  virtual Result solve(const std::vector<PairStiffness>& h, const Eigen::VectorXd& f, const Eigen::VectorXd& start,
                       double goal, int most_products) const = 0;
  virtual Eigen::VectorXd answer(const Eigen::VectorXd& f) const = 0;
};

namespace {

// Least residual fraction that a correction in single precision can leave.
constexpr double kSingle = 1e-4;
// Round-off between two equal entries of A, relative to the greatest.
constexpr double kSymmetric = 1e-10;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

// Corrections of one system.
template <int N>
class Corrections {
 public:
  using Coarse = PairOperator<N, float>;
  using Block = typename Coarse::Block;
  using Blocks = typename Coarse::Blocks;

  Corrections(const Coarse& of, const std::vector<PairStiffness>& h, bool has_symmetric_blocks)
      : of_(of),
        h_(h),
        is_symmetric_(has_symmetric_blocks && std::ranges::all_of(h, &PairStiffness::is_symmetric)),
        forces_(of.rows.size()),
        inverse_(of.block_count()) {
    using Square = typename Padded<N, float>::Square;
    for_each_entry(of.block_count(), [&](std::size_t e) {
      const Square block = diagonal(e);
      inverse_[e].square() =
          is_symmetric_ ? Square(block.llt().solve(Square::Identity())) : Square(block.partialPivLu().inverse());
    });
  }

  struct Result {
    Blocks x;
    int products = 0;
  };

  // Solves from zero until the residual is down to `goal` or stops falling.
  Result of(Blocks r, double goal, int most_products) {
    return is_symmetric_ ? of_symmetric(std::move(r), goal, most_products) : of_any(std::move(r), goal, most_products);
  }

 private:
  Result of_symmetric(Blocks r, double goal, int most_products) {
    const std::size_t count = of_.block_count();
    Result result{Blocks(count + 1), 0};
    Blocks p(count + 1);
    Blocks q(count);
    double rho = 0;
    while (result.products < most_products) {
      leave_if_stopped();
      const double before = rho;
      rho = sums_over<1>(count, [&](std::size_t e) { return std::array{double{dot(r[e], inverse_[e] * r[e])}}; })[0];
      const double beta = before > 0 ? rho / before : 0;
      if (!std::isfinite(beta)) break;
      for_each_entry(count, [&](std::size_t e) {
        Block next = inverse_[e] * r[e];
        next.add(static_cast<float>(beta), p[e]);
        p[e] = next;
      });
      of_.multiply(h_, p, forces_, [&](std::size_t e, const Block& y) { q[e] = y; });
      ++result.products;
      const double alpha =
          rho / sums_over<1>(count, [&](std::size_t e) { return std::array{double{dot(p[e], q[e])}}; })[0];
      if (!std::isfinite(alpha)) break;
      for_each_entry(count, [&](std::size_t e) {
        result.x[e].add(static_cast<float>(alpha), p[e]);
        r[e].add(-static_cast<float>(alpha), q[e]);
      });
      if (!(of_.greatest(r) > goal)) break;
    }
    return result;
  }

  Result of_any(Blocks r, double goal, int most_products) {
    const std::size_t count = of_.block_count();
    Result result{Blocks(count + 1), 0};
    const Blocks shadow = r;
    Blocks p(count);
    Blocks q(count);
    Blocks t(count);
    Blocks p_hat(count + 1);
    Blocks s_hat(count + 1);
    const auto with_shadow = [&](const Blocks& other) {
      return sums_over<1>(count, [&](std::size_t e) { return std::array{double{dot(shadow[e], other[e])}}; })[0];
    };
    double rho = with_shadow(r);
    double beta = 0;
    double omega = 0;
    while (result.products + 2 <= most_products) {
      leave_if_stopped();
      for_each_entry(count, [&](std::size_t e) {
        p[e].add(-static_cast<float>(omega), q[e]);
        Block next = r[e];
        next.add(static_cast<float>(beta), p[e]);
        p[e] = next;
        p_hat[e] = inverse_[e] * next;
      });
      of_.multiply(h_, p_hat, forces_, [&](std::size_t e, const Block& y) { q[e] = y; });
      const double alpha = rho / with_shadow(q);
      if (!std::isfinite(alpha)) break;
      for_each_entry(count, [&](std::size_t e) {
        r[e].add(-static_cast<float>(alpha), q[e]);
        s_hat[e] = inverse_[e] * r[e];
      });
      of_.multiply(h_, s_hat, forces_, [&](std::size_t e, const Block& y) { t[e] = y; });
      const auto [ts, tt] = sums_over<2>(count, [&](std::size_t e) {
        return std::array{double{dot(t[e], r[e])}, double{dot(t[e], t[e])}};
      });
      omega = tt > 0 ? ts / tt : 0;
      for_each_entry(count, [&](std::size_t e) {
        result.x[e].add(static_cast<float>(alpha), p_hat[e]);
        result.x[e].add(static_cast<float>(omega), s_hat[e]);
        r[e].add(-static_cast<float>(omega), t[e]);
      });
      result.products += 2;
      if (!(of_.greatest(r) > goal)) break;
      const double before = rho;
      rho = with_shadow(r);
      beta = rho / before * alpha / omega;
      if (!std::isfinite(beta)) break;
    }
    return result;
  }

  typename Padded<N, float>::Square diagonal(std::size_t e) const {
    Padded<N, float> all = of_.stiffness[e];
    of_.sides.for_each(e, [&](std::size_t i, std::size_t s) {
      if (h_[i].is_none()) return;
      const auto& [normal, tangential] = of_.rows[i][s];
      Block of_normal;  // forces on this block per normal rate
      of_normal.add(static_cast<float>(h_[i].nn), normal);
      of_normal.add(static_cast<float>(h_[i].tn), tangential);
      for (int c = 0; c < N; ++c)
        for (int l = 0; l < Block::kLanes; ++l)
          all.lane(c, l) += of_normal.lane(l) * normal.entries[at(c)] +
                            tangential.lane(l) * (static_cast<float>(h_[i].tt) * tangential.entries[at(c)]);
    });
    typename Padded<N, float>::Square square = all.square();
    for (int k = 0; k < N; ++k)
      if (square(k, k) == 0) square(k, k) = 1;  // padding
    return square;
  }

  const Coarse& of_;
  const std::vector<PairStiffness>& h_;
  bool is_symmetric_;
  std::vector<typename Coarse::Forces> forces_;
  std::vector<Padded<N, float>> inverse_;  ///< of the diagonal blocks
};

template <int N>
class KernelOf : public PairSystem::Kernel {
 public:
  using Result = PairSystem::Result;
  using Fine = PairOperator<N, double>;
  using Block = typename Fine::Block;
  using Blocks = typename Fine::Blocks;

  KernelOf(const ContactRows& rows, const BlockNumbers& blocks, const Table<ElementIndex, UnknownBlock>& flexibility) {
    const auto count = at(blocks.count());
    fine_.blocks.resize(rows.size() / 2);
    fine_.rows.resize(rows.size() / 2);
    fine_.stiffness.resize(count);
    fine_.flexibility.resize(count);
    for_each_entry(fine_.rows.size(), [&](std::size_t i) {
      const ContactRow& normal = rows[2 * i];
      const ContactRow& tangential = rows[2 * i + 1];
      const int a = blocks.of(normal.vertex_element);
      const int b = blocks.of(normal.edge_element);
      fine_.blocks[i] = {a < 0 ? blocks.count() : a, b < 0 ? blocks.count() : b};
      fine_.rows[i][0] = {padded(normal.of_vertex, blocks.size(a)), padded(tangential.of_vertex, blocks.size(a))};
      fine_.rows[i][1] = {padded(normal.of_edge, blocks.size(b)), padded(tangential.of_edge, blocks.size(b))};
    });
    for (ElementIndex e : indices(flexibility)) {
      const int block = blocks.of(e);
      if (block < 0) continue;
      const int size = blocks.size(block);
      fine_.stiffness[at(block)].square().topLeftCorner(size, size) = blocks.stiffness(block);
      fine_.flexibility[at(block)].square().topLeftCorner(size, size) = flexibility[e].topLeftCorner(size, size);
    }
    fine_.sides = SidesOfBlocks(fine_.blocks, count);
    for (const Padded<N>& block : fine_.stiffness)
      stiffest_ = std::max(stiffest_, block.square().diagonal().cwiseAbs().maxCoeff());
    has_symmetric_blocks_ = std::ranges::all_of(fine_.stiffness, [&](const Padded<N>& block) {
      return (block.square() - block.square().transpose()).cwiseAbs().maxCoeff() <= kSymmetric * stiffest_;
    });
  }

  Eigen::VectorXd answer(const Eigen::VectorXd& f) const override {
    Eigen::VectorXd rates(f.size());
    rates_of(answers_to(f), rates);
    return rates;
  }

  Result solve(const std::vector<PairStiffness>& h, const Eigen::VectorXd& f, const Eigen::VectorXd& start, double goal,
               int most_products) const override {
    const std::size_t count = fine_.block_count();
    if (!coarse_) coarse_ = single(fine_, stiffest_);
    const std::vector<PairStiffness> in_units = in_units_of_stiffness(h);
    Corrections<N> corrections(*coarse_, in_units, has_symmetric_blocks_);
    std::vector<typename Fine::Forces> forces(fine_.rows.size());
    Blocks x = answers_to(start);
    Blocks r(count);
    Result result;
    for (double before = std::numeric_limits<double>::infinity();;) {
      fine_.multiply(h, x, forces, [&](std::size_t e, const Block& y) {
        r[e] = on_block(e, f);
        r[e].add(-1, y);
      });
      ++result.products;
      const double left = fine_.greatest(r);
      result.converged = left <= goal;
      if (result.converged || !(left < before / 2) || result.products >= most_products) break;
      before = left;
      // Residual and correction are scaled to unit size, within the range of single precision.
      const double unit = left * std::sqrt(stiffest_);
      typename PairOperator<N, float>::Blocks scaled(count);
      for_each_entry(count, [&](std::size_t e) { scaled[e].vector() = (r[e].vector() / unit).template cast<float>(); });
      auto correction =
          corrections.of(std::move(scaled), std::max(goal / left / 2, kSingle), most_products - result.products);
      result.products += correction.products;
      for_each_entry(count, [&](std::size_t e) {
        x[e].vector() += unit / stiffest_ * correction.x[e].vector().template cast<double>();
      });
    }
    result.rates.resize(f.size());
    rates_of(x, result.rates);
    return result;
  }

 private:
  static Block padded(const ContactRow::Row& row, int size) {
    Block block;
    block.vector().head(size) = row.head(size).transpose();
    return block;
  }

  std::vector<PairStiffness> in_units_of_stiffness(std::vector<PairStiffness> h) const {
    for (PairStiffness& of : h) of = {of.nn / stiffest_, of.tn / stiffest_, of.tt / stiffest_};
    return h;
  }

  void rates_of(const Blocks& x, Eigen::VectorXd& all) const {
    for_each_entry(fine_.rows.size(), [&](std::size_t i) {
      const auto both = fine_.rates(i, x);
      all[static_cast<Eigen::Index>(2 * i)] = both.normal;
      all[static_cast<Eigen::Index>(2 * i + 1)] = both.tangential;
    });
  }

  // Returns Gᵀ f on one block.
  Block on_block(std::size_t block, const Eigen::VectorXd& f) const {
    Block all;
    fine_.sides.for_each(block, [&](std::size_t i, std::size_t s) {
      all.add(f[static_cast<Eigen::Index>(2 * i)], fine_.rows[i][s].normal);
      all.add(f[static_cast<Eigen::Index>(2 * i + 1)], fine_.rows[i][s].tangential);
    });
    return all;
  }

  // Returns A⁻¹ Gᵀ f, with a zero entry for fixed blocks.
  Blocks answers_to(const Eigen::VectorXd& f) const {
    Blocks x(fine_.block_count() + 1);
    for_each_entry(fine_.block_count(), [&](std::size_t e) { x[e] = fine_.flexibility[e] * on_block(e, f); });
    return x;
  }

  PairOperator<N, double> fine_;
  double stiffest_ = 0;                                   ///< greatest entry of A
  bool has_symmetric_blocks_ = true;                      ///< of A; false for rock with non-associated flow
  mutable std::optional<PairOperator<N, float>> coarse_;  ///< made for the first solution
};

}  // namespace

PairSystem::PairSystem(const ContactRows& rows, const BlockNumbers& blocks,
                       const Table<ElementIndex, UnknownBlock>& flexibility) {
  int largest = 0;
  for (int i = 0; i < blocks.count(); ++i) largest = std::max(largest, blocks.size(i));
  if (largest <= 3)
    kernel_ = std::make_unique<KernelOf<3>>(rows, blocks, flexibility);
  else
    kernel_ = std::make_unique<KernelOf<kMostBlockRows>>(rows, blocks, flexibility);
}

PairSystem::~PairSystem() = default;

PairSystem::Result PairSystem::solve(const std::vector<PairStiffness>& h, const Eigen::VectorXd& f,
                                     const Eigen::VectorXd& start, double goal, int most_products) const {
  return kernel_->solve(h, f, start, goal, most_products);
}

Eigen::VectorXd PairSystem::answer(const Eigen::VectorXd& f) const {
  return kernel_->answer(f);
}

}  // namespace keyblock
