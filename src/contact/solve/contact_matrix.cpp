// Computes products row by row. The diagonal and the coupling by shared unknowns are made once.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solve/contact_matrix.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/loop.hpp"

namespace keyblock {
namespace {

// With fewer blocks or pairs a factorisation is faster than iterations.
constexpr std::size_t kManyBlocks = 300;

ContactRow through(const ContactRow& row, const Table<ElementIndex, UnknownBlock>& blocks) {
  return {row.vertex_element, row.edge_element, product(row.of_vertex, blocks[row.vertex_element]),
          product(row.of_edge, blocks[row.edge_element])};
}

// Right-hand sides per solve with the factorisation of shared unknowns.
constexpr std::size_t kSolvedAtOnce = 64;

/// Row-major: the responses of one unknown to all forces are contiguous.
using AnswersByUnknown = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Returns one column per row of G: the response to a unit force along it.
AnswersByUnknown answers_to(const ContactRows& rows, std::span<const Eigen::Index> some,
                            const SharedFlexibility& shared) {
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(shared.size(), static_cast<Eigen::Index>(some.size()));
  for (std::size_t k = 0; k < some.size(); ++k)
    for (const SharedEntry& entry : rows[static_cast<std::size_t>(some[k])].shared)
      forces.col(static_cast<Eigen::Index>(k)).segment<2>(2 * entry.function) += Eigen::Vector2d(entry.x, entry.y);
  return shared.times(forces);
}

/// Appends the entries of a row with the first `count` of `some`.
void add_coupled(const ContactRow& row, std::ptrdiff_t count, std::span<const Eigen::Index> some,
                 const AnswersByUnknown& answers, std::vector<SharedCoupling::Entry>& entries) {
  Eigen::RowVectorXd sums = Eigen::RowVectorXd::Zero(count);
  for (const SharedEntry& entry : row.shared)
    sums += entry.x * answers.row(2 * entry.function).head(count) +
            entry.y * answers.row(2 * entry.function + 1).head(count);
  for (Eigen::Index k = 0; k < count; ++k)
    if (sums[k] != 0) entries.push_back({some[static_cast<std::size_t>(k)], sums[k]});
}

// Returns the product by blocks alone.
double product_of(const ContactRow& a, const ContactRow& b) {
  double sum = 0;
  if (a.vertex_element == b.vertex_element) sum += a.of_vertex.dot(b.of_vertex);
  if (a.vertex_element == b.edge_element) sum += a.of_vertex.dot(b.of_edge);
  if (a.edge_element == b.vertex_element) sum += a.of_edge.dot(b.of_vertex);
  if (a.edge_element == b.edge_element) sum += a.of_edge.dot(b.of_edge);
  return sum;
}

}  // namespace

// A thousand contacting crack faces need tens of megabytes, so that entries are written once, in their final place.
CoupledRows::CoupledRows(const std::vector<std::vector<Entry>>& lower, bool mirrors) : first_(lower.size() + 1, 0) {
  const auto is_mirrored = [&](const Entry& entry, std::size_t i) {
    return mirrors && entry.row != static_cast<Eigen::Index>(i);
  };
  for (std::size_t i = 0; i < lower.size(); ++i) {
    first_[i + 1] += lower[i].size();
    for (const Entry& entry : lower[i])
      if (is_mirrored(entry, i)) ++first_[static_cast<std::size_t>(entry.row) + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  entries_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  // A row has its own entries up to the diagonal; later rows supply those beyond it.
  for (std::size_t i = 0; i < lower.size(); ++i)
    for (const Entry& entry : lower[i]) {
      entries_[next[i]++] = entry;
      if (is_mirrored(entry, i))
        entries_[next[static_cast<std::size_t>(entry.row)]++] = {static_cast<Eigen::Index>(i), entry.value};
    }
}

void CoupledRows::add(std::span<const Entry> entries) {
  if (first_.empty()) first_.push_back(0);
  entries_.insert(entries_.end(), entries.begin(), entries.end());
  first_.push_back(entries_.size());
}

SharedCoupling::SharedCoupling(const ContactRows& rows, const Flexibility& flexibility) {
  if (!flexibility.shared) return;
  std::vector<Eigen::Index> coupled;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (!rows[i].shared.empty()) coupled.push_back(static_cast<Eigen::Index>(i));
  const bool is_symmetric = flexibility.shared->is_symmetric();
  std::vector<std::vector<Entry>> lower(rows.size());  // all entries if unsymmetric
  for (std::size_t begin = 0; begin < coupled.size(); begin += kSolvedAtOnce) {
    const std::span<const Eigen::Index> some =
        std::span(coupled).subspan(begin, std::min(kSolvedAtOnce, coupled.size() - begin));
    const AnswersByUnknown answers = answers_to(rows, some, *flexibility.shared);
    for (const Eigen::Index i : std::span(coupled).subspan(is_symmetric ? begin : 0)) {
      const auto count = is_symmetric ? std::ranges::upper_bound(some, i) - some.begin() : std::ssize(some);
      add_coupled(rows[static_cast<std::size_t>(i)], count, some, answers, lower[static_cast<std::size_t>(i)]);
    }
  }
  rows_ = CoupledRows(lower, is_symmetric);
}

std::span<const SharedCoupling::Entry> SharedCoupling::entries(Eigen::Index i) const {
  return is_none() ? std::span<const Entry>() : rows_.of(i);
}

double SharedCoupling::entry(Eigen::Index i, Eigen::Index j) const {
  const std::span<const Entry> row = entries(i);
  const auto found = std::ranges::lower_bound(row, j, {}, &Entry::row);
  return found == row.end() || found->row != j ? 0 : found->value;
}

double SharedCoupling::rate(Eigen::Index i, const Eigen::VectorXd& forces) const {
  double sum = 0;
  for (const Entry& entry : entries(i)) sum += entry.value * forces[entry.row];
  return sum;
}

Eigen::VectorXd SharedCoupling::times(const Eigen::VectorXd& forces) const {
  Eigen::VectorXd all(forces.size());
  for (Eigen::Index i = 0; i < all.size(); ++i) all[i] = rate(i, forces);
  return all;
}

ContactMatrix::ContactMatrix(ContactRows rows, Flexibility flexibility)
    : ContactMatrix(std::make_shared<const ContactRows>(std::move(rows)), std::move(flexibility)) {}

ContactMatrix::ContactMatrix(std::shared_ptr<const ContactRows> rows, Flexibility flexibility,
                             std::shared_ptr<FactorStore> store)
    : rows_(std::move(rows)),
      flexibility_(std::move(flexibility)),
      shared_(*rows_, flexibility_),
      diagonal_(diagonal_of(*rows_, flexibility_, shared_)),
      added_(Eigen::VectorXd::Zero(diagonal_.size())),
      store_(std::move(store)) {
  has_many_pairs_ = shared_.is_none() && flexibility_.blocks.size() >= kManyBlocks && rows_->size() >= 2 * kManyBlocks;
}

void ContactMatrix::add_to_diagonal(Eigen::Index row, double value) {
  diagonal_[row] += value;
  added_[row] += value;
}

const BlockNumbers& ContactMatrix::blocks() const {
  if (!blocks_) blocks_ = std::make_shared<BlockNumbers>(*rows_, flexibility_, store_);
  return *blocks_;
}

const CoupledRows& ContactMatrix::coupled() const {
  if (coupled_) return *coupled_;
  Table<ElementIndex, std::vector<Eigen::Index>> rows_on(flexibility_.blocks.size());
  for (Eigen::Index i = 0; i < rows(); ++i) {
    if (row(i).of_vertex.size() > 0) rows_on[row(i).vertex_element].push_back(i);
    if (row(i).of_edge.size() > 0 && row(i).edge_element != row(i).vertex_element)
      rows_on[row(i).edge_element].push_back(i);
  }
  auto all = std::make_shared<CoupledRows>();
  std::vector<Eigen::Index> others;
  std::vector<CoupledRows::Entry> entries;
  for (Eigen::Index i = 0; i < rows(); ++i) {
    // A row without entries of blocks is coupled only through shared functions.
    const bool is_shared_alone = row(i).of_vertex.size() == 0 && row(i).of_edge.size() == 0;
    if (is_shared_alone && !shared_.is_none() && shared_.entry(i, i) != 0) {
      all->add(shared_.entries(i));
      continue;
    }
    others.assign(1, i);
    for (const CoupledRows::Entry& entry : shared_.entries(i)) others.push_back(entry.row);
    for (const ElementIndex e : {row(i).vertex_element, row(i).edge_element})
      others.insert(others.end(), rows_on[e].begin(), rows_on[e].end());
    std::ranges::sort(others);
    others.erase(std::ranges::unique(others).begin(), others.end());
    const RowThrough through(*this, i);
    entries.clear();
    for (const Eigen::Index j : others) entries.push_back({j, through.times(j)});
    all->add(entries);
  }
  coupled_ = std::move(all);
  return *coupled_;
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
    all[i] += product(row(i).of_vertex, of_blocks[row(i).vertex_element]) +
              product(row(i).of_edge, of_blocks[row(i).edge_element]);
  return shared_.is_none() ? all : Eigen::VectorXd(all + shared_.times(forces));
}

Eigen::VectorXd diagonal_of(const ContactRows& rows, const Flexibility& flexibility, const SharedCoupling& shared) {
  Eigen::VectorXd diagonal(static_cast<Eigen::Index>(rows.size()));
  for_each_entry(rows.size(), [&](std::size_t i) {
    const auto n = static_cast<Eigen::Index>(i);
    diagonal[n] = product_of(through(rows[i], flexibility.blocks), rows[i]);
    if (!shared.is_none()) diagonal[n] += shared.entry(n, n);
  });
  return diagonal;
}

RowThrough::RowThrough(const ContactMatrix& w, Eigen::Index i)
    : w_(w), i_(i), through_(through(w.row(i), w.flexibility().blocks)) {}

double RowThrough::times(Eigen::Index j) const {
  const double of_shared = w_.shared().is_none() ? 0 : w_.shared().entry(i_, j);
  return product_of(through_, w_.row(j)) + of_shared;
}

}  // namespace keyblock
