// Looks for an element at its unchanged index first, then everywhere.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/frame.hpp"

namespace keyblock {

int number_of(const Frame& frame, std::size_t index) {
  const int number = frame.elements[index].number;
  return number < 0 ? static_cast<int>(index) : number;
}

int origin_of(const Frame& frame, std::size_t index) {
  const int origin = frame.elements[index].origin;
  return origin < 0 ? number_of(frame, index) : origin;
}

const ElementFrame* element_of(const Frame& frame, int number) {
  const auto likely = static_cast<std::size_t>(number);
  if (likely < frame.elements.size() && number_of(frame, likely) == number) return &frame.elements[likely];
  for (std::size_t i = 0; i < frame.elements.size(); ++i)
    if (number_of(frame, i) == number) return &frame.elements[i];
  return nullptr;
}

ElementsByNumber::ElementsByNumber(const Frame& frame) {
  for (std::size_t i = 0; i < frame.elements.size(); ++i) {
    const auto number = static_cast<std::size_t>(number_of(frame, i));
    if (number >= elements_.size()) elements_.resize(number + 1, nullptr);
    elements_[number] = &frame.elements[i];
  }
}

const ElementFrame* ElementsByNumber::find(int number) const {
  const auto index = static_cast<std::size_t>(number);
  return number >= 0 && index < elements_.size() ? elements_[index] : nullptr;
}

const PointFrame* measured_point_of(const Frame& frame, int number) {
  for (std::size_t i = 0; i < frame.measured_points.size(); ++i) {
    const PointFrame& point = frame.measured_points[i];
    if ((point.number < 0 ? static_cast<int>(i) : point.number) == number) return &point;
  }
  return nullptr;
}

}  // namespace keyblock
