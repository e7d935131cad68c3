// Columns of one instant.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <limits>

#include "library/parts.hpp"

namespace keyblock::api {
namespace {

/// One row of `width` values for each of `rows`, as `put` gives them.
template <class T, class Rows, class Put>
Column<T> column(const Rows& rows, std::size_t width, const Put& put) {
  std::vector<T> values;
  values.reserve(width * rows.size());
  for (const auto& row : rows)
    for (const T value : put(row)) values.push_back(value);
  return {std::move(values), width};
}

using Two = std::array<double, 2>;

Two two(Point p) {
  return {p.x, p.y};
}

}  // namespace

inline namespace v1 {

int Frame::step() const {
  return data_->frame.step;
}

double Frame::time() const {
  return data_->frame.time;
}

double Frame::load_factor() const {
  return data_->frame.load_factor;
}

Column<int> Frame::number() const {
  std::vector<int> numbers;
  for (std::size_t i = 0; i < data_->frame.elements.size(); ++i) numbers.push_back(number_of(data_->frame, i) + 1);
  return {std::move(numbers), 1};
}

Column<int> Frame::material() const {
  return column<int>(data_->frame.elements, 1, [](const ElementFrame& e) { return std::array{e.material + 1}; });
}

Column<double> Frame::centroid() const {
  return column<double>(data_->frame.elements, 2, [](const ElementFrame& e) { return two(e.centroid); });
}

Column<double> Frame::displacement() const {
  return column<double>(data_->frame.elements, 2, [](const ElementFrame& e) { return two(e.displacement); });
}

Column<double> Frame::rotation() const {
  return column<double>(data_->frame.elements, 1, [](const ElementFrame& e) { return std::array{e.rotation}; });
}

Column<double> Frame::velocity() const {
  return column<double>(data_->frame.elements, 3, [](const ElementFrame& e) {
    return std::array{e.velocity.x, e.velocity.y, e.velocity.rotation};
  });
}

Column<double> Frame::stress() const {
  return column<double>(data_->frame.elements, 4, [](const ElementFrame& e) {
    return std::array{e.stress.xx, e.stress.yy, e.stress.xy, e.stress.zz};
  });
}

Column<double> Frame::area() const {
  return column<double>(data_->frame.elements, 1, [](const ElementFrame& e) { return std::array{e.area}; });
}

Column<double> Frame::vertices() const {
  std::vector<double> places;
  for (const ElementFrame& element : data_->frame.elements)
    for (const std::vector<Point>& loop : element.loops)
      for (const Point& corner : loop) places.insert(places.end(), {corner.x, corner.y});
  return {std::move(places), 2};
}

Column<int> Frame::loops() const {
  std::vector<int> rows;
  for (std::size_t i = 0; i < data_->frame.elements.size(); ++i)
    for (const std::vector<Point>& loop : data_->frame.elements[i].loops)
      rows.insert(rows.end(), {static_cast<int>(i), static_cast<int>(loop.size())});
  return {std::move(rows), 2};
}

Column<double> Frame::point() const {
  return column<double>(data_->frame.measured_points, 2, [](const PointFrame& p) { return two(p.position); });
}

Column<double> Frame::point_displacement() const {
  return column<double>(data_->frame.measured_points, 2, [](const PointFrame& p) { return two(p.displacement); });
}

Column<int> Frame::contact() const {
  return column<int>(data_->contacts, 3, [](const ContactFrame& c) {
    return std::array{c.element + 1, c.other + 1, static_cast<int>(c.condition)};
  });
}

Column<double> Frame::contact_point() const {
  return column<double>(data_->contacts, 2, [](const ContactFrame& c) { return two(c.position); });
}

Column<double> Frame::contact_normal() const {
  return column<double>(data_->contacts, 2, [](const ContactFrame& c) { return two(c.normal); });
}

Column<double> Frame::contact_force() const {
  return column<double>(data_->contacts, 2, [](const ContactFrame& c) { return Two{c.normal_force, c.shear_force}; });
}

Column<double> Frame::contact_gap() const {
  return column<double>(data_->contacts, 1, [](const ContactFrame& c) { return std::array{c.gap}; });
}

Column<int> Frame::tip() const {
  return column<int>(data_->frame.tips, 2, [](const TipState& t) { return std::array{t.crack + 1, t.at_end ? 1 : 0}; });
}

Column<double> Frame::tip_place() const {
  return column<double>(data_->frame.tips, 2, [](const TipState& t) { return two(t.at); });
}

Column<double> Frame::tip_factors() const {
  return column<double>(data_->frame.tips, 3, [](const TipState& t) {
    return std::array{t.mode_1, t.mode_2, t.energy_release};
  });
}

Column<double> Frame::crack_length() const {
  return column<double>(data_->frame.tips, 1, [](const TipState& t) { return std::array{t.length}; });
}

}  // namespace v1
}  // namespace keyblock::api
