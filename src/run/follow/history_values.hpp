// Declares the values of a history at one instant.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "problem/output_plan.hpp"
#include "problem/run_choices.hpp"
#include "result/contact_frame.hpp"
#include "step/stepper.hpp"

namespace keyblock {

/// Unit names of the table; letters if the case does not declare the units.
struct FollowedUnits {
  explicit FollowedUnits(const Units& units = {});

  std::string length;
  std::string velocity;
  std::string rotation_rate;
  std::string force;
  std::string stress;
  std::string moment;
};

/// Value of a history at one instant.
struct FollowedValue {
  std::string what;  ///< "point"
  std::string name;
  std::string quantity;  ///< "displacement_x"
  double value = 0;
  std::string unit;
};

/// Indices in a model by the numbers of elements, measured points and bolts.
struct ItemsByNumber {
  explicit ItemsByNumber(const Model& model);

  std::map<int, ElementIndex> elements;
  std::map<int, std::size_t> points;
  std::map<int, std::size_t> bolts;
};

/// Item of a history, with the kind and the name that its rows have.
struct FollowedItem {
  const HistoryPlan& plan;
  int point = -1;  ///< number of the measured point
  std::string what;
  std::string name;
};

/// Values of one item at one instant; none of an item that is missing then.
struct HistoryValues {
  std::vector<FollowedValue> values;
  bool bears = false;               ///< a closed contact, or something that crosses the line
  std::optional<double> least_gap;  ///< of the contacts considered
};

/// `contacts`: those of the step, with their joints of the drawing.
HistoryValues values_of(const FollowedItem& item, const Stepper& stepper, const ItemsByNumber& numbered,
                        const ContactFrames& contacts, const FollowedUnits& units);

/// Returns true for contacts of the two blocks, in either order.
bool is_between(const ContactFrame& contact, const BlockPair& pair);

}  // namespace keyblock
