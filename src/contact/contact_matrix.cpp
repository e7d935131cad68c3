// Products row by row; the diagonal is made once.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/contact_matrix.hpp"

#include <utility>

namespace keyblock {
ContactMatrix::ContactMatrix(ContactRows rows, Table<ElementIndex, UnknownBlock> flexibility)
    : rows_(std::move(rows)),
      flexibility_(std::move(flexibility)),
      diagonal_(diagonal_of(rows_, flexibility_)),
      added_(Eigen::VectorXd::Zero(diagonal_.size())) {}

void ContactMatrix::add_to_diagonal(Eigen::Index row, double value) {
  diagonal_[row] += value;
  added_[row] += value;
}

Eigen::VectorXd ContactMatrix::operator*(const Eigen::VectorXd& forces) const {
  return rates(rows_, answer(rows_, flexibility_, forces)) + added_.cwiseProduct(forces);
}

Eigen::VectorXd diagonal_of(const ContactRows& rows, const Table<ElementIndex, UnknownBlock>& flexibility) {
  Eigen::VectorXd diagonal(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    diagonal[static_cast<Eigen::Index>(i)] = RowThrough(rows[i], flexibility).times(rows[i]);
  return diagonal;
}

RowThrough::RowThrough(const ContactRow& row, const Table<ElementIndex, UnknownBlock>& flexibility) : through_(row) {
  through_.of_vertex *= flexibility[through_.vertex_element];
  through_.of_edge *= flexibility[through_.edge_element];
}

double RowThrough::times(const ContactRow& other) const {
  double sum = 0;
  if (through_.vertex_element == other.vertex_element) sum += through_.of_vertex.dot(other.of_vertex);
  if (through_.vertex_element == other.edge_element) sum += through_.of_vertex.dot(other.of_edge);
  if (through_.edge_element == other.vertex_element) sum += through_.of_edge.dot(other.of_vertex);
  if (through_.edge_element == other.edge_element) sum += through_.of_edge.dot(other.of_edge);
  return sum;
}

}  // namespace keyblock
