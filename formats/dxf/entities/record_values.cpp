// Reads values of records by group code; see record_values.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/entities/record_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace keyblock::formats {
namespace {

constexpr double kUpright = 1e-9;  // smaller tilts are rounding errors of drawing programs
constexpr std::string_view kApplication = "KEYBLOCK";

}  // namespace

double DxfRecordValues::real(const DxfRecord& record, int code, std::string_view name) const {
  const DxfGroup* group = record.find(code);
  if (group == nullptr)
    throw InputError(document_.place(record.head),
                     fmt::format("expected {} (group {}) of {}, found none", name, code, record.head.value));
  return document_.real(*group, name, record.head.value);
}

double DxfRecordValues::real_or(double absent, const DxfRecord& record, int code, std::string_view name) const {
  return record.find(code) == nullptr ? absent : real(record, code, name);
}

int DxfRecordValues::integer_or(int absent, const DxfRecord& record, int code, std::string_view name) const {
  const DxfGroup* group = record.find(code);
  return group == nullptr ? absent : document_.integer(*group, name, record.head.value);
}

std::string_view DxfRecordValues::layer_of(const DxfRecord& record) {
  const DxfGroup* group = record.find(8);
  return group == nullptr ? std::string_view("0") : group->value;
}

Point DxfRecordValues::point(const DxfRecord& record, int code, std::string_view x, std::string_view y) const {
  const double first = real(record, code, x);
  return {first, real(record, code + 10, y)};
}

double DxfRecordValues::radius(const DxfRecord& record) const {
  const double value = real(record, 40, "the radius");
  if (value > 0) return value;
  throw InputError(document_.place(*record.find(40)),
                   fmt::format("expected the radius (group 40, greater than 0) of {}, found {}", record.head.value,
                               in_quotes(record.find(40)->value)));
}

int DxfRecordValues::side_seen(const DxfRecord& record) const {
  if (record.find(230) == nullptr) return 1;
  const double x = real_or(0, record, 210, "x of the normal");
  const double y = real_or(0, record, 220, "y of the normal");
  if (std::abs(x) > kUpright || std::abs(y) > kUpright) return 0;
  return real(record, 230, "z of the normal") < 0 ? -1 : 1;
}

DxfShape DxfRecordValues::shape_of(const DxfRecord& record, std::vector<Point> points,
                                   std::initializer_list<int> heights) const {
  DxfShape shape{
      record.head.value, layer_of(record), document_.place(record.head), false, false, std::move(points), {}, {}};
  shape.colour = integer_or(0, record, 62, "the colour");
  if (heights.size() > 0) shape.low = shape.high = real_or(0, record, *heights.begin(), "z");
  add_heights(shape, record, heights);
  return shape;
}

void DxfRecordValues::add_heights(DxfShape& shape, const DxfRecord& record, std::initializer_list<int> heights) const {
  for (const int code : heights) {
    const double z = real_or(0, record, code, "z");
    shape.low = std::min(shape.low, z);
    shape.high = std::max(shape.high, z);
  }
}

char DxfRecordValues::mark_of(const DxfRecord& record) {
  constexpr std::string_view kMarks = "FLMH";
  const bool is_text = record.head.value == "MTEXT" || record.head.value == "TEXT";
  const DxfGroup* text = is_text ? record.find(1) : nullptr;
  const bool is_mark =
      text != nullptr && text->value.size() == 1 && kMarks.find(text->value.front()) != std::string_view::npos;
  return is_mark ? text->value.front() : '\0';
}

std::vector<DxfCorner> DxfRecordValues::light_corners(const DxfRecord& record) const {
  std::vector<DxfCorner> corners;
  corners.reserve(static_cast<std::size_t>(std::ranges::count(record.groups, 10, &DxfGroup::code)));
  bool y_is_missing = false;
  const auto complain = [&] {
    throw InputError(document_.place(record.head),
                     fmt::format("expected y (group 20) of vertex {} of LWPOLYLINE, found none", corners.size()));
  };
  for (const DxfGroup& group : record.groups) {
    if (group.code >= 1000) break;
    if (group.code == 10) {
      if (y_is_missing) complain();
      corners.push_back({{document_.real(group, "x of a vertex", "LWPOLYLINE"), 0}, 0, {}});
      y_is_missing = true;
    } else if (group.code == 20 && y_is_missing) {
      corners.back().position.y = document_.real(group, "y of a vertex", "LWPOLYLINE");
      y_is_missing = false;
    } else if (group.code == 42 && !corners.empty()) {
      corners.back().bulge = document_.real(group, "the bulge", "LWPOLYLINE");
    }
  }
  if (y_is_missing) complain();
  return corners;
}

std::optional<std::array<double, 3>> DxfRecordValues::bolt_of(const DxfRecord& record) const {
  std::vector<double> values;
  const DxfGroup* application = nullptr;
  bool is_ours = false;
  for (const DxfGroup& group : record.groups) {
    if (group.code == 1001) is_ours = group.value == kApplication;
    if (group.code == 1001 && is_ours) application = &group;
    if (group.code == 1040 && is_ours) values.push_back(document_.real(group, "a value", "the bolt"));
  }
  if (application == nullptr) return std::nullopt;
  if (values.size() == 3) return std::array<double, 3>{values[0], values[1], values[2]};
  throw InputError(document_.place(*application),
                   fmt::format("expected 3 values (group 1040) of the bolt: stiffness, strength, pre-tension, found {}",
                               values.size()));
}

}  // namespace keyblock::formats
