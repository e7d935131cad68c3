// What `tradeoff` and `sweep` share: the case, the limits of its runs, what they are held against, and who else is
// running.
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
  std::string against;  ///< expected or finest; empty: expected where there are such values
  int finest = 4;
  int repeat = 1;
  double limit = 60;
  std::string picture;
  bool as_json = false;
  bool force = false;

  study::RunLimits limits() const;
};

void add_study_options(CLI::App& options, StudyOptions& chosen);

/// The case as asked for. Throws UsageError for settings that are none, for a part that is no power of two, and where
/// expected values are asked for that are not there.
study::StudyCase case_asked(const StudyOptions& options);

/// On the standard error, run by run.
void tell_run(const study::MeasuredRun& run, std::size_t done, std::size_t of);

/// What a study that was asked to stop says and returns.
ExitCode stopped_with(const study::Tradeoff& result);

/// "2 processors, load 1.7": processor time, too, grows where others share caches and memory.
std::string machine_words();

/// Whether errors of some per cent are a guess already, so that a table of them says nothing.
bool is_in_doubt_as_a_whole(const study::Reference& reference);

/// Why errors are a guess, and up to which, of a reference that is not resolved.
std::string words_of_doubt(const study::Reference& reference);

/// How errors are measured, and the doubt where there is one.
std::string reference_words(const study::Reference& reference);

nlohmann::ordered_json reference_json(const study::Reference& reference);
nlohmann::ordered_json settings_json(const std::vector<Override>& settings);
/// None for what is not finite.
nlohmann::ordered_json json_number(double value);
nlohmann::ordered_json machine_json();

}  // namespace keyblock
