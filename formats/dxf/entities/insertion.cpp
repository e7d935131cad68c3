// Reads the groups of INSERT.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/entities/insertion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock::formats {

DxfInsertion::DxfInsertion(const DxfRecordValues& values, const DxfRecord& record, const DxfDefinition& definition)
    : base(definition.base),
      at(values.point(record, 10, "x", "y")),
      x(values.real_or(1, record, 41, "the scale in x")),
      y(values.real_or(1, record, 42, "the scale in y")),
      z(values.real_or(1, record, 43, "the scale in z")),
      height(values.real_or(0, record, 30, "z") - z * definition.base_height),
      array{values.real_or(0, record, 44, "the distance of columns"),
            values.real_or(0, record, 45, "the distance of rows")},
      columns(std::max(1, values.integer_or(1, record, 70, "the count"))),
      rows(std::max(1, values.integer_or(1, record, 71, "the count"))) {
  const double angle = std::numbers::pi / 180 * std::fmod(values.real_or(0, record, 50, "the angle"), 360);
  cosine = std::cos(angle);
  sine = std::sin(angle);
}

}  // namespace keyblock::formats
