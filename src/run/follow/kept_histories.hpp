// Keeps the histories of a run in memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/archive.hpp"
#include "run/follow/followed.hpp"

namespace keyblock {

/// Rows of histories.csv, by name of the history and its quantity. Functions that read them throw UsageError for a name
/// that is not there.
class KeptHistories {
 public:
  /// Adds a row of each quantity.
  void add(double time, const std::vector<FollowedValue>& values);
  void describe(Archive& archive);

  std::vector<std::string> names() const;
  /// Returns the quantities of a history, each with its unit.
  std::vector<std::pair<std::string, std::string>> quantities(std::string_view name) const;
  /// Returns times and values in turn; nan at times at which the quantity is unknown.
  std::vector<double> values(std::string_view name, std::string_view quantity) const;

 private:
  struct Quantity {
    std::string name;
    std::string unit;
    std::vector<double> values;  ///< one per time; nan, or none at the end, where it is unknown
  };
  struct History {
    std::string name;
    std::vector<Quantity> quantities;
  };

  std::size_t place_of(std::string_view name);  ///< adds a history that is not there
  const History& at(std::string_view name) const;

  std::vector<double> times_;
  std::vector<History> all_;
};

}  // namespace keyblock
