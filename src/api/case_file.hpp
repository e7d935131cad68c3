// What a case folder says of its runs beyond the old files: `case.json`.
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
// A text in the list of variants names a file, relative to the folder, with a list of more, so that cases can share
// them. A value is text or a number. A file that a setting names is looked for in the case folder.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "api/case_folder.hpp"
#include "api/strength_choice.hpp"
#include "run/prepare.hpp"

namespace keyblock {

/// A run beside the plain one, held against the same expected values.
struct Variant {
  std::string name;
  std::string profile;
  std::vector<Override> set;        ///< on top of the case's own for this profile
  std::optional<double> tolerance;  ///< absolute, in place of that of every expected value
  std::string reason;               ///< of that tolerance
};

struct CaseFile {
  std::string path;  ///< for messages; set whether or not the file is there
  std::string about;
  bool is_slow = false;                              ///< left out unless all cases are asked for
  std::map<std::string, std::vector<Override>> set;  ///< by profile; those of both profiles come first
  std::map<std::string, std::string> not_run;        ///< by profile: why it is not
  std::vector<Variant> variants;
  std::optional<ReductionAsked> reduction;

  /// The settings of the plain run under `profile`: what the file sets for legacy or standard, whichever it varies.
  std::vector<Override> overrides(const std::string& profile) const;
};

/// The case file of the folder; an empty one where there is none. Throws InputError naming file and key for a key that
/// is none, or a value of the wrong kind.
CaseFile read_case_file(const CaseFolder& folder);

}  // namespace keyblock
