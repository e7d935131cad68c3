// Applies contact springs and inertia to the unknowns of blocks, in rows of one size and one precision.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "base/loop.hpp"
#include "base/worse.hpp"
#include "contact/solve/pair_system.hpp"
#include "system/fours.hpp"

namespace keyblock {

/// Pairs that act on each block, each with the side concerned, in the order of the pairs.
class SidesOfBlocks {
 public:
  SidesOfBlocks() = default;
  SidesOfBlocks(const std::vector<std::array<int, 2>>& blocks, std::size_t count) : begins_(count + 1, 0) {
    for (const auto& both : blocks)
      for (const int block : both)
        if (static_cast<std::size_t>(block) < count) ++begins_[static_cast<std::size_t>(block) + 1];
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    sides_.resize(begins_.back());
    std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
    for (std::size_t i = 0; i < blocks.size(); ++i)
      for (const std::size_t s : {0, 1})
        if (const std::size_t block = static_cast<std::size_t>(blocks[i][s]); block < count)
          sides_[next[block]++] = {i, s};
  }

  template <class Work>
  void for_each(std::size_t block, const Work& work) const {
    for (std::size_t k = begins_[block]; k < begins_[block + 1]; ++k) work(sides_[k].first, sides_[k].second);
  }

 private:
  std::vector<std::size_t> begins_;
  std::vector<std::pair<std::size_t, std::size_t>> sides_;
};

/// G and A in one precision. All fixed blocks share one number, after all others.
template <int N, class Real>
struct PairOperator {
  using Block = PaddedVector<N, Real>;
  using Blocks = std::vector<Block>;
  struct Rows {
    Block normal;
    Block tangential;
  };
  struct Forces {
    Real normal = 0;
    Real tangential = 0;
  };

  std::vector<std::array<int, 2>> blocks;    ///< per pair
  std::vector<std::array<Rows, 2>> rows;     ///< per pair
  std::vector<Padded<N, Real>> stiffness;    ///< A
  std::vector<Padded<N, Real>> flexibility;  ///< A⁻¹
  SidesOfBlocks sides;

  std::size_t block_count() const { return stiffness.size(); }

  Forces rates(std::size_t pair, const Blocks& x) const {
    const auto& [of_vertex, of_edge] = rows[pair];
    const Block& a = x[static_cast<std::size_t>(blocks[pair][0])];
    const Block& b = x[static_cast<std::size_t>(blocks[pair][1])];
    return {sum(products(of_vertex.normal, a) + products(of_edge.normal, b)),
            sum(products(of_vertex.tangential, a) + products(of_edge.tangential, b))};
  }

  /// Computes A x + Gᵀ H G x, block by block; `forces` is workspace for all pairs.
  template <class Take>
  void multiply(const std::vector<PairStiffness>& h, const Blocks& x, std::vector<Forces>& forces,
                const Take& take) const {
    for_each_entry(rows.size(), [&](std::size_t i) {
      if (h[i].is_none()) return;
      const Forces rate = rates(i, x);
      forces[i] = {static_cast<Real>(h[i].nn) * rate.normal,
                   static_cast<Real>(h[i].tn) * rate.normal + static_cast<Real>(h[i].tt) * rate.tangential};
    });
    for_each_entry(block_count(), [&](std::size_t e) {
      Block y = stiffness[e] * x[e];
      sides.for_each(e, [&](std::size_t i, std::size_t s) {
        if (h[i].is_none()) return;
        y.add(forces[i].normal, rows[i][s].normal);
        y.add(forces[i].tangential, rows[i][s].tangential);
      });
      take(e, y);
    });
  }

  /// Returns the greatest √(rᵀ A⁻¹ r) of a block.
  double greatest(const Blocks& r) const {
    std::vector<double> parts(range_count(block_count()));
    for_ranges(block_count(), [&](std::size_t range, std::size_t begin, std::size_t end) {
      for (std::size_t e = begin; e < end; ++e)
        parts[range] = worse(parts[range], static_cast<double>(dot(r[e], flexibility[e] * r[e])));
    });
    double all = 0;
    for (const double part : parts) all = worse(all, part);
    return std::sqrt(all);
  }
};

/// Returns the same in single precision, with `stiffness` as unit of A: entries then stay within range.
template <int N>
PairOperator<N, float> single(const PairOperator<N, double>& of, double stiffness) {
  PairOperator<N, float> made;
  made.blocks = of.blocks;
  made.sides = of.sides;
  made.rows.resize(of.rows.size());
  made.stiffness.resize(of.stiffness.size());
  made.flexibility.resize(of.flexibility.size());
  for_each_entry(of.rows.size(), [&](std::size_t i) {
    for (const std::size_t s : {0, 1}) {
      made.rows[i][s].normal.vector() = of.rows[i][s].normal.vector().template cast<float>();
      made.rows[i][s].tangential.vector() = of.rows[i][s].tangential.vector().template cast<float>();
    }
  });
  for_each_entry(of.stiffness.size(), [&](std::size_t e) {
    made.stiffness[e].square() = (of.stiffness[e].square() / stiffness).template cast<float>();
    made.flexibility[e].square() = (of.flexibility[e].square() * stiffness).template cast<float>();
  });
  return made;
}

}  // namespace keyblock
