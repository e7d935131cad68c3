// Assembles the system block by block, solves it by a block factorisation and refines the solution once.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/rows/joined_blocks.hpp"

#include "system/block_factor.hpp"

namespace keyblock {
namespace {

using Row = ContactRow::Row;

class Joined {
 public:
  Joined(const Table<ElementIndex, UnknownBlock>& stiffness, const ContactRows& rows, const Eigen::VectorXd& compliance)
      : stiffness_(stiffness), rows_(rows), compliance_(compliance) {
    int row = 0;
    for (const UnknownBlock& block : stiffness) {
      numbers_.push_back(block.rows() > 0 ? static_cast<int>(sizes_.size()) : -1);
      if (block.rows() == 0) continue;
      sizes_.push_back(static_cast<int>(block.rows()));
      first_rows_.push_back(row);
      row += sizes_.back();
    }
    first_rows_.push_back(row);
  }

  bool factorise() {
    BlockPattern::Pairs coupled;
    for (std::size_t i = 0; i < rows_.size(); i += 2) {
      const int a = numbers_[rows_[i].vertex_element];
      const int b = numbers_[rows_[i].edge_element];
      if (a >= 0 && b >= 0 && a != b) coupled.emplace_back(std::min(a, b), std::max(a, b));
    }
    factor_ = std::make_unique<BlockFactor>(std::make_shared<BlockPattern>(static_cast<int>(sizes_.size()), coupled),
                                            sizes_, MatrixShape::symmetric);
    for (ElementIndex e : indices(stiffness_))
      if (numbers_[e] >= 0) factor_->add(numbers_[e], numbers_[e], stiffness_[e]);
    for (std::size_t i = 0; i < rows_.size(); ++i) add_spring(i);
    return factor_->factorise();
  }

  Eigen::VectorXd solve(Eigen::VectorXd right) const {
    factor_->solve({right.data(), static_cast<std::size_t>(right.size())});
    return right;
  }

  // Converts all entries of a table into one vector, block after block, and back.
  Eigen::VectorXd packed(const UnknownsTable& table) const {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(first_rows_.back());
    for (ElementIndex e : indices(table))
      if (numbers_[e] >= 0) segment(all, e) = table[e];
    return all;
  }
  UnknownsTable unpacked(const Eigen::VectorXd& all, UnknownsTable shape) const {
    for (ElementIndex e : indices(shape))
      if (numbers_[e] >= 0) shape[e] = all.segment(first_rows_[at(e)], sizes_[at(e)]);
    return shape;
  }

  // Returns K x.
  Eigen::VectorXd times(const UnknownsTable& x) const {
    Eigen::VectorXd product = Eigen::VectorXd::Zero(first_rows_.back());
    for (ElementIndex e : indices(stiffness_))
      if (numbers_[e] >= 0) segment(product, e) = stiffness_[e] * x[e];
    return product - spread(rates(rows_, x));
  }

  // Returns −Gᵀ C⁻¹ y.
  Eigen::VectorXd spread(const Eigen::VectorXd& y) const {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(first_rows_.back());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const double force = -y[static_cast<Eigen::Index>(i)] / compliance_[static_cast<Eigen::Index>(i)];
      for (const auto& [e, row] : sides(rows_[i])) segment(all, e) += force * row->transpose();
    }
    return all;
  }

 private:
  struct Side {
    ElementIndex element;
    const Row* row;
  };
  std::vector<Side> sides(const ContactRow& row) const {
    std::vector<Side> all;
    if (numbers_[row.vertex_element] >= 0 && row.of_vertex.size() > 0)
      all.push_back({row.vertex_element, &row.of_vertex});
    if (numbers_[row.edge_element] >= 0 && row.of_edge.size() > 0) all.push_back({row.edge_element, &row.of_edge});
    return all;
  }
  void add_spring(std::size_t i) {
    const double stiffness = 1 / compliance_[static_cast<Eigen::Index>(i)];
    const std::vector<Side> both = sides(rows_[i]);
    for (std::size_t a = 0; a < both.size(); ++a)
      for (std::size_t b = a; b < both.size(); ++b)
        factor_->add(numbers_[both[a].element], numbers_[both[b].element],
                     stiffness * both[a].row->transpose() * *both[b].row);
  }
  std::size_t at(ElementIndex e) const { return static_cast<std::size_t>(numbers_[e]); }
  Eigen::VectorBlock<Eigen::VectorXd> segment(Eigen::VectorXd& all, ElementIndex e) const {
    return all.segment(first_rows_[at(e)], sizes_[at(e)]);
  }

  const Table<ElementIndex, UnknownBlock>& stiffness_;
  const ContactRows& rows_;
  const Eigen::VectorXd& compliance_;
  Table<ElementIndex, int> numbers_;  ///< −1 for an element without unknowns
  std::vector<int> sizes_;
  std::vector<int> first_rows_;
  std::unique_ptr<BlockFactor> factor_;
};

}  // namespace

std::optional<UnknownsTable> displacements_of_joined(const Table<ElementIndex, UnknownBlock>& stiffness,
                                                     const ContactRows& rows, const Eigen::VectorXd& compliance,
                                                     const Eigen::VectorXd& gaps, const UnknownsTable& loads) {
  Joined joined(stiffness, rows, compliance);
  if (!joined.factorise()) return std::nullopt;
  const Eigen::VectorXd right = joined.packed(loads) + joined.spread(gaps);
  const Eigen::VectorXd first = joined.solve(right);
  const UnknownsTable x = joined.unpacked(first, loads);
  return joined.unpacked(first + joined.solve(right - joined.times(x)), loads);
}

}  // namespace keyblock
