// Keeps the journal of a sweep, and writes its table.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A journal has one JSON object per line: first {"sweep": 1, "task": "…"}, then {"job", "verdict", "doubt", "warnings",
// "out", "units", "lacking", "files", "seconds"} per job. A last line cut short by a sudden end is ignored.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "study/sweep/sweep_design.hpp"

namespace keyblock::study {

/// Result of one job. Verdicts: finished, doubtful, stopped, failed; time_limit, memory_limit, signal, error for a job
/// without a result; stands, falls, undecided for a factor of safety without a bracket.
struct SweepResult {
  std::string job;
  std::string verdict = "finished";
  std::string doubt;                                                  ///< reason for the verdict
  std::string warnings;                                               ///< their codes, with blanks between them
  nlohmann::ordered_json out = nlohmann::ordered_json::object();      ///< by name
  double seconds = 0;                                                 ///< of wall time
  nlohmann::ordered_json units = nlohmann::ordered_json::object();    ///< of outputs that have one, by name
  nlohmann::ordered_json lacking = nlohmann::ordered_json::object();  ///< reasons of outputs that its results lack
  std::string files = {};                                             ///< checksum of the files that its settings name
};

struct SweepJournal {
  std::string task;  ///< empty: no journal
  std::map<std::string, SweepResult> results;
  std::string lines;  ///< complete lines

  void add(std::string_view line);
};

std::string sweep_journal_head(const std::string& task);
std::string sweep_journal_line(const SweepResult& result);
SweepJournal read_sweep_journal(std::string_view text);

/// Returns true for the results folder of a sweep, by its journal. That of a batch has the same name, and another head.
bool is_of_a_sweep(const std::filesystem::path& folder);

/// Rows of a sweep with their results.
struct SweepTable {
  std::vector<std::string> outputs;
  std::vector<SweepRow> rows;
  std::vector<SweepResult> results;  ///< of each row
};

/// Throws std::invalid_argument for an output that no row has, and that results of a row lack: a wrong name.
void require_outputs(const SweepTable& table);

/// Returns table.csv: keys, verdict, doubt, warnings, outputs, job. It does not depend on the machine or the order of
/// the jobs.
std::string table_csv(const SweepTable& table);
/// Returns times.csv: job, seconds.
std::string times_csv(const SweepTable& table);
/// Returns both as JSON, with the units of columns that have one: an object of names and units.
std::string table_json(const SweepTable& table, const nlohmann::ordered_json& units);

}  // namespace keyblock::study
