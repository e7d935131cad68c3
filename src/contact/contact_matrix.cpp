// Products row by row; the diagonal is made once.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/contact_matrix.hpp"

#include <utility>

namespace keyblock {
ContactMatrix::ContactMatrix(ContactRows rows, Table<ElementIndex, UnknownBlock> flexibility)
    : rows_(std::move(rows)),
      flexibility_(std::move(flexibility)),
      diagonal_(static_cast<Eigen::Index>(rows_.size())),
      added_(Eigen::VectorXd::Zero(diagonal_.size())) {
  for (Eigen::Index i = 0; i < diagonal_.size(); ++i) diagonal_[i] = RowThrough(*this, i).times(row(i));
}

void ContactMatrix::add_to_diagonal(Eigen::Index row, double value) {
  diagonal_[row] += value;
  added_[row] += value;
}

Eigen::VectorXd ContactMatrix::operator*(const Eigen::VectorXd& forces) const {
  return rates(rows_, answer(rows_, flexibility_, forces)) + added_.cwiseProduct(forces);
}

RowThrough::RowThrough(const ContactMatrix& w, Eigen::Index row) : through_(w.row(row)) {
  through_.of_vertex *= w.flexibility()[through_.vertex_element];
  through_.of_edge *= w.flexibility()[through_.edge_element];
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
