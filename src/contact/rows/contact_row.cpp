// Products with the rows, block by block.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/rows/contact_row.hpp"

#include "base/loop.hpp"

namespace keyblock {

Eigen::VectorXd rates(const ContactRows& rows, const UnknownsTable& x) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(rows.size()));
  for_each_entry(rows.size(), [&](std::size_t i) {
    const ContactRow& row = rows[i];
    result[static_cast<Eigen::Index>(i)] = row.of_vertex.dot(x[row.vertex_element].transpose()) +
                                           row.of_edge.dot(x[row.edge_element].transpose()) + row.of_covers(x.covers);
  });
  return result;
}

double ContactRow::of_covers(const Eigen::VectorXd& x) const {
  double sum = 0;
  for (const CoverEntry& entry : covers) sum += entry.x * x[2 * entry.function] + entry.y * x[2 * entry.function + 1];
  return sum;
}

void ContactRow::add_covers(double force, Eigen::VectorXd& sum) const {
  for (const CoverEntry& entry : covers)
    sum.segment<2>(2 * entry.function) += force * Eigen::Vector2d(entry.x, entry.y);
}

UnknownsTable answer_of_blocks(const ContactRows& rows, const Table<ElementIndex, UnknownBlock>& blocks,
                               const Eigen::VectorXd& forces) {
  UnknownsTable sum;
  for (ElementIndex e : indices(blocks)) sum.push_back(Unknowns::Zero(blocks[e].rows()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double f = forces[static_cast<Eigen::Index>(i)];
    if (f == 0) continue;  // open
    sum[rows[i].vertex_element] += f * rows[i].of_vertex.transpose();
    sum[rows[i].edge_element] += f * rows[i].of_edge.transpose();
  }
  for (ElementIndex e : indices(blocks)) sum[e] = blocks[e] * sum[e];
  return sum;
}

UnknownsTable answer(const ContactRows& rows, const Flexibility& flexibility, const Eigen::VectorXd& forces) {
  UnknownsTable sum = answer_of_blocks(rows, flexibility.blocks, forces);
  if (!flexibility.covers) return sum;
  sum.covers = Eigen::VectorXd::Zero(flexibility.covers->size());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].add_covers(forces[static_cast<Eigen::Index>(i)], sum.covers);
  sum.covers = flexibility.covers->times(sum.covers);
  return sum;
}

}  // namespace keyblock
