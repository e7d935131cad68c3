// `keyblock sif`: computes stress intensity factors and J of every crack tip of a case, for every choice of domain.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "api/plan.hpp"
#include "app/command.hpp"
#include "app/input/case_options.hpp"
#include "app/messages.hpp"
#include "job/recorded_run.hpp"
#include "job/run_report.hpp"
#include "problem/units/measure.hpp"
#include "study/fracture/intensity.hpp"

namespace keyblock {
namespace {

struct SifOptions {
  CaseOptions given;
  bool as_json = false;
  bool plan_only = false;
};

constexpr double kDegrees = 180 / std::numbers::pi;

nlohmann::ordered_json json_of(const TipFactors& f) {
  return {{"K_I", f.k.mode_1}, {"K_II", f.k.mode_2}, {"J", f.j}, {"closed", f.is_closed}};
}

nlohmann::ordered_json json_of(const study::TipAtEnd& tip) {
  const TipReport& report = tip.report;
  nlohmann::ordered_json json{{"at", {report.tip.at.x, report.tip.at.y}},
                              {"ahead", {report.tip.ahead.x, report.tip.ahead.y}},
                              {"side", report.side},
                              {"room", report.tip.room},
                              {"nearest", report.tip.nearest}};
  if (report.factors) {
    json.update(json_of(*report.factors));
    json["spread_K_I"] = report.spread_1;
    json["spread_K_II"] = report.spread_2;
    json["kink_deg"] = tip.kink.angle * kDegrees;
    json["K_eq"] = tip.kink.equivalent;
  }
  if (tip.toughness) json["toughness"] = *tip.toughness;
  if (study::has_both(tip)) {
    json["other_treatment"] = json_of(*tip.other->factors);
    json["other_treatment"]["side"] = tip.other->side;
    json["other_treatment"]["difference_K_I"] = study::difference(tip).mode_1;
    json["other_treatment"]["difference_K_II"] = study::difference(tip).mode_2;
  }
  json["doubt"] = study::doubt_of(tip);
  json["domains"] = nlohmann::ordered_json::array();
  for (const DomainResult& domain : report.domains) {
    nlohmann::ordered_json row{{"domain", name_of(domain.choice)}};
    if (domain.factors)
      row.update(json_of(*domain.factors));
    else
      row["refused"] = domain.refusal;
    json["domains"].push_back(std::move(row));
  }
  return json;
}

/// Prints both treatments, that of the case first.
void print_treatments(const study::TipAtEnd& tip, const study::CaseIntensity& found) {
  const auto row = [&](bool has_functions, int unknowns, double side, const TipFactors& f) {
    fmt::print("  {:22} {:8} {:11.3g} {:13.6g} {:13.6g} {:13.6g}\n",
               has_functions ? "near-tip functions" : "without functions", unknowns, side, f.k.mode_1, f.k.mode_2, f.j);
  };
  fmt::print("  {:22} {:>8} {:>11} {:>13} {:>13} {:>13}\n", "treatment of the tip", "unknowns", "sides there", "K_I",
             "K_II", "J");
  row(found.has_functions, found.unknowns, tip.report.side, *tip.report.factors);
  row(!found.has_functions, found.other_unknowns, tip.other->side, *tip.other->factors);
  const StressIntensity d = study::difference(tip);
  fmt::print("  {:43} {:11.3f} % {:11.3f} % of K\n", "difference", 100 * d.mode_1, 100 * d.mode_2);
}

void print(const study::TipAtEnd& tip, std::size_t number, const study::CaseIntensity& found, const Units& units) {
  const TipReport& report = tip.report;
  fmt::print("tip {} at ({:.6g}, {:.6g}), ahead ({:.4f}, {:.4f}); sides of {:.3g} there, {} {:.4g} away\n", number,
             report.tip.at.x, report.tip.at.y, report.tip.ahead.x, report.tip.ahead.y, report.side, report.tip.nearest,
             report.tip.room);
  fmt::print("  {:34} {:>13} {:>13} {:>13} {:>13}\n", "domain", "K_I", "K_II", "J", "(K²)/E'");
  for (const DomainResult& domain : report.domains) {
    if (!domain.factors) {
      fmt::print("  {:34} refused: {}\n", name_of(domain.choice), domain.refusal);
      continue;
    }
    const StressIntensity& k = domain.factors->k;
    fmt::print("  {:34} {:13.6g} {:13.6g} {:13.6g} {:13.6g}\n", name_of(domain.choice), k.mode_1, k.mode_2,
               domain.factors->j, energy_release(report.rock, k));
  }
  if (!report.factors) return;
  fmt::print("  K_I {:.6g}, K_II {:.6g} [{}], J {:.6g} [{}]; {}circles differ by {:.2f} % and {:.2f} % of K\n",
             report.factors->k.mode_1, report.factors->k.mode_2, unit_of(measures::kToughness, units),
             report.factors->j, unit_of(measures::kEnergyPerArea, units),
             report.factors->is_closed ? "its faces are pressed together; " : "", 100 * report.spread_1,
             100 * report.spread_2);
  if (study::has_both(tip)) print_treatments(tip, found);
  fmt::print("  would go on by {:.2f} degrees, K_eq {:.6g}", tip.kink.angle * kDegrees, tip.kink.equivalent);
  if (tip.toughness)
    fmt::print(", {:.4g} of the toughness {:.6g}", tip.kink.equivalent / *tip.toughness, *tip.toughness);
  fmt::print("\n");
}

void add_to(nlohmann::ordered_json& json, const study::CaseIntensity& found) {
  json["time"] = found.time;
  json["in_motion"] = found.is_in_motion;
  json["tip_functions"] = found.has_functions;
  json["tips"] = nlohmann::ordered_json::array();
  for (const study::TipAtEnd& tip : found.tips) json["tips"].push_back(json_of(tip));
  if (found.no_other.empty())
    json["other_treatment_unknowns"] = found.other_unknowns;
  else
    json["no_other_treatment"] = found.no_other;
}

void print(const study::CaseIntensity& found, const Units& units) {
  fmt::print("{} unknowns, {}\n", found.unknowns,
             found.is_in_motion ? fmt::format("in motion at time {:g}", found.time) : "at rest");
  for (std::size_t i = 0; i < found.tips.size(); ++i) print(found.tips[i], i + 1, found, units);
  if (!found.no_other.empty()) fmt::print("no other treatment of tips: {}\n", found.no_other);
}

/// Warns of factors that are unreliable; returns true if none is.
bool are_sure(const std::vector<study::TipAtEnd>& tips) {
  bool are_all = true;
  for (std::size_t i = 0; i < tips.size(); ++i) {
    const std::string doubt = doubt_of(tips[i]);
    if (doubt.empty()) continue;
    are_all = false;
    spdlog::warn("tip {}: {}", i + 1, doubt);
  }
  return are_all;
}

ExitCode print_intensity(const SifOptions& options) {
  const OpenCase open = opened(case_of(options.given));
  study::IntensityPlan plan = study::intensity_plan(open, open.input);
  log_by_level(plan.warnings, "the case");
  nlohmann::ordered_json json = plan_json(open.name, plan.made.profile, plan.prepared);
  json.update(origin_json(open.input.problem.units, open.read_files(), plan.made));
  json["warnings"] = warning_list_json(plan.warnings);
  if (options.plan_only) {
    fmt::print("{}\n", json.dump(2));
    return ExitCode::ok;
  }
  const study::CaseIntensity found = study::intensity_at_end(std::move(plan));
  if (!found.failure.empty()) {
    spdlog::error("keyblock: error: {}", found.failure);
    return ExitCode::numerical_failure;
  }
  const bool is_sure = are_sure(found.tips);
  add_to(json, found);
  if (options.as_json)
    fmt::print("{}\n", json.dump(2));
  else
    print(found, open.input.problem.units);
  return is_sure ? ExitCode::ok : ExitCode::check_failed;
}

}  // namespace

Action configure_sif(CLI::App& app) {
  const auto options = std::make_shared<SifOptions>();
  add_case_options(app, options->given, "one case folder, or the files of a case").files->required();
  app.add_flag("--json", options->as_json, "print JSON instead of the table");
  app.add_flag("--plan", options->plan_only, "print profile, settings and unknowns as JSON, and make no run");
  return [options] { return print_intensity(*options); };
}

}  // namespace keyblock
