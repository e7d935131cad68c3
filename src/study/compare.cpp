// Reads expected.csv, runs the case, and picks the values.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "formats/case.hpp"
#include "formats/csv.hpp"
#include "run/prepare.hpp"

namespace keyblock::study {
namespace {

using OfBlock = double (*)(const ElementFrame&);
using OfScene = double (*)(const Frame&);

const std::map<std::string, OfBlock>& block_quantities() {
  static const std::map<std::string, OfBlock> table{
      {"displacement", [](const ElementFrame& e) { return length(e.displacement); }},
      {"dx", [](const ElementFrame& e) { return e.displacement.x; }},
      {"dy", [](const ElementFrame& e) { return e.displacement.y; }},
      {"cx", [](const ElementFrame& e) { return e.centroid.x; }},
      {"cy", [](const ElementFrame& e) { return e.centroid.y; }},
      {"rotation", [](const ElementFrame& e) { return e.rotation; }},
      {"sxx", [](const ElementFrame& e) { return e.stress.xx; }},
      {"syy", [](const ElementFrame& e) { return e.stress.yy; }},
      {"sxy", [](const ElementFrame& e) { return e.stress.xy; }},
      {"area", [](const ElementFrame& e) { return e.area; }},
      {"speed", [](const ElementFrame& e) { return std::hypot(e.velocity.x, e.velocity.y); }},
  };
  return table;
}

double total_area(const Frame& frame) {
  double area = 0;
  for (const ElementFrame& e : frame.elements) area += e.area;
  return area;
}

const std::map<std::string, OfScene>& scene_quantities() {
  static const std::map<std::string, OfScene> table{
      {"total_area", total_area},
      {"block_count", [](const Frame& f) { return static_cast<double>(f.elements.size()); }},
      {"fixed_point_count", [](const Frame& f) { return static_cast<double>(f.fixed_points.size()); }},
  };
  return table;
}

void require_quantity(const ComparedValue& value, const Place& place) {
  const bool known =
      value.block ? block_quantities().contains(value.quantity) : scene_quantities().contains(value.quantity);
  if (!known)
    throw InputError(place, fmt::format("expected a quantity of {}, found \"{}\"",
                                        value.block ? "a block" : "the scene", value.quantity));
}

std::vector<ComparedValue> read_expected(const std::filesystem::path& file) {
  const formats::CsvTable table = formats::read_csv(formats::load(file.string()));
  const auto column = [&](const char* name) { return formats::csv_column(table, name); };
  const std::size_t quantity = column("quantity"), block = column("block"), time = column("time"),
                    value = column("value"), tolerance = column("tolerance"), reason = column("tolerance_reason"),
                    source = column("source");
  std::vector<ComparedValue> values;
  for (const formats::CsvRow& row : table.rows) {
    ComparedValue v;
    v.quantity = row.cells[quantity];
    if (!row.cells[block].empty()) v.block = static_cast<int>(formats::csv_real(table, row, block));
    v.time = formats::csv_real(table, row, time);
    v.expected = formats::csv_real(table, row, value);
    v.tolerance = formats::csv_real(table, row, tolerance);
    v.tolerance_reason = row.cells[reason];
    v.source = row.cells[source];
    require_quantity(v, {file.string(), row.line, 1});
    values.push_back(std::move(v));
  }
  return values;
}

double value_of(const ComparedValue& wanted, const Frame& frame) {
  if (!wanted.block) return scene_quantities().at(wanted.quantity)(frame);
  return block_quantities().at(wanted.quantity)(frame.elements[static_cast<std::size_t>(*wanted.block - 1)]);
}

void require_blocks(const std::vector<ComparedValue>& values, std::size_t count, const std::string& file) {
  for (const ComparedValue& v : values) {
    if (v.block && (*v.block < 1 || *v.block > static_cast<int>(count)))
      throw InputError({file, 0, 0}, fmt::format("expected a block from 1 to {}, found {}", count, *v.block));
  }
}

// Times of the table are steps of the run up to the round-off of their sum: half a step tells neighbours apart.
void pick(std::vector<ComparedValue>& values, const Frame& frame, double half_step) {
  for (ComparedValue& v : values) {
    if (std::abs(frame.time - v.time) < half_step) v.computed = value_of(v, frame);
  }
}

}  // namespace

bool ComparedValue::holds() const {
  return computed && std::abs(error()) <= tolerance;
}

bool ComparedCase::holds() const {
  return outcome.end == RunEnd::finished && std::ranges::all_of(values, &ComparedValue::holds);
}

ComparedCase compare_case(const CaseFolder& folder, const std::string& profile) {
  ComparedCase compared;
  compared.name = folder.name;
  const std::string table = (folder.folder / "expected.csv").string();
  compared.values = read_expected(table);
  const formats::Case loaded = formats::load_case(folder.inputs());
  const Prepared prepared = prepare(loaded.problem, profile, {});
  compared.warnings = joined(loaded.warnings, prepared.warnings);
  require_blocks(compared.values, prepared.scene.model.elements.size(), table);
  const auto followed =
      std::ranges::find_if(compared.values, [](const ComparedValue& v) { return v.block.has_value(); });
  const std::size_t block = followed == compared.values.end() ? 0 : static_cast<std::size_t>(*followed->block - 1);
  Observer observer;
  observer.on_frame = [&](const Frame& frame) {
    if (frame.step == 0) compared.start = frame;
    compared.end = frame;
    compared.times.push_back(frame.time);
    compared.displacements.push_back(length(frame.elements[block].displacement));
    pick(compared.values, frame, prepared.scene.settings.time_step / 2);
  };
  compared.outcome = run(prepared.scene, 1, observer);
  return compared;
}

}  // namespace keyblock::study
