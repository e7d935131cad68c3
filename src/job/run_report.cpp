// Builds run.json from the record of a run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/run_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "formats/tables/run_tables.hpp"
#include "job/folder/made_by.hpp"
#include "job/ledger_report.hpp"
#include "job/record/run_measures.hpp"
#include "job/run_heading.hpp"
#include "job/step_tables.hpp"
#include "job/verdict/end_of_motion.hpp"
#include "settings/settings_table.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;

// Factor on the load steps of a run that found no equilibrium.
constexpr int kMoreLoadSteps = 5;

const char* word_for(RunEnd end) {
  switch (end) {
    case RunEnd::finished:
      return "finished";
    case RunEnd::failed:
      return "failed";
    case RunEnd::stopped:
      return "stopped";
  }
  return "";
}

Json steps_by_passes_json(const StepTotals& totals) {
  Json bins = Json::array();
  for (std::size_t i = 0; i < totals.steps_by_passes.size(); ++i) {
    const int from = i == 0 ? 0 : StepTotals::pass_limits[i - 1] + 1;
    const Json to = i < StepTotals::pass_limits.size() ? Json(StepTotals::pass_limits[i]) : Json();
    bins.push_back({{"from", from}, {"to", to}, {"steps", totals.steps_by_passes[i]}});
  }
  return bins;
}

Json counts_json(const Prepared& prepared, const StepTotals& totals) {
  const Model& model = prepared.scene.model;
  const bool is_of_blocks = model.nodes.empty();
  Json counts = {{is_of_blocks ? "blocks" : "elements", model.elements.size()},
                 {"vertices", model.vertices.size()},
                 {"unknowns", prepared.requirements.unknowns},
                 {"fixed_points", model.fixed_points.size()},
                 {"loading_points", model.loading_points.size()},
                 {"measured_points", model.measured_points.size()},
                 {"most_contacts", totals.most_contacts},
                 {"passes", totals.passes},
                 {"most_passes", totals.most_passes},
                 {"steps_by_passes", steps_by_passes_json(totals)},
                 {"redone_attempts", totals.redos},
                 {"fallback_solves", totals.fallbacks},
                 {"unresolved_parts", totals.unresolved_parts},
                 {"locked_overlaps", totals.locked_overlaps}};
  if (totals.steps > 0) {
    counts["least_dt"] = totals.least_dt;
    counts["greatest_dt"] = totals.greatest_dt;
    counts["greatest_penetration"] = totals.greatest_penetration;
    counts["greatest_displacement_ratio"] = totals.greatest_displacement_ratio;
    counts["greatest_residual"] = totals.greatest_residual;
  }
  if (!is_of_blocks) counts["covers"] = model.nodes.size();
  if (prepared.cut) counts["snaps"] = prepared.snaps.size();
  return counts;
}

// The rows themselves are in a table of their own.
Json steps_json(const StepRows& steps, const Units& units) {
  return {{"table", formats::kStepTable.file},
          {"columns", step_columns(steps.rows(), units)},
          {"kept_every", steps.stride()}};
}

Json start_json(const StartReport& start) {
  return {{"made", start.made},
          {"balanced", start.balanced},
          {"why", start.why},
          {"misfit", start.misfit},
          {"unsolved_steps", start.unsolved_steps},
          {"unbalanced", start.unbalanced}};
}

Json facts_json(const Facts& facts) {
  Json json = Json::object();
  for (const auto& [name, value] : facts.numbers) json["numbers"][name] = value;
  if (!facts.elements.empty()) json["blocks"] = facts.elements;
  if (!facts.points.empty()) json["points"] = facts.points;
  for (const auto& [kind, name] : facts.names) json["names"][kind].push_back(name);
  return json;
}

