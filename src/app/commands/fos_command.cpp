// `keyblock fos`: computes the factor of safety of a case by strength reduction.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "app/command.hpp"
#include "app/input/case_options.hpp"
#include "app/option_checks.hpp"
#include "app/strength/strength_reduction.hpp"

namespace keyblock {
namespace {

struct FosOptions : ReductionOptions {
  CaseOptions given;
};

}  // namespace

Action configure_fos(CLI::App& options) {
  const auto chosen = std::make_shared<FosOptions>();
  add_case_options(options, chosen->given, "one case folder, or the files of a case").files->required();
  options
      .add_option("--reduce", chosen->what,
                  "strength to reduce: joints, rock or both (default: that of the case, else joints)")
      ->check(one_word_of({"joints", "rock", "both"}));
  add_reduction_options(options, *chosen);
  CLI::Option* folder =
      options.add_option("-o,--output", chosen->folder, "folder for fos.json, trials.csv, picture.svg and fos.svg")
          ->type_name("FOLDER");
  options.add_flag("--json", chosen->as_json, "print fos.json instead of the table");
  options.add_flag("--plan", chosen->plan_only, "print profile, settings and unknowns as JSON, and make no trial")
      ->excludes(folder);
  options.add_flag("--force", chosen->force, "overwrite the files of an earlier search");
  add_thread_option(options);
  return [chosen] { return reduce_strength(case_of(chosen->given), *chosen); };
}

}  // namespace keyblock
