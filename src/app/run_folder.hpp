// The folder a run writes into: frames as they come, tables and pictures at the end.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/files.hpp"
#include "result/frame.hpp"
#include "result/history.hpp"
#include "result/ledger.hpp"
#include "result/step_report.hpp"

namespace keyblock {

enum class Trace { no, yes };

class RunFolder {
 public:
  /// Makes the folder. Throws UsageError if it holds a run already and may not be overwritten.
  RunFolder(std::filesystem::path folder, Overwrite overwrite, Trace trace);

  /// Writes the frame's .vtu at once.
  void add(const Frame& frame);

  /// history.csv, fields.pvd, picture.svg, energy.svg if there is a ledger and, for a trace, steps.csv and blocks.csv.
  void finish(const std::string& title, const History& history, const std::vector<StepReport>& steps,
              const Ledger& ledger);

  /// run.json, last: where it stands, everything else does.
  void write_record(const std::string& json);

  /// Names of what was written, in order.
  const std::vector<std::string>& outputs() const { return outputs_; }

 private:
  void write(const std::string& name, const std::string& text);

  std::filesystem::path folder_;
  std::vector<std::pair<double, std::string>> frame_files_;
  Trace trace_;
  std::vector<Frame> frames_;  ///< for a trace all of them, else the first and the last
  std::vector<std::string> outputs_;
};

}  // namespace keyblock