Json outcome_json(const RunRecord& record, const Prepared& prepared) {
  const RunOutcome& outcome = record.outcome;
  Json contacts = Json::array();
  for (std::size_t c : outcome.contacts) contacts.push_back(c + 1);
  Json json = {{"end", word_for(outcome.end)}, {"steps", outcome.steps}, {"time", outcome.time}};
  if (!outcome.why_early.empty()) json["ended_early"] = outcome.why_early;
  if (record.motion) json["motion"] = motion_json(prepared, record, *record.motion);
  if (outcome.end == RunEnd::failed) {
    json["reason"] = outcome.reason;
    json["failure"] = word_for(outcome.failure);
    if (!outcome.cause.empty()) {
      json["cause"] = {{"code", outcome.cause.code()}};
      json["cause"].update(facts_json(outcome.cause.facts));
    }
    json["contacts"] = contacts;
    json["blocks"] = Json::array();
    for (const int number : outcome.numbers) json["blocks"].push_back(number);
    json["try"] = Json::array();
    for (const Remedy& remedy : what_to_try(prepared, outcome)) json["try"].push_back(remedy.option);
  }
  Json doubts = Json::array();
  for (const Warning& doubt : record.doubts) doubts.push_back(doubt.sentence);
  json["doubts"] = doubts;
  return json;
}

Json json_of(const Extremes& found) {
  return {{"greatest_displacement", {{"value", found.displacement}, {"element", found.displaced_element + 1}}},
          {"least_principal_stress", {{"value", found.least_stress}, {"element", found.compressed_element + 1}}},
          {"greatest_principal_stress", {{"value", found.greatest_stress}, {"element", found.stretched_element + 1}}},
          {"least_area_share", {{"value", found.area_share}, {"element", found.crushed_element + 1}}}};
}

Json json_of(const PlasticExtremes& found) {
  const PlasticTotals& totals = found.totals;
  return {{"yielded_fraction", totals.yielded_fraction()},
          {"yielding_fraction", totals.yielding_fraction()},
          {"area", totals.area},
          {"plastic_work", totals.work ? Json(*totals.work) : Json()},
          {"greatest_equivalent_plastic_strain",
           {{"value", found.equivalent}, {"element", found.element + 1}, {"x", found.place.x}, {"y", found.place.y}}}};
}

Json json_of(const ReactionCurve& curve) {
  Json json = {{"displacement", curve.number + 1},
               {"component", std::string(1, curve.component)},
               {"driven", curve.driven.back()},
               {"reaction", curve.reaction.back()},
               {"slope", Json()},
               {"plateau", Json()}};
  if (const std::optional<double> slope = end_slope(curve)) json["slope"] = *slope;
  if (const std::optional<std::size_t> first = plateau_of(curve))
    json["plateau"] = {{"since_step", curve.steps[*first]}, {"since_driven", curve.driven[*first]}};
  return json;
}

Json json_of(const Resultant& r) {
  return {{"x", r.force.x}, {"y", r.force.y}, {"moment", r.moment}};
}

Json json_of(const ForceBalance& balance) {
  Json supports = Json::array();
  for (const Resultant& support : balance.supports) supports.push_back(json_of(support));
  return {{"loads", json_of(balance.loads)},
          {"springs", json_of(balance.springs)},
          {"supports", supports},
          {"unbalanced", balance.unbalanced()}};
}

Json stages_json(const std::vector<SceneReport>& scenes) {
  Json stages = Json::array();
  for (const SceneReport& scene : scenes) {
    Json stage = {{"name", scene.name},
                  {"steps", {scene.first_step + 1, scene.last_step}},
                  {"end_time", scene.end_time},
                  {"balanced", Json()}};
    if (scene.asks_equilibrium) stage["balanced"] = scene.is_balanced;
    if (scene.forces) stage["forces"] = json_of(*scene.forces);
    stages.push_back(stage);
  }
  return stages;
}

Json json_of(const EquilibriumWay& way) {
  return {{"share", way.share ? Json(*way.share) : Json()}, {"last_step_ratio", way.last_step_ratio}};
}

