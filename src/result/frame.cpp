// Looks where the element would be if nothing had changed, then everywhere.
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

}  // namespace keyblock
