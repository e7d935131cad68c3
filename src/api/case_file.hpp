// Reads `case.json`: settings, variants and search of a case folder, in addition to the files of Shi's formats.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Layout, every key optional:
//   {"about": "one sentence", "slow": false,
//    "reduce_strength": {"what": "joints", "from": 1, "to": 2, "to_within": 0.01,
//                        "exempt": ["joint_material:2"]},                        instead of a run: `fos`
//    "set": {"both": {"SETTING": "VALUE"}, "legacy": {…}, "standard": {…}},      as by `run --set`
//    "variants": [{"name": "10 ms, rigid", "profile": "standard", "set": {"SETTING": "VALUE"},
//                  "tolerance": 2e-3, "reason": "why this tolerance"}],
//    "legacy": "not run: REASON", "standard": "not run: REASON"}
// A text in the list of variants names a file with further variants, relative to the folder, so that cases can share
// them. A value is text or a number. A file named by a setting is searched in the case folder.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "api/case_folder.hpp"
#include "api/strength_choice.hpp"
#include "run/prepare.hpp"

namespace keyblock {

/// Run in addition to the plain one, compared with the same expected values.
struct Variant {
  std::string name;
  std::string profile;
  std::vector<Override> set;        ///< on top of the case's own for this profile
  std::optional<double> tolerance;  ///< absolute; replaces that of every expected value
  std::string reason;               ///< of that tolerance
};

struct CaseFile {
  std::string path;  ///< for messages; set even if the file does not exist
  std::string about;
  bool is_slow = false;                              ///< skipped unless all cases are requested
  std::map<std::string, std::vector<Override>> set;  ///< by profile; those of both profiles come first
  std::map<std::string, std::string> not_run;        ///< by profile: the reason
  std::vector<Variant> variants;
  std::optional<ReductionAsked> reduction;

  /// Returns the settings of the plain run under `profile`: those for `legacy` or `standard`, also for profiles that
  /// vary one of them.
  std::vector<Override> overrides(const std::string& profile) const;
};

/// Returns true for a `case.json` with the keys that `read_case_file` takes: notes on the case beside it.
bool is_case_notes(const std::filesystem::path& file);

/// Reads the case file of the folder; empty if it does not exist. Throws InputError with file and key for an unknown
/// key, or a value of the wrong kind.
CaseFile read_case_file(const CaseFolder& folder);

}  // namespace keyblock
