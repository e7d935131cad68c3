// Keeps a row per instant and quantity, as histories.csv has them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "library/kept_histories.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "result/rows/thinned.hpp"

namespace keyblock::api {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

KeptHistories::KeptHistories(const PlannedCase& planned, const DrawnJoints& joints)
    : joints_(joints),
      followed_(planned.problem.outputs.histories, planned.prepared.scene, joints, planned.problem.units),
      last_(planned.prepared.scene.settings.step_count) {}

void KeptHistories::add(const Stepper& stepper) {
  if (followed_.is_empty()) return;
  const int step = stepper.state().step;
  if (step % stride_of(last_) != 0 && step != last_) return;
  times_.push_back(stepper.state().time);
  for (const FollowedValue& value : followed_.values(stepper, joints_)) {
    auto history = std::ranges::find(all_, value.name, &History::name);
    if (history == all_.end()) history = all_.insert(all_.end(), {value.name, {}});
    auto quantity = std::ranges::find(history->quantities, value.quantity, &Quantity::name);
    if (quantity == history->quantities.end())
      quantity = history->quantities.insert(quantity, {value.quantity, value.unit, {}});
    // A contact that is apart has no gap, and a block that a stage makes has no values before it.
    quantity->values.resize(times_.size() - 1, kUnknown);
    quantity->values.push_back(value.value);
  }
}

std::vector<std::string> KeptHistories::names() const {
  std::vector<std::string> names;
  for (const History& history : all_) names.push_back(history.name);
  return names;
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
  std::vector<double> rows;
  for (std::size_t i = 0; i < times_.size(); ++i) {
    rows.push_back(times_[i]);
    rows.push_back(i < found->values.size() ? found->values[i] : kUnknown);
  }
  return {std::make_shared<const std::vector<double>>(std::move(rows)), 2};
}

}  // namespace keyblock::api