/// Returns advice for load steps of elastoplastic rock without contacts. Motion is no option: it would apply all loads
/// at once.
std::vector<Remedy> what_to_try_under_loads(const Scene& scene) {
  std::vector<Remedy> remedies{{fmt::format("--set steps={}", kMoreLoadSteps * scene.settings.step_count),
                                "makes the load steps shorter, which helps unless this is the limit load"}};
  if (scene.settings.standard.load_control == LoadControl::share && !scene.next && scene.end.steps == 0)
    remedies.push_back({"--set load_control=arc_length", "follows the equilibria beyond a limit load"});
  return remedies;
}

}  // namespace

const char* word_for(FailureKind kind) {
  switch (kind) {
    case FailureKind::undecided:
    case FailureKind::inside_out:
      return "undecided";
    case FailureKind::no_equilibrium:
    case FailureKind::accelerates:
      return "no_equilibrium";
    case FailureKind::cracks:
      return "cracks";
  }
  return "";
}

std::vector<Remedy> what_to_try(const Prepared& prepared, const RunOutcome& outcome) {
  const Settings& settings = prepared.scene.settings;
  if (settings.dynamics == Dynamics::shi) {
    std::vector<Remedy> remedies{{"--profile standard", "solves contact forces to a stated residual"}};
    if (settings.quirks.velocity_from_coming_step)
      remedies.push_back(
          {"--set quirk.velocity_from_coming_step=off", "often lets a run with a changing step size continue"});
    return remedies;
  }
  if (settings.standard.motion == MotionRule::dynamic || outcome.failure == FailureKind::cracks) return {};
  const bool yields = may_yield(prepared.scene);
  if (yields && prepared.scene.is_untouched && outcome.failure == FailureKind::no_equilibrium)
    return what_to_try_under_loads(prepared.scene);
  std::vector<Remedy> remedies{{"--set motion=dynamic", "shows the motion"}};
  if (!yields && !prepared.scene.model.continuum)  // blocks without strength
    remedies.push_back({"--profile legacy", "starts each step at zero velocity, as Shi's programs do"});
  return remedies;
}

Json inputs_json(const std::vector<InputRecord>& inputs) {
  Json all = Json::array();
  for (const InputRecord& input : inputs) {
    all.push_back(
        {{"file", input.file}, {"sha256", input.sha256}, {"format", input.format}, {"evidence", input.evidence}});
    if (!input.setting.empty()) all.back()["setting"] = input.setting;
  }
  return all;
}

Json values_json(const std::vector<ChangedValue>& values) {
  Json all = Json::object();
  for (const auto& [pointer, text] : values) {
    const Json value = Json::parse(text, nullptr, false);
    all[pointer] = value.is_discarded() ? Json(text) : value;
  }
  return all;
}

Json warning_list_json(const Warnings& warnings) {
  Json all = Json::array();
  for (const Warning& w : warnings) {
    all.push_back({{"name", w.name},
                   {"file", w.place.file.text()},
                   {"line", w.place.line},
                   {"column", w.place.column},
                   {"sentence", w.sentence}});
    all.back().update(facts_json(w.facts));
  }
  return all;
}

Json warnings_json(const Warnings& warnings) {
  Json all = Json::array();
  for (const Warning& warning : warnings) {
    const auto known = std::ranges::find_if(all, [&](const Json& w) { return w["name"] == warning.name; });
    if (known == all.end()) {
      all.push_back({{"name", warning.name}, {"count", 1}, {"first", to_string(warning)}});
      all.back().update(facts_json(warning.facts));
      continue;
    }
    (*known)["count"] = (*known)["count"].get<int>() + 1;
    constexpr std::size_t kMostOthers = 20;
    Json& others = (*known)["others"];
    if (others.size() < kMostOthers) others.push_back(to_string(warning));
  }
  return all;
}

Json all_settings_json(const Settings& settings) {
  return settings_json_of(list(settings));
}

Json settings_json_of(const std::vector<SettingText>& settings) {
  Json all = Json::object();
  for (const SettingText& setting : settings) {
    Json value = setting.is_number ? Json::parse(setting.value, nullptr, false) : Json(setting.value);
    all[setting.name] = value.is_discarded() ? Json() : value;  // infinite: not valid in JSON
  }
  return all;
}

