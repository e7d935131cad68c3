// Computes the derivatives of the two kinds of map, and rows made of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/rows/point_motion.hpp"

#include <utility>

#include "base/loop.hpp"

namespace keyblock {
namespace {

void add(const PointMotion& motion, Point direction, std::vector<SharedEntry>& entries) {
  for (const CoverShare& share : motion.of_shared)
    entries.push_back({share.function, share.value * direction.x, share.value * direction.y});
}

}  // namespace

namespace {

// Most operators have this size, which the compiler then knows.
using OfWholeBlock = Eigen::Matrix<double, 2, kMostUnknowns>;

bool is_whole(const DisplacementOperator& of_block) {
  return of_block.cols() == kMostUnknowns;
}
Eigen::Map<const OfWholeBlock> whole(const DisplacementOperator& of_block) {
  return Eigen::Map<const OfWholeBlock>(of_block.data());
}

ContactRow::Row along(const Eigen::RowVector2d& direction, const DisplacementOperator& of_block) {
  if (is_whole(of_block)) return direction * whole(of_block);
  return direction * of_block;
}

}  // namespace

PointMotion between(PointMotion a, const PointMotion& b, double s) {
  if (is_whole(a.of_block) && is_whole(b.of_block))
    Eigen::Map<OfWholeBlock>(a.of_block.data()) = (1 - s) * whole(a.of_block) + s * whole(b.of_block);
  else
    a.of_block = (1 - s) * a.of_block + s * b.of_block;
  for (CoverShare& share : a.of_shared) share.value *= 1 - s;
  for (const CoverShare& share : b.of_shared) a.of_shared.push_back({share.function, s * share.value});
  return a;
}

PointMotions::PointMotions(const Model& model, const Reference& reference, const UnknownsTable& q)
    : model_(model), reference_(reference), q_(q), numbers_(model.elements.size(), -1) {}

PointMotions::Block PointMotions::made(ElementIndex e) const {
  const Basis& basis = *model_.elements[e].basis;
  const BlockMap map(basis, q_[e], reference_.centroids[e]);
  return {map, BlockJacobian(basis, q_[e], map)};
}

const PointMotions::Block& PointMotions::block(ElementIndex e) const {
  if (numbers_[e] < 0) {
    numbers_[e] = static_cast<int>(blocks_.size());
    blocks_.emplace_back(made(e));
  }
  return *blocks_[static_cast<std::size_t>(numbers_[e])];
}

void PointMotions::prepare(const std::vector<ElementIndex>& elements) {
  const std::size_t first = blocks_.size();
  std::vector<ElementIndex> fresh;
  for (ElementIndex e : elements) {
    if (numbers_[e] >= 0 || reference_.is_on_covers(e)) continue;
    numbers_[e] = static_cast<int>(first + fresh.size());
    fresh.push_back(e);
  }
  blocks_.resize(first + fresh.size());
  for_each_entry(fresh.size(), [&](std::size_t i) { blocks_[first + i] = made(fresh[i]); });
}

PointMotion PointMotions::of_vertex(VertexIndex v) const {
  const ElementIndex e = model_.vertices[v].element;
  if (reference_.is_on_covers(e)) {
    const auto shares = reference_.covers->of_vertex(v);
    return {DisplacementOperator(2, 0), {shares.begin(), shares.end()}};
  }
  return {block(e).jacobian.at(reference_.offsets[v])};
}

PointMotion PointMotions::of_point(ElementIndex e, Point start) const {
  if (reference_.is_on_covers(e)) return {DisplacementOperator(2, 0), reference_.covers->shares(e, start)};
  return {block(e).jacobian.at(start - reference_.centroids[e])};
}

PointMotion PointMotions::at_place(ElementIndex e, Point x) const {
  if (reference_.is_on_covers(e)) return of_point(e, reference_.covers->start_of(e, q_.shared, x));
  const Block& of = block(e);
  return {of.jacobian.at(of.map.offset(x))};
}

void add_force(const PointMotion& motion, ElementIndex e, Point force, UnknownsTable& loads) {
  const Eigen::Vector2d of_point(force.x, force.y);
  loads[e] += motion.of_block.transpose() * of_point;
  for (const CoverShare& share : motion.of_shared)
    loads.shared.segment<2>(2 * share.function) += share.value * of_point;
}

ContactRow row_between(ElementIndex a, const PointMotion& of_a, ElementIndex b, const PointMotion& of_b,
                       Point direction) {
  const Eigen::RowVector2d d(direction.x, direction.y);
  ContactRow row{a, b, along(d, of_a.of_block), along(-d, of_b.of_block)};
  add(of_a, direction, row.shared);
  add(of_b, -1 * direction, row.shared);
  return row;
}

ContactRow row_of(ElementIndex e, const PointMotion& motion, Point direction) {
  ContactRow::Row nothing = ContactRow::Row::Zero(motion.of_block.cols());
  ContactRow row{e, e, Eigen::RowVector2d(direction.x, direction.y) * motion.of_block, std::move(nothing)};
  add(motion, direction, row.shared);
  return row;
}

}  // namespace keyblock
