// `keyblock fos`: the factor of safety of a case by strength reduction.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <memory>

#include "app/command.hpp"
#include "app/commands/study_options.hpp"
#include "app/layers_option.hpp"
#include "app/option_checks.hpp"
#include "app/strength/strength_reduction.hpp"
#include "base/error.hpp"
#include "run/settings_of.hpp"
#include "settings/profile.hpp"

namespace keyblock {
namespace {

struct FosOptions : ReductionOptions {
  std::vector<std::string> paths;
  std::string profile;
  std::vector<std::string> sets;
  std::string layers;
};

ExitCode find_factor(FosOptions options) {
  std::vector<std::string> beside;
  take_layers(beside, options.layers);
  study::StudyCase chosen = study::study_case(options.paths, beside);
  chosen.common = overrides_of(options.sets);
  const std::string profile = profile_of_reduction(chosen.input.problem, options.profile);
  if (const auto reason = chosen.file.not_run.find(rules_of(profile)); reason != chosen.file.not_run.end())
    throw UsageError(fmt::format("fos: {} says of profile {}: {}", chosen.file.path, profile, reason->second));
  ReductionOptions reduction = options;
  if (const auto& asked = chosen.file.reduction) {
    if (reduction.what.empty()) reduction.what = study::name_of(asked->what);
    if (!reduction.from) reduction.from = asked->from;
    if (!reduction.to) reduction.to = asked->to;
    if (!reduction.within) reduction.within = asked->within;
    if (reduction.exempt.empty()) reduction.exempt = asked->exempt;
  }
  if (reduction.what.empty()) reduction.what = "joints";
  std::vector<std::string> files = options.paths;
  files.insert(files.end(), beside.begin(), beside.end());
  std::vector<Override> overrides = chosen.overrides(profile);
  return reduce_strength(
      {chosen.name, std::move(files), std::move(chosen.input), chosen.folder, profile, std::move(overrides)},
      reduction);
}

}  // namespace

Action configure_fos(CLI::App& options) {
  const auto chosen = std::make_shared<FosOptions>();
  options.add_option("case", chosen->paths, "one case folder (legacy_cases/…), or the files of a case")->required();
  options
      .add_option("--reduce", chosen->what,
                  "whose strength: joints, rock, or both (default: what case.json says, else joints)")
      ->check(one_word_of({"joints", "rock", "both"}));
  options
      .add_option("--profile", chosen->profile, "preset of all choices (default: standard, or what a case file says)")
      ->check(one_word_of(profile_names()));
  add_layers_option(options, chosen->layers);
  options.add_option("--set", chosen->sets, "key=value: a setting of all trials; may be repeated")
      ->type_name("KEY=VALUE")
      ->take_all();
  add_reduction_options(options, *chosen);
  options.add_option("-o,--output", chosen->folder, "folder for fos.json, trials.csv, picture.svg and fos.svg")
      ->type_name("FOLDER");
  options.add_flag("--json", chosen->as_json, "print fos.json instead of the table");
  options.add_flag("--force", chosen->force, "overwrite the files of an earlier search");
  add_thread_option(options);
  return [chosen] { return find_factor(*chosen); };
}

}  // namespace keyblock