Json plan_json(const std::string& name, const ChosenProfile& profile, const Prepared& prepared) {
  return {{"program", "keyblock"},
          {"version", KEYBLOCK_VERSION},
          {"case", name},
          {"profile", profile.name},
          {"profile_because", profile.why},
          {"unknowns", prepared.requirements.unknowns},
          {"settings", all_settings_json(prepared.scene.settings)}};
}

Json requirements_json(const Requirements& requirements) {
  Json terms = Json::array();
  for (const RequiredTerm& term : requirements.terms)
    terms.push_back({{"term", name_of(term.term)}, {"reason", term.reason}});
  return {{"unknowns", requirements.unknowns}, {"basis", requirements.basis}, {"terms", terms}};
}

Json run_json(const Prepared& prepared, const RunRecord& record) {
  Json json = {
      {"program", "keyblock"},
      {"version", KEYBLOCK_VERSION},
      {"made_by", made_by_json()},
      {"profile", record.profile},
      {"profile_because", record.profile_because},
      {"outcome", outcome_json(record, prepared)},
      {"extremes", json_of(record.extremes)},
      {"start", start_json(record.outcome.start)},
      {"inputs", inputs_json(record.inputs)},
      {"settings", all_settings_json(prepared.scene.settings)},
      {"requirements", requirements_json(prepared.requirements)},
      {"counts", counts_json(prepared, record.totals)},
      {"warnings", warnings_json(record.warnings)},
      {"recorded_every", record.record_every},
      {"seconds", {{"read", record.timings.read}, {"prepare", record.timings.prepare}, {"run", record.timings.run}}},
      {"outputs", record.outputs},
      {"output_sha256", Json::object()},
      {"steps", steps_json(record.steps, record.units)}};
  for (const auto& [name, checksum] : record.checksums) json["output_sha256"][name] = checksum;
  if (!record.values.empty()) json["values"] = values_json(record.values);
  json["is_static"] = record.is_static;
  json["is_of_motion"] = !prepared.scene.is_untouched;
  const auto put_numbers = [&](const char* key, const std::vector<int>& numbers) {
    if (!numbers.empty()) json[key] = Json::array();
    for (const int number : numbers) json[key].push_back(number + 1);
  };
  put_numbers("left_out", record.left_out);
  json["held"] = Json::array();
  put_numbers("held", record.held);
  if (!record.names.rocks.empty()) json["names"]["materials"] = record.names.rocks;
  if (!record.names.joints.empty()) json["names"]["joints"] = record.names.joints;
  json["supports"] = Json::array();
  for (const SupportRecord& support : record.supports) {
    Json row{{"kind", support.kind}, {"x", support.at.x}, {"y", support.at.y}, {"block", support.block}};
    if (support.direction != Point{}) row["direction"] = {support.direction.x, support.direction.y};
    json["supports"].push_back(std::move(row));
  }
  if (record.units != Units{}) json["units"] = units_json(record.units);
  if (record.outcome.forces) json["forces"] = json_of(*record.outcome.forces);
  if (record.plastic) json["plastic"] = json_of(*record.plastic);
  if (!record.reactions.empty()) {
    json["reactions"] = Json::array();
    for (const ReactionCurve& curve : record.reactions) json["reactions"].push_back(json_of(curve));
  }
  if (!record.outcome.scenes.empty()) json["stages"] = stages_json(record.outcome.scenes);
  if (record.equilibrium_way) json["equilibrium"] = json_of(*record.equilibrium_way);
  const Ledger ledger{record.outcome.ledger_scope, record.ledger.rows()};
  if (!ledger.rows.empty())
    json["ledger"] = ledger_json(ledger, record.ledger_sums, record.ledger.stride(), record.units);
  if (record.units != Units{}) json["unit_of"] = units_of_numbers(json, record.units);
  return json;
}

}  // namespace keyblock
