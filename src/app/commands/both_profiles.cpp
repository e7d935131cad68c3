// Builds the rows of the table, and names causes of differences that the records show.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/both_profiles.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/printable.hpp"
#include "problem/units/measure.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kSame = 0.01;       // of the largest of its kind
constexpr double kRoundOff = 1e-12;  // of the size of the scene, or as a strain
constexpr double kMuchDeeper = 10;   // times the other overlap: reported
constexpr int kColumnWidth = 28;

const char* word_for(const ProfileAnswer& answer) {
  if (!answer.refused.empty()) return "not run";
  switch (answer.record.outcome.end) {
    case RunEnd::finished:
      return answer.record.doubts.empty() ? "finished" : "finished, unreliable";
    case RunEnd::failed:
      return "failed";
    case RunEnd::stopped:
      return "stopped";
  }
  return "";
}

bool has_run(const ProfileAnswer& answer) {
  return answer.refused.empty();
}

// A run that failed in its first step has no values for a comparison.
bool has_values(const ProfileAnswer& answer) {
  return has_run(answer) && answer.record.outcome.steps > 0;
}

bool is_static(const Settings& settings) {
  return settings.dynamics == Dynamics::standard && settings.standard.motion != MotionRule::dynamic;
}

// Returns true if every step starts from zero velocity.
bool creeps(const Settings& settings) {
  return !is_static(settings) && settings.velocity_carry_over.common == 0;
}

/// Quantity of both runs, and the size below which it is ignored.
struct Pair {
  const char* what;
  double one;
  double other;
  double largest;  ///< of its kind, in either run
  double round_off;

  bool differs() const { return std::abs(one - other) > std::max(kSame * largest, round_off); }
};

std::vector<Pair> extremes_of(const ProfileAnswer& one, const ProfileAnswer& other) {
  const Extremes& a = one.record.extremes;
  const Extremes& b = other.record.extremes;
  const double moved = std::max(a.displacement, b.displacement);
  const double stress = std::max(
      {std::abs(a.least_stress), std::abs(a.greatest_stress), std::abs(b.least_stress), std::abs(b.greatest_stress)});
  const double length = kRoundOff * std::max(one.length, other.length);
  const double pressure = kRoundOff * std::max(one.modulus, other.modulus);
  return {{"largest displacement", a.displacement, b.displacement, moved, length},
          {"least principal stress", a.least_stress, b.least_stress, stress, pressure},
          {"greatest principal stress", a.greatest_stress, b.greatest_stress, stress, pressure}};
}

std::string value_of_block(double value, int element) {
  return fmt::format("{:.5g} (block {})", value, element + 1);
}

struct Row {
  std::string name;
  std::string one;
  std::string other;
};

std::vector<Row> rows_of(const ProfileAnswer& one, const ProfileAnswer& other, const Units& units) {
  const auto row = [&](std::string name, auto value_of) {
    return Row{std::move(name), has_run(one) ? value_of(one) : "-", has_run(other) ? value_of(other) : "-"};
  };
  const auto value = [&](std::string name, auto value_of) {
    return Row{std::move(name), has_values(one) ? value_of(one) : "-", has_values(other) ? value_of(other) : "-"};
  };
  return {
      {"end", word_for(one), word_for(other)},
      row("blocks", [](const ProfileAnswer& a) { return fmt::format("{}", a.blocks); }),
      row("steps", [](const ProfileAnswer& a) { return fmt::format("{}", a.record.outcome.steps); }),
      row(with_declared("end time", measures::kTime, units),
          [](const ProfileAnswer& a) { return fmt::format("{:.6g}", a.record.outcome.time); }),
      value(with_declared("largest displacement", measures::kLength, units),
            [](const ProfileAnswer& a) {
              return value_of_block(a.record.extremes.displacement, a.record.extremes.displaced_element);
            }),
      value(with_declared("least principal stress", measures::kStress, units),
            [](const ProfileAnswer& a) {
              return value_of_block(a.record.extremes.least_stress, a.record.extremes.compressed_element);
            }),
      value(with_declared("greatest principal stress", measures::kStress, units),
            [](const ProfileAnswer& a) {
              return value_of_block(a.record.extremes.greatest_stress, a.record.extremes.stretched_element);
            }),
      value(with_declared("deepest overlap", measures::kLength, units),
            [](const ProfileAnswer& a) { return fmt::format("{:.3g}", a.record.totals.greatest_penetration); }),
      row("exit code", [](const ProfileAnswer& a) { return fmt::format("{}", static_cast<int>(a.code)); }),
      {"results", one.folder, other.folder},
  };
}

std::set<std::string> warned_of(const RunRecord& record) {
  std::set<std::string> names;
  for (const Warning& warning : record.warnings) names.insert(warning.name);
  return names;
}

std::string reason_of_end(const ProfileAnswer& answer) {
  if (!has_run(answer)) return fmt::format("{} was not run: {}", answer.profile, answer.refused);
  if (answer.record.outcome.end == RunEnd::failed)
    return fmt::format("{} failed: {}", answer.profile, answer.record.outcome.reason);
  if (!answer.record.doubts.empty())
    return fmt::format("{} is unreliable: {}", answer.profile, answer.record.doubts.front().sentence);
  return {};
}

// Warnings of one profile that the other does not give.
std::string warned_alone(const ProfileAnswer& one, const ProfileAnswer& other) {
  const std::set<std::string> known = warned_of(other.record);
  std::vector<std::string> alone;
  for (const std::string& name : warned_of(one.record))
    if (!known.contains(name)) alone.push_back(name);
  return alone.empty() ? std::string() : fmt::format("only {} warns: {}", one.profile, fmt::join(alone, ", "));
}

