// What a case asks to be written beside the tables that every run leaves: histories of its choice, and how much of the
// contacts.
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

/// One thing that is followed in time: one of its members is given. Numbers of blocks, joints and bolts from 0; of
/// bodies on covers a block is one element.
struct HistoryPlan {
  std::string name;  ///< empty: made of what it is
  std::optional<Point> point;
  std::optional<int> block;
  std::optional<BlockPair> contact;  ///< all contacts between two blocks
  std::optional<int> joint;          ///< of the drawing
  std::optional<Segment> line;       ///< the resultant of all that crosses it
  Place place = {};
  std::optional<int> bolt = {};  ///< by its number, as `StageBolt`

  bool operator==(const HistoryPlan& other) const {
    return name == other.name && point == other.point && block == other.block && contact == other.contact &&
           joint == other.joint && line == other.line && bolt == other.bolt;
  }
};

/// Which contacts go into tables and the part of contacts for viewers. automatic: all, in tables that would grow too
/// long those of every n-th frame; chosen: those of histories.
enum class ContactTables { automatic, all, chosen, none };

struct OutputPlan {
  std::vector<HistoryPlan> histories;
  ContactTables contacts = ContactTables::automatic;
  int contacts_every = 1;  ///< frames from one to the next
  Place place = {};

  bool operator==(const OutputPlan& other) const {
    return histories == other.histories && contacts == other.contacts && contacts_every == other.contacts_every;
  }
};

}  // namespace keyblock
