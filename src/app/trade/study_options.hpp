// Declares the options of `tradeoff` and of its map: the case, the limits of its runs, the reference, and the load of
// the machine.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/exit_code.hpp"
#include "study/trade/measured_run.hpp"
#include "study/trade/tradeoff.hpp"

namespace keyblock {

struct StudyOptions {
  std::vector<std::string> paths;
  std::string profile = "standard";
  std::vector<std::string> sets;
  std::string against;  ///< expected or finest; empty: expected if there are such values
  int finest = 4;
  int repeat = 1;
  double limit = 60;
  std::string picture;
  bool as_json = false;
  bool force = false;

  study::RunLimits limits() const;
};

void add_study_options(CLI::App& options, StudyOptions& chosen);

/// Returns the requested case. Throws UsageError for unknown settings, for a part that is not a power of two, and if
/// requested expected values do not exist.
study::StudyCase case_asked(const StudyOptions& options);

/// Prints a run to standard error.
void tell_run(const study::MeasuredRun& run, std::size_t done, std::size_t of);

/// Prints the message of a stopped study and returns its exit code.
ExitCode stopped_with(const study::Tradeoff& result);

/// Returns "2 processors, load 1.7": other programs that share caches and memory increase processor time too.
std::string machine_words();

/// Returns true if errors of some per cent are uncertain, so that their table is useless.
bool is_in_doubt_as_a_whole(const study::Reference& reference);

/// Explains why errors are uncertain, and up to which size, for a reference that is not resolved.
std::string words_of_doubt(const study::Reference& reference);

/// Describes the measure of errors, and the doubt if there is one.
std::string reference_words(const study::Reference& reference);

nlohmann::ordered_json reference_json(const study::Reference& reference);
nlohmann::ordered_json settings_json(const std::vector<Override>& settings);
/// Returns null for a value that is not finite.
nlohmann::ordered_json json_number(double value);
nlohmann::ordered_json machine_json();

}  // namespace keyblock
