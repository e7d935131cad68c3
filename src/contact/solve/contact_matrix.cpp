// Products row by row; the diagonal, and what covers couple, are made once.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solve/contact_matrix.hpp"

#include <utility>

#include "base/loop.hpp"

namespace keyblock {
namespace {

// Fewer blocks than these, or fewer pairs, are factorised faster than iterations get anywhere.
constexpr std::size_t kManyBlocks = 300;

ContactRow through(const ContactRow& row, const Table<ElementIndex, UnknownBlock>& blocks) {
  return {row.vertex_element, row.edge_element, row.of_vertex * blocks[row.vertex_element],
          row.of_edge * blocks[row.edge_element]};
}

// Of the blocks alone.
double product(const ContactRow& a, const ContactRow& b) {
  double sum = 0;
  if (a.vertex_element == b.vertex_element) sum += a.of_vertex.dot(b.of_vertex);
  if (a.vertex_element == b.edge_element) sum += a.of_vertex.dot(b.of_edge);
  if (a.edge_element == b.vertex_element) sum += a.of_edge.dot(b.of_vertex);
  if (a.edge_element == b.edge_element) sum += a.of_edge.dot(b.of_edge);
  return sum;
}

}  // namespace

CoverCoupling::CoverCoupling(const ContactRows& rows, const Flexibility& flexibility) {
  if (!flexibility.covers) return;
  places_.assign(rows.size(), -1);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].covers.empty()) continue;
    places_[i] = static_cast<Eigen::Index>(rows_.size());
    rows_.push_back(static_cast<Eigen::Index>(i));
  }
  const auto count = static_cast<Eigen::Index>(rows_.size());
  const auto row = [&](Eigen::Index i) -> const ContactRow& {
    return rows[static_cast<std::size_t>(rows_[static_cast<std::size_t>(i)])];
  };
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(flexibility.covers->size(), count);
  for (Eigen::Index i = 0; i < count; ++i)
    for (const CoverEntry& entry : row(i).covers)
      forces.col(i).segment<2>(2 * entry.function) += Eigen::Vector2d(entry.x, entry.y);
  // Row by row, what one unknown answers to all forces lies side by side.
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> answers =
      flexibility.covers->times(forces);
  matrix_.setZero(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    auto column = matrix_.col(i).head(i + 1);
    for (const CoverEntry& entry : row(i).covers)
      column += (entry.x * answers.row(2 * entry.function).head(i + 1) +
                 entry.y * answers.row(2 * entry.function + 1).head(i + 1))
                    .transpose();
  }
  matrix_.triangularView<Eigen::StrictlyLower>() = matrix_.transpose();
}

double CoverCoupling::entry(Eigen::Index i, Eigen::Index j) const {
  const Eigen::Index at = places_[static_cast<std::size_t>(i)];
  const Eigen::Index to = places_[static_cast<std::size_t>(j)];
  return at < 0 || to < 0 ? 0 : matrix_(at, to);
}

double CoverCoupling::rate(Eigen::Index i, const Eigen::VectorXd& forces) const {
  if (is_none() || places_[static_cast<std::size_t>(i)] < 0) return 0;
  const auto column = matrix_.col(places_[static_cast<std::size_t>(i)]);
  double sum = 0;
  for (std::size_t j = 0; j < rows_.size(); ++j) sum += column[static_cast<Eigen::Index>(j)] * forces[rows_[j]];
  return sum;
}

Eigen::VectorXd CoverCoupling::times(const Eigen::VectorXd& forces) const {
  Eigen::VectorXd own(matrix_.rows());
  for (std::size_t j = 0; j < rows_.size(); ++j) own[static_cast<Eigen::Index>(j)] = forces[rows_[j]];
  const Eigen::VectorXd answer = matrix_ * own;
  Eigen::VectorXd all = Eigen::VectorXd::Zero(forces.size());
  for (std::size_t j = 0; j < rows_.size(); ++j) all[rows_[j]] = answer[static_cast<Eigen::Index>(j)];
  return all;
}

ContactMatrix::ContactMatrix(ContactRows rows, Flexibility flexibility)
    : ContactMatrix(std::make_shared<const ContactRows>(std::move(rows)), std::move(flexibility)) {}

ContactMatrix::ContactMatrix(std::shared_ptr<const ContactRows> rows, Flexibility flexibility)
    : rows_(std::move(rows)),
      flexibility_(std::move(flexibility)),
      covers_(*rows_, flexibility_),
      diagonal_(diagonal_of(*rows_, flexibility_, covers_)),
      added_(Eigen::VectorXd::Zero(diagonal_.size())) {
  has_many_pairs_ = covers_.is_none() && flexibility_.blocks.size() >= kManyBlocks && rows_->size() >= 2 * kManyBlocks;
}

void ContactMatrix::add_to_diagonal(Eigen::Index row, double value) {
  diagonal_[row] += value;
  added_[row] += value;
}

const BlockNumbers& ContactMatrix::blocks() const {
  if (!blocks_) blocks_ = std::make_shared<BlockNumbers>(*rows_, flexibility_.blocks);
  return *blocks_;
}

const PairSystem* ContactMatrix::pairs() const {
  if (has_many_pairs_ && !pairs_) pairs_ = std::make_shared<PairSystem>(*rows_, blocks(), flexibility_.blocks);
  return pairs_.get();
}

Eigen::VectorXd ContactMatrix::operator*(const Eigen::VectorXd& forces) const {
  if (has_many_pairs_) return pairs()->answer(forces) + added_.cwiseProduct(forces);
  const UnknownsTable of_blocks = answer_of_blocks(*rows_, flexibility_.blocks, forces);
  Eigen::VectorXd all = added_.cwiseProduct(forces);
  for (Eigen::Index i = 0; i < all.size(); ++i)
    all[i] += row(i).of_vertex.dot(of_blocks[row(i).vertex_element].transpose()) +
              row(i).of_edge.dot(of_blocks[row(i).edge_element].transpose());
  return covers_.is_none() ? all : Eigen::VectorXd(all + covers_.times(forces));
}

Eigen::VectorXd diagonal_of(const ContactRows& rows, const Flexibility& flexibility, const CoverCoupling& covers) {
  Eigen::VectorXd diagonal(static_cast<Eigen::Index>(rows.size()));
  for_each_entry(rows.size(), [&](std::size_t i) {
    const auto n = static_cast<Eigen::Index>(i);
    diagonal[n] = product(through(rows[i], flexibility.blocks), rows[i]);
    if (!covers.is_none()) diagonal[n] += covers.entry(n, n);
  });
  return diagonal;
}

RowThrough::RowThrough(const ContactMatrix& w, Eigen::Index i)
    : w_(w), i_(i), through_(through(w.row(i), w.flexibility().blocks)) {}

double RowThrough::times(Eigen::Index j) const {
  const double of_covers = w_.covers().is_none() ? 0 : w_.covers().entry(i_, j);
  return product(through_, w_.row(j)) + of_covers;
}

}  // namespace keyblock
