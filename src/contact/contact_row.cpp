// Products with the rows, block by block.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/contact_row.hpp"

namespace keyblock {

Eigen::VectorXd rates(const ContactRows& rows, const UnknownsTable& x) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ContactRow& row = rows[i];
    result[static_cast<Eigen::Index>(i)] =
        row.of_vertex.dot(x[row.vertex_element].transpose()) + row.of_edge.dot(x[row.edge_element].transpose());
  }
  return result;
}

UnknownsTable answer(const ContactRows& rows, const Table<ElementIndex, UnknownBlock>& blocks,
                     const Eigen::VectorXd& forces) {
  UnknownsTable sum;
  for (ElementIndex e : indices(blocks)) sum.push_back(Unknowns::Zero(blocks[e].rows()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double f = forces[static_cast<Eigen::Index>(i)];
    sum[rows[i].vertex_element] += f * rows[i].of_vertex.transpose();
    sum[rows[i].edge_element] += f * rows[i].of_edge.transpose();
  }
  for (ElementIndex e : indices(blocks)) sum[e] = blocks[e] * sum[e];
  return sum;
}

}  // namespace keyblock
