// Holds the additional output that a case requests: histories, and the extent of the contact tables.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "geometry/point.hpp"

namespace keyblock {

/// Two blocks, numbers from 0.
struct BlockPair {
  int first = 0;
  int second = 0;

  bool operator==(const BlockPair&) const = default;
};

/// Item to record in time: one of its members is given. Numbers of blocks, joints and bolts from 0; in NMM bodies a
/// block is one element.
struct HistoryPlan {
  std::string name;  ///< empty: named after the item
  std::optional<Point> point;
  std::optional<int> block;
  std::optional<BlockPair> contact;  ///< all contacts between two blocks
  std::optional<int> joint;          ///< of the drawing
  std::optional<Segment> line;       ///< resultant of all forces across it
  Place place = {};
  std::optional<int> bolt = {};  ///< by its number, as `StageBolt`

  bool operator==(const HistoryPlan& other) const {
    return name == other.name && point == other.point && block == other.block && contact == other.contact &&
           joint == other.joint && line == other.line && bolt == other.bolt;
  }
};

/// Contacts to write to tables and viewer files. automatic: all, but only every n-th frame if tables would grow too
/// long; chosen: those of histories.
enum class ContactTables { automatic, all, chosen, none };

struct OutputPlan {
  std::vector<HistoryPlan> histories;
  ContactTables contacts = ContactTables::automatic;
  int contacts_every = 1;  ///< frames between two tables
  Place place = {};

  bool operator==(const OutputPlan& other) const {
    return histories == other.histories && contacts == other.contacts && contacts_every == other.contacts_every;
  }
};

}  // namespace keyblock
