// Returns the columns of one instant. Contacts are computed when they are first asked for.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/tables/run_tables.hpp"
#include "library/parts.hpp"
#include "problem/units/measure.hpp"

namespace keyblock::api {
namespace {

template <class T>
Column<T> column_of(const Frame::Data& frame, std::string_view part, std::string_view name) {
  const formats::FrameColumn& column = frame.part(part).at(name);
  const auto* values = std::get_if<std::shared_ptr<const std::vector<T>>>(&column.numbers);
  if (!values)
    throw Error("column " + std::string(name) + " of " + std::string(part) + " holds " +
                    (std::is_same_v<T, int> ? "reals" : "integers"),
                ErrorCode::choice);
  return {*values, formats::width_of(column.shape)};
}

Measure measure_of(std::string_view part, std::string_view name) {
  if (name == "place" || name == "ends" || name == "centroid" || name == "length") return measures::kLength;
  const formats::RunTable& table = part == "contacts" ? formats::kContactArrays
                                   : part == "bolts"  ? formats::kBoltArrays
                                   : part == "cracks" ? formats::kCrackArrays
                                   : part == "tips"   ? formats::kTipsTable
                                                      : formats::kBlockArrays;
  const std::string tensor = std::string(name) + "_xx";
  for (const formats::Column& column : table.columns)
    if (column.name == name || column.name == tensor) return column.measure;
  return measures::kNumber;
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

int Frame::epoch() const {
  return data_->epoch;
}

std::vector<std::string> Frame::parts() {
  std::vector<std::string> names;
  for (const formats::FramePart& part : formats::columns_of({}, {}).parts) names.emplace_back(part.name);
  return names;
}

std::vector<std::string> Frame::names(std::string_view part) const {
  return guarded([&] {
    std::vector<std::string> names;
    for (const formats::FrameColumn& column : data_->part(part).columns) names.emplace_back(column.name);
    return names;
  });
}

std::size_t Frame::rows(std::string_view part) const {
  return guarded([&] { return data_->part(part).rows; });
}

bool Frame::is_integer(std::string_view part, std::string_view name) const {
  return guarded([&] { return data_->part(part).at(name).numbers.index() == 1; });
}

std::vector<std::string> Frame::components(std::string_view part, std::string_view name) const {
  return guarded([&]() -> std::vector<std::string> {
    switch (data_->part(part).at(name).shape) {
      case formats::RowShape::number:
        return {};
      case formats::RowShape::xy:
        return {"x", "y"};
      case formats::RowShape::tensor:
        return {"xx", "yy", "xy", "zz"};
      case formats::RowShape::ends:
        return {"x1", "y1", "x2", "y2"};
    }
    return {};
  });
}

std::string Frame::unit(std::string_view part, std::string_view name) const {
  return guarded([&] {
    components(part, name);  // throws for a column that no frame has
    const Measure measure = measure_of(part, name);
    return is_declared(measure, data_->units) ? unit_of(measure, data_->units) : std::string();
  });
}

Column<double> Frame::reals(std::string_view part, std::string_view name) const {
  return guarded([&] { return column_of<double>(*data_, part, name); });
}

Column<int> Frame::integers(std::string_view part, std::string_view name) const {
  return guarded([&] { return column_of<int>(*data_, part, name); });
}

}  // namespace v1
}  // namespace keyblock::api