std::string of_statics(const ProfileAnswer& one, const ProfileAnswer& other) {
  if (!creeps(one.settings) || !is_static(other.settings)) return {};
  return fmt::format(
      "the case is static: {} starts each of {} steps at zero velocity, {} computes the equilibrium directly",
      one.profile, one.record.outcome.steps, other.profile);
}

std::string of_depth(const ProfileAnswer& one, const ProfileAnswer& other) {
  const double depth = one.record.totals.greatest_penetration;
  const double less = other.record.totals.greatest_penetration;
  if (!(depth > kMuchDeeper * less) || !warned_of(one.record).contains("deep_penetration")) return {};
  return fmt::format("deepest overlap {:.3g} under {}, {:.3g} under {}", depth, one.profile, less, other.profile);
}

std::string of_steps(const ProfileAnswer& one, const ProfileAnswer&) {
  if (!warned_of(one.record).contains("step_cut")) return {};
  return fmt::format("{0} cut its steps from {2:.3g} down to {1:.3g}, so that the same number of steps ends earlier",
                     one.profile, one.record.totals.least_dt, one.settings.time_step);
}

void put(std::vector<std::string>& sentences, std::string sentence) {
  if (!sentence.empty()) sentences.push_back(std::move(sentence));
}

Json json_of(const ProfileAnswer& answer) {
  Json json = {{"profile", answer.profile}, {"end", word_for(answer)}, {"folder", answer.folder}};
  if (!has_run(answer)) {
    json["reason"] = answer.refused;
    return json;
  }
  const Extremes& found = answer.record.extremes;
  json["exit_code"] = static_cast<int>(answer.code);
  json["blocks"] = answer.blocks;
  json["steps"] = answer.record.outcome.steps;
  json["time"] = answer.record.outcome.time;
  json["reason"] = answer.record.outcome.reason;
  json["greatest_displacement"] = {{"value", found.displacement}, {"element", found.displaced_element + 1}};
  json["least_principal_stress"] = {{"value", found.least_stress}, {"element", found.compressed_element + 1}};
  json["greatest_principal_stress"] = {{"value", found.greatest_stress}, {"element", found.stretched_element + 1}};
  json["greatest_penetration"] = answer.record.totals.greatest_penetration;
  return json;
}

}  // namespace

std::vector<std::string> differences(const ProfileAnswer& one, const ProfileAnswer& other) {
  if (!has_run(one) || !has_run(other)) return {"only one profile was run"};
  std::vector<std::string> found;
  if (std::string_view(word_for(one)) != word_for(other))
    found.push_back(fmt::format("end: {} and {}", word_for(one), word_for(other)));
  if (one.blocks != other.blocks) found.push_back(fmt::format("blocks: {} and {}", one.blocks, other.blocks));
  const double end = one.record.outcome.time;
  const double other_end = other.record.outcome.time;
  const bool ends_apart = Pair{"end time", end, other_end, std::max(end, other_end), 0}.differs();
  if (ends_apart) found.push_back(fmt::format("end time: {:.5g} and {:.5g}", end, other_end));
  if (!has_values(one) || !has_values(other)) return found;
  for (const Pair& pair : extremes_of(one, other)) {
    if (!pair.differs()) continue;
    if (ends_apart)
      found.push_back(fmt::format("{}: {:.5g} at time {:.5g} and {:.5g} at time {:.5g}, not comparable", pair.what,
                                  pair.one, end, pair.other, other_end));
    else
      found.push_back(fmt::format("{}: {:.5g} and {:.5g}, by {:.3g} % of the largest", pair.what, pair.one, pair.other,
                                  100 * std::abs(pair.one - pair.other) / pair.largest));
  }
  return found;
}

std::vector<std::string> reasons(const ProfileAnswer& one, const ProfileAnswer& other) {
  std::vector<std::string> found;
  for (const ProfileAnswer* answer : {&one, &other}) put(found, reason_of_end(*answer));
  if (!has_run(one) || !has_run(other)) return found;
  if (one.blocks != other.blocks)
    found.emplace_back("the profiles cut the drawing by different rules (settings node_merging and near_pieces)");
  for (const auto& why : {of_statics, of_steps, of_depth, warned_alone}) {
    put(found, why(one, other));
    put(found, why(other, one));
  }
  return found;
}

std::string side_by_side(const ProfileAnswer& one, const ProfileAnswer& other, const Units& units) {
  std::string text = fmt::format("{:{}} {:{}} {}\n", "", kColumnWidth, one.profile, kColumnWidth, other.profile);
  for (const Row& row : rows_of(one, other, units))
    text +=
        fmt::format("{:{}} {:{}} {}\n", row.name, kColumnWidth, printable(row.one), kColumnWidth, printable(row.other));
  const std::vector<std::string> found = differences(one, other);
  if (found.empty()) return text + "no difference above 1 %\n";
  for (const std::string& sentence : found) text += fmt::format("differs  {}\n", printable(sentence));
  for (const std::string& sentence : reasons(one, other)) text += fmt::format("because  {}\n", printable(sentence));
  return text;
}

Json side_by_side_json(const ProfileAnswer& one, const ProfileAnswer& other) {
  return {{"profiles", {json_of(one), json_of(other)}},
          {"differences", differences(one, other)},
          {"reasons", reasons(one, other)}};
}

ExitCode code_of_both(const ProfileAnswer& one, const ProfileAnswer& other) {
  if (one.code != ExitCode::ok) return one.code;
  return other.code == ExitCode::ok ? ExitCode::ok : ExitCode::check_failed;
}

}  // namespace keyblock
