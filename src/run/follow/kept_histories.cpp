// Keeps a row per instant and quantity, as histories.csv has them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/follow/kept_histories.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/error.hpp"

namespace keyblock {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

// Values come history by history, in nearly the same order each time.
void KeptHistories::add(double time, const std::vector<FollowedValue>& values) {
  times_.push_back(time);
  std::size_t here = 0;
  for (const FollowedValue& value : values) {
    if (here < all_.size() && all_[here].name != value.name) ++here;
    if (here == all_.size() || all_[here].name != value.name) here = place_of(value.name);
    std::vector<Quantity>& quantities = all_[here].quantities;
    auto quantity = std::ranges::find(quantities, value.quantity, &Quantity::name);
    if (quantity == quantities.end()) quantity = quantities.insert(quantity, {value.quantity, value.unit, {}});
    // A contact that is apart has no gap, and a block that a stage makes has no values before it.
    quantity->values.resize(times_.size() - 1, kUnknown);
    quantity->values.push_back(value.value);
  }
}

std::size_t KeptHistories::place_of(std::string_view name) {
  const auto found = std::ranges::find(all_, name, &History::name);
  if (found != all_.end()) return static_cast<std::size_t>(found - all_.begin());
  all_.push_back({std::string(name), {}});
  return all_.size() - 1;
}

void KeptHistories::describe(Archive& archive) {
  archive.numbers("times", times_);
  archive.list("histories", all_, [&](History& history) {
    archive.value("name", history.name);
    archive.list("quantities", history.quantities, [&](Quantity& quantity) {
      archive.value("name", quantity.name);
      archive.value("unit", quantity.unit);
      archive.numbers("values", quantity.values);
    });
  });
}

std::vector<std::string> KeptHistories::names() const {
  std::vector<std::string> names;
  for (const History& history : all_) names.push_back(history.name);
  return names;
}

const KeptHistories::History& KeptHistories::at(std::string_view name) const {
  const auto found = std::ranges::find(all_, name, &History::name);
  if (found != all_.end()) return *found;
  if (all_.empty()) throw UsageError(fmt::format("expected no history, because the run keeps none, found {}", name));
  throw UsageError(fmt::format("expected the name of a history, such as {}, found {}", all_.front().name, name));
}

std::vector<std::pair<std::string, std::string>> KeptHistories::quantities(std::string_view name) const {
  std::vector<std::pair<std::string, std::string>> all;
  for (const Quantity& quantity : at(name).quantities) all.emplace_back(quantity.name, quantity.unit);
  return all;
}

std::vector<double> KeptHistories::values(std::string_view name, std::string_view quantity) const {
  const History& history = at(name);
  const auto found = std::ranges::find(history.quantities, quantity, &Quantity::name);
  if (found == history.quantities.end())
    throw UsageError(fmt::format("expected a quantity of the history {}, found {}", name, quantity));
  std::vector<double> rows;
  for (std::size_t i = 0; i < times_.size(); ++i) {
    rows.push_back(times_[i]);
    rows.push_back(i < found->values.size() ? found->values[i] : kUnknown);
  }
  return rows;
}

}  // namespace keyblock
