// Reads the lines that a run writes to histories.csv.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "library/kept_histories.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>

#include "formats/text/csv.hpp"
#include "result/rows/thinned.hpp"

namespace keyblock::api {
namespace {

double number_in(const std::string& text) {
  double number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

}  // namespace

KeptHistories::KeptHistories(const PlannedCase& planned)
    : joints_(planned.prepared.scene.model, planned.prepared.joint_lines),
      followed_(planned.problem.outputs.histories, planned.prepared.scene, joints_, planned.problem.units),
      last_(planned.prepared.scene.settings.step_count) {}

void KeptHistories::add(const Stepper& stepper) {
  if (followed_.is_empty()) return;
  const int step = stepper.state().step;
  if (step % stride_of(last_) != 0 && step != last_) return;
  const formats::CsvTable table =
      formats::read_csv({"histories", "step,time,what,name,quantity,value,unit\n" + followed_.rows(stepper, joints_)});
  for (const formats::CsvRow& row : table.rows) {
    const std::vector<std::string>& cells = row.cells;
    auto history = std::ranges::find(all_, cells[3], &History::name);
    if (history == all_.end()) history = all_.insert(all_.end(), {cells[3], {}});
    auto quantity = std::ranges::find(history->quantities, cells[4], &Quantity::name);
    if (quantity == history->quantities.end())
      quantity = history->quantities.insert(quantity, {cells[4], cells[6], {}});
    quantity->rows.push_back(number_in(cells[1]));
    quantity->rows.push_back(number_in(cells[5]));
  }
}

std::vector<std::string> KeptHistories::names() const {
  std::vector<std::string> names;
  for (const History& history : all_) names.push_back(history.name);
  return names;
}

bool KeptHistories::has(std::string_view name) const {
  return std::ranges::find(all_, name, &History::name) != all_.end();
}

const KeptHistories::History& KeptHistories::at(std::string_view name) const {
  const auto found = std::ranges::find(all_, name, &History::name);
  if (found == all_.end())
    throw SettingError(fmt::format("expected the name of a history, {}, found {}",
                                   all_.empty() ? "of which there is none" : "such as " + all_.front().name, name));
  return *found;
}

std::vector<std::pair<std::string, std::string>> KeptHistories::quantities(std::string_view name) const {
  std::vector<std::pair<std::string, std::string>> all;
  for (const Quantity& quantity : at(name).quantities) all.emplace_back(quantity.name, quantity.unit);
  return all;
}

Column<double> KeptHistories::values(std::string_view name, std::string_view quantity) const {
  const History& history = at(name);
  const auto found = std::ranges::find(history.quantities, quantity, &Quantity::name);
  if (found == history.quantities.end())
    throw SettingError(fmt::format("expected a quantity of the history {}, found {}", name, quantity));
  return {std::make_shared<const std::vector<double>>(found->rows), 2};
}

}  // namespace keyblock::api
