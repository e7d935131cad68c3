// Computes factor of safety and stress intensity factors, as `keyblock fos` and `keyblock sif` do.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <keyblock/studies.hpp>
#include <numbers>

#include "library/parts.hpp"
#include "study/fracture/intensity.hpp"
#include "study/strength/strength_plan.hpp"
#include "study/sweep/sweep_design.hpp"

namespace keyblock::api {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

Tip tip_of(const study::TipAtEnd& at_end) {
  const TipReport& report = at_end.report;
  Tip tip;
  tip.x = report.tip.at.x;
  tip.y = report.tip.at.y;
  tip.ahead_x = report.tip.ahead.x;
  tip.ahead_y = report.tip.ahead.y;
  if (report.factors) {
    tip.k1 = report.factors->k.mode_1;
    tip.k2 = report.factors->k.mode_2;
    tip.j = report.factors->j;
  }
  tip.kink_deg = kDegrees * at_end.kink.angle;
  tip.k_equivalent = at_end.kink.equivalent;
  tip.spread = report.spread_1;
  tip.doubt = study::doubt_of(at_end);
  return tip;
}

/// Returns a state of a trial, without contacts.
Frame frame_of(const keyblock::Frame& frame, const FieldFrame& within, const Units& units) {
  const auto none = std::make_shared<Contacts>([] { return ContactFrames(); });
  return Frame(std::make_shared<const Frame::Data>(Frame::Data{formats::columns_of(frame, {}, within), none, units}));
}

}  // namespace

inline namespace v1 {

Strength factor_of_safety(const Case& of, std::string_view what, double within, const Choices& choices,
                          const Context& context) {
  return guarded([&] {
    const Under under(context.state().context);
    ReductionAsked given;
    if (!what.empty()) given.what = reduced_of(std::string(what));
    if (!(within >= 0))
      throw Error(fmt::format("within: expected a width above 0, or 0, found {}", within), ErrorCode::choice);
    if (within > 0) given.within = within;
    const formats::Case& input = of.data().open.input;
    const study::StrengthPlan plan = study::strength_plan(asked_under(of, choices), input, given);
    if (!plan.refusal.empty()) throw Error(plan.refusal);
    const study::FactorOfSafety found = study::factor_of_safety(plan);
    context.state().context.tell(nullptr, 0);
    const ChosenProfile& profile = plan.trials.made().profile;
    Strength strength;
    strength.stands = found.bracket.stands;
    strength.falls = found.bracket.falls;
    strength.profile = profile.name;
    strength.why_profile = profile.why;
    strength.settings = public_settings(plan.trials.prepared());
    strength.unknowns = plan.trials.prepared().requirements.unknowns;
    strength.end = study::name_of(found.end);
    strength.notes = found.notes;
    strength.warnings = public_warnings(plan.warnings);
    for (const study::StrengthTrial& trial : found.trials)
      strength.trials.push_back({trial.factor, study::name_of(trial.verdict), trial.why, trial.displacement});
    const Units& units = input.problem.units;
    if (found.standing) strength.standing = frame_of(found.standing->frame, found.standing->field, units);
    if (found.falling && found.falling_frame) strength.falling = frame_of(*found.falling_frame, *found.falling, units);
    return strength;
  });
}

Intensity stress_intensity(const Case& of, const Choices& choices, const Context& context) {
  return guarded([&] {
    const Under under(context.state().context);
    study::IntensityPlan plan = study::intensity_plan(asked_under(of, choices), of.data().open.input);
    const ChosenProfile& profile = plan.made.profile;
    Intensity all{{},
                  profile.name,
                  profile.why,
                  public_settings(plan.prepared),
                  plan.prepared.requirements.unknowns,
                  public_warnings(plan.warnings)};
    const study::CaseIntensity found = study::intensity_at_end(std::move(plan));
    if (!found.failure.empty()) throw Error(found.failure);
    context.state().context.tell(nullptr, 0);
    for (const study::TipAtEnd& tip : found.tips) all.tips.push_back(tip_of(tip));
    return all;
  });
}

std::string random_rows(const std::vector<std::string>& keys, std::size_t count, std::uint64_t seed) {
  return guarded([&] {
    std::vector<study::VariedKey> varied;
    for (const std::string& key : keys) varied.push_back(study::varied_key_of(key));
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (study::SweepRow& row : study::sweep_rows(varied, {study::Design::random, count, seed}))
      rows.push_back(std::move(row));
    return rows.dump();
  });
}

}  // namespace v1
}  // namespace keyblock::api
