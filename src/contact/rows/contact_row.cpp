// Computes products with the rows, block by block.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/rows/contact_row.hpp"

#include <utility>

#include "base/loop.hpp"

namespace keyblock {
namespace {

class ScaledFlexibility final : public SharedFlexibility {
 public:
  ScaledFlexibility(std::shared_ptr<const SharedFlexibility> of, double by) : of_(std::move(of)), by_(by) {}
  Eigen::Index size() const override { return of_->size(); }
  bool is_symmetric() const override { return of_->is_symmetric(); }
  Eigen::MatrixXd times(const Eigen::MatrixXd& forces) const override { return by_ * of_->times(forces); }

 private:
  std::shared_ptr<const SharedFlexibility> of_;
  double by_;
};

}  // namespace

std::shared_ptr<const SharedFlexibility> scaled(std::shared_ptr<const SharedFlexibility> flexibility, double factor) {
  if (!flexibility) return nullptr;
  return std::make_shared<ScaledFlexibility>(std::move(flexibility), factor);
}

Eigen::VectorXd rates(const ContactRows& rows, const UnknownsTable& x) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(rows.size()));
  for_each_entry(rows.size(), [&](std::size_t i) {
    const ContactRow& row = rows[i];
    result[static_cast<Eigen::Index>(i)] = product(row.of_vertex, x[row.vertex_element]) +
                                           product(row.of_edge, x[row.edge_element]) + row.of_shared(x.shared);
  });
  return result;
}

double ContactRow::of_shared(const Eigen::VectorXd& x) const {
  double sum = 0;
  for (const SharedEntry& entry : shared) sum += entry.x * x[2 * entry.function] + entry.y * x[2 * entry.function + 1];
  return sum;
}

void ContactRow::add_to(UnknownsTable& sum, double force) const {
  add_scaled(force, of_vertex, sum[vertex_element]);
  add_scaled(force, of_edge, sum[edge_element]);
  add_shared(force, sum.shared);
}

void ContactRow::add_shared(double force, Eigen::VectorXd& sum) const {
  for (const SharedEntry& entry : shared)
    sum.segment<2>(2 * entry.function) += force * Eigen::Vector2d(entry.x, entry.y);
}

UnknownsTable answer_of_blocks(const ContactRows& rows, const Table<ElementIndex, UnknownBlock>& blocks,
                               const Eigen::VectorXd& forces) {
  UnknownsTable sum;
  sum.reserve(blocks.size());
  for (ElementIndex e : indices(blocks)) sum.push_back(Unknowns::Zero(blocks[e].rows()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double f = forces[static_cast<Eigen::Index>(i)];
    if (f == 0) continue;  // open
    add_scaled(f, rows[i].of_vertex, sum[rows[i].vertex_element]);
    add_scaled(f, rows[i].of_edge, sum[rows[i].edge_element]);
  }
  for (ElementIndex e : indices(blocks)) sum[e] = product(blocks[e], sum[e]);
  return sum;
}

UnknownsTable answer(const ContactRows& rows, const Flexibility& flexibility, const Eigen::VectorXd& forces) {
  UnknownsTable sum = answer_of_blocks(rows, flexibility.blocks, forces);
  if (!flexibility.shared) return sum;
  sum.shared = Eigen::VectorXd::Zero(flexibility.shared->size());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].add_shared(forces[static_cast<Eigen::Index>(i)], sum.shared);
  sum.shared = flexibility.shared->times(sum.shared);
  return sum;
}

}  // namespace keyblock
