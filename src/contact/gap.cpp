// Rows from the points of a touch; products with them block by block.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/gap.hpp"

namespace keyblock {
namespace {

Point outward_normal(Point along) {
  return (1 / length(along)) * Point{along.y, -along.x};
}

Eigen::RowVector2d row_vector(Point p) {
  return {p.x, p.y};
}

class Rows {
 public:
  Rows(const Model& model, const Reference& reference, const UnknownsTable& q)
      : model_(model), reference_(reference), q_(q), vertices_(vertices_at(model, reference, q)) {}

  void add(const Touch& touch, ContactRows& rows) const {
    const ElementIndex a = model_.vertices[touch.vertex].element;
    const ElementIndex b = model_.vertices[touch.start].element;
    const Point along = vertices_[touch.end] - vertices_[touch.start];
    const Point from_start = vertices_[touch.vertex] - vertices_[touch.start];
    const double s = dot(from_start, along) / dot(along, along);
    const Point n = outward_normal(along);
    const Point t{-n.y, n.x};
    const DisplacementOperator at_vertex = at(touch.vertex);
    const DisplacementOperator at_foot = (1 - s) * at(touch.start) + s * at(touch.end);
    rows.push_back({a, b, row_vector(n) * at_vertex, -row_vector(n) * at_foot});
    rows.push_back({a, b, row_vector(t) * at_vertex, -row_vector(t) * opposite(b, vertices_[touch.vertex])});
  }

 private:
  DisplacementOperator at(VertexIndex v) const {
    const ElementIndex e = model_.vertices[v].element;
    return jacobian(*model_.elements[e].basis, q_[e], reference_.offsets[v]);
  }
  DisplacementOperator opposite(ElementIndex e, Point x) const {
    const Basis& basis = *model_.elements[e].basis;
    const Point centroid = reference_.centroids[e] + translation(basis, q_[e]);
    return jacobian(basis, q_[e], material_offset(basis, q_[e], x - centroid));
  }

  const Model& model_;
  const Reference& reference_;
  const UnknownsTable& q_;
  Table<VertexIndex, Point> vertices_;
};

// The part of row i on element e; empty if there is none.
const ContactRow::Row* part_on(const ContactRow& row, ElementIndex e) {
  if (row.vertex_element == e) return &row.of_vertex;
  return row.edge_element == e ? &row.of_edge : nullptr;
}

}  // namespace

double gap_of(const Touch& touch, const Table<VertexIndex, Point>& vertices) {
  const Point n = outward_normal(vertices[touch.end] - vertices[touch.start]);
  return dot(n, vertices[touch.vertex] - vertices[touch.start]);
}

ContactRows contact_rows(const Model& model, const Reference& reference, const UnknownsTable& q,
                         const Touches& touches) {
  ContactRows rows;
  if (touches.empty()) return rows;
  const Rows maker(model, reference, q);
  for (const Touch& touch : touches) maker.add(touch, rows);
  return rows;
}

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

Eigen::MatrixXd contact_matrix(const ContactRows& rows, const Table<ElementIndex, UnknownBlock>& blocks) {
  const auto count = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd w = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const ContactRow& row = rows[static_cast<std::size_t>(i)];
    const ContactRow::Row vertex_side = row.of_vertex * blocks[row.vertex_element];
    const ContactRow::Row edge_side = row.of_edge * blocks[row.edge_element];
    for (Eigen::Index j = 0; j <= i; ++j) {
      const ContactRow& other = rows[static_cast<std::size_t>(j)];
      if (const auto* part = part_on(other, row.vertex_element)) w(i, j) += vertex_side.dot(*part);
      if (const auto* part = part_on(other, row.edge_element)) w(i, j) += edge_side.dot(*part);
      w(j, i) = w(i, j);
    }
  }
  return w;
}

}  // namespace keyblock
