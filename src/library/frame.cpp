// Returns the columns of one instant.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "library/parts.hpp"

namespace keyblock::api {
namespace {

/// Returns a column of a part; empty if the part has no rows.
template <class T>
Column<T> column_of(const formats::FrameColumns& frame, std::string_view part_name, std::string_view name) {
  const formats::FramePart& part = frame.part(part_name);
  if (part.rows == 0) return {std::make_shared<const std::vector<T>>(), 1};
  const formats::FrameColumn& column = part.at(name);
  const auto* values = std::get_if<std::shared_ptr<const std::vector<T>>>(&column.numbers);
  if (!values)
    throw SettingError("column " + std::string(name) + " of " + std::string(part_name) + " holds " +
                       (std::is_same_v<T, int> ? "reals" : "integers"));
  return {*values, formats::width_of(column.shape)};
}

}  // namespace

inline namespace v1 {

int Frame::step() const {
  return data_->columns.step;
}

double Frame::time() const {
  return data_->columns.time;
}

double Frame::load_factor() const {
  return data_->columns.load_factor;
}

std::vector<std::string> Frame::parts() {
  std::vector<std::string> names;
  for (const formats::FramePart& part : formats::columns_of({}, {}).parts) names.emplace_back(part.name);
  return names;
}

std::vector<std::string> Frame::names(std::string_view part) const {
  return guarded([&] {
    std::vector<std::string> names;
    for (const formats::FrameColumn& column : data_->columns.part(part).columns) names.emplace_back(column.name);
    return names;
  });
}

std::size_t Frame::rows(std::string_view part) const {
  return guarded([&] { return data_->columns.part(part).rows; });
}

bool Frame::is_integer(std::string_view part, std::string_view name) const {
  return guarded([&] { return data_->columns.part(part).at(name).numbers.index() == 1; });
}

Column<double> Frame::reals(std::string_view part, std::string_view name) const {
  return guarded([&] { return column_of<double>(data_->columns, part, name); });
}

Column<int> Frame::integers(std::string_view part, std::string_view name) const {
  return guarded([&] { return column_of<int>(data_->columns, part, name); });
}

}  // namespace v1
}  // namespace keyblock::api
