// Declares the physical quantity of every column of a run's tables, and of every array of its frames, in one list.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "problem/units/measure.hpp"

namespace keyblock::formats {

/// Column of a table. It cannot be declared without its physical quantity.
struct Column {
  constexpr Column(std::string_view of_name, Measure of_measure) : name(of_name), measure(of_measure) {}

  std::string_view name;  ///< `#` in it stands for a number from 1
  Measure measure;
};

/// File of the run's folder, or the arrays of one part of its frames.
struct RunTable {
  std::string_view file;
  std::span<const Column> columns;
  bool has_letters = false;  ///< [L], [T], [F] in headings if the case does not declare its units
};

extern const RunTable kHistoryTable;
extern const RunTable kPointsTable;
extern const RunTable kHistoriesTable;
extern const RunTable kContactsTable;
extern const RunTable kJointsTable;
extern const RunTable kJointLinesTable;
extern const RunTable kBoltsTable;
extern const RunTable kTipsTable;
extern const RunTable kStepTable;
extern const RunTable kLedgerTable;
extern const RunTable kTraceOfSteps;
extern const RunTable kTraceOfBlocks;
extern const RunTable kTraceOfRounds;
extern const RunTable kBlockArrays;    ///< cells of a frame's blocks or elements
extern const RunTable kCornerArrays;   ///< their corners
extern const RunTable kContactArrays;  ///< points of a frame's contacts
extern const RunTable kCrackArrays;    ///< lines of its cracks, and their corners
extern const RunTable kBoltArrays;     ///< lines of a frame's bolts
extern const RunTable kJointArrays;    ///< lines of a frame's joints

/// Returns all tables, in the order above.
std::span<const RunTable* const> run_tables();

/// Returns true if the table may have a column of this name.
bool has_column(const RunTable& table, std::string_view name);

/// Returns the declared column of this name; "x12" finds "x#". Throws std::logic_error if it is missing.
const Column& column_of(const RunTable& table, std::string_view name);

/// Returns the name with its unit: "x12 [mm]". Degrees are named even if the case does not declare units.
std::string heading(const RunTable& table, std::string_view name, const Units& units);

/// Returns the headings of these columns, or of all, separated by commas.
std::string headings(const RunTable& table, std::span<const std::string_view> names, const Units& units);
std::string headings(const RunTable& table, const Units& units);

}  // namespace keyblock::formats
