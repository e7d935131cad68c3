// Writes the tables of `keyblock compare`.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/compare_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "study/cases/quantities.hpp"

namespace keyblock {
namespace {

constexpr std::size_t kWidth = 160;  // a wide terminal

using study::CaseComparison;
using study::ComparedCase;
using study::ComparedValue;
using study::TraceDifference;

std::string name_of(const ComparedValue& value) {
  if (!value.block) return value.quantity;
  const std::optional<study::Owner> owner = study::owner_of(value.quantity);
  const char* noun = owner == study::Owner::point     ? "point"
                     : owner == study::Owner::support ? "support"
                     : owner == study::Owner::tip     ? "tip"
                                                      : "block";
  return fmt::format("{} of {} {}", value.quantity, noun, *value.block);
}

std::string computed_of(const ComparedCase& run, const ComparedValue& value) {
  if (value.computed) return fmt::format("{:.9g}", *value.computed);
  return run.not_run.empty() ? "not reached" : "not run";
}

std::string error_of(const ComparedValue& value) {
  return value.computed ? fmt::format("{:.2e}", value.error()) : "-";
}

// Returns one word if both profiles are judged and hold; otherwise the judged profiles, or those that miss.
std::string verdict_of(const std::vector<ComparedCase>& runs, std::size_t row) {
  std::vector<std::string> judged;
  std::vector<std::string> missed;
  for (const ComparedCase& run : runs) {
    if (run.values[row].is_judged) judged.push_back(run.profile);
    if (run.values[row].is_missed()) missed.push_back(run.profile);
  }
  if (judged.empty()) return "not judged";
  const bool is_listed = !runs.front().values[row].listed_miss.empty();
  if (!missed.empty())
    return fmt::format("{}: {}", is_listed ? "HOLDS BUT IS LISTED" : "MISSED", fmt::join(missed, ", "));
  if (is_listed) return fmt::format("listed miss: {}", fmt::join(judged, ", "));
  return judged.size() == runs.size() ? "ok" : fmt::format("ok: {} only", fmt::join(judged, ", "));
}

// Breaks the text at spaces, so that no line is wider than the table; later lines are aligned with its text.
std::string wrapped(const std::string& label, const std::string& text) {
  std::string result;
  std::string line = label;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (line.size() + 1 + word.size() > kWidth) {
      result += line + "\n";
      line = std::string(label.size(), ' ');
    }
    line += " " + word;
    begin = end + 1;
  }
  return result + line + "\n";
}

std::string heading(const CaseComparison& comparison) {
  std::string text = fmt::format("\n{}\n", comparison.name);
  if (!comparison.about.empty()) text += wrapped(" ", comparison.about);
  for (const ComparedCase& run : comparison.plain) {
    if (!run.not_run.empty()) text += wrapped(fmt::format("  {}: not run:", run.profile), run.not_run);
    if (run.outcome.end != RunEnd::finished)
      text += wrapped(fmt::format("  {}: ended early, after {} steps at time {:.6g}:", run.profile, run.outcome.steps,
                                  run.outcome.time),
                      run.outcome.reason);
  }
  return text;
}

std::string column_heads(const CaseComparison& comparison) {
  std::string text = fmt::format("  {:26} {:>7} {:>16}", "quantity", "time", "expected");
  for (const ComparedCase& run : comparison.plain) text += fmt::format(" {:>16}", run.profile);
  for (const ComparedCase& run : comparison.plain) text += fmt::format(" {:>14}", "error " + run.profile);
  return text + fmt::format(" {:>9}  {:6} {}\n", "tolerance", "source", "verdict");
}

std::string value_line(const CaseComparison& comparison, std::size_t row, std::size_t source) {
  const ComparedValue& v = comparison.plain.front().values[row];
  std::string text = fmt::format("  {:26} {:>7.6g} {:>16.9g}", name_of(v), v.time, v.expected);
  for (const ComparedCase& run : comparison.plain) text += fmt::format(" {:>16}", computed_of(run, run.values[row]));
  for (const ComparedCase& run : comparison.plain) text += fmt::format(" {:>14}", error_of(run.values[row]));
  return text + fmt::format(" {:>9.1e}  {:6} {}\n", v.tolerance, fmt::format("[{}]", source),
                            verdict_of(comparison.plain, row));
}

// Returns the error in units of the tolerance; infinite if the value is missing or not a number.
double strain_on(const ComparedValue& value) {
  if (!value.computed || std::isnan(value.error())) return std::numeric_limits<double>::infinity();
  return value.error() == 0 ? 0 : std::abs(value.error()) / value.tolerance;
}

std::string variant_line(const ComparedCase& run) {
  const std::string name = fmt::format("variant {} ({})", run.variant, run.profile);
  const bool is_listed = std::ranges::any_of(run.values, &ComparedValue::is_listed_miss);
  const std::string verdict = !run.holds() ? "MISSED" : is_listed ? "listed miss" : "ok";
  if (!run.not_run.empty()) return wrapped(fmt::format("  {:56} {}, not run:", name, verdict), run.not_run);
  const ComparedValue* worst = nullptr;
  for (const ComparedValue& v : run.values)
    if (v.is_judged && (worst == nullptr || strain_on(v) > strain_on(*worst))) worst = &v;
  if (worst == nullptr) return fmt::format("  {:56} nothing judged\n", name);
  std::string text = fmt::format("  {:56} worst error {:>9} of {:.1e} ({} at {:.6g})  {}\n", name, error_of(*worst),
                                 worst->tolerance, name_of(*worst), worst->time, verdict);
  if (run.outcome.end != RunEnd::finished) text += wrapped("    ended early:", run.outcome.reason);
  return text;
}

/// Returns the distinct texts, in the order of the values.
std::vector<std::string> texts_of(const std::vector<ComparedValue>& values, std::string ComparedValue::*text) {
  std::vector<std::string> texts;
  for (const ComparedValue& v : values)
    if (std::ranges::find(texts, v.*text) == texts.end()) texts.push_back(v.*text);
  return texts;
}

}  // namespace

std::string table_of(const CaseComparison& comparison, Detail detail) {
  const std::vector<ComparedValue>& values = comparison.plain.front().values;
  const std::vector<std::string> sources = texts_of(values, &ComparedValue::source);
  std::string text = heading(comparison) + column_heads(comparison);
  for (std::size_t row = 0; row < values.size(); ++row) {
    const auto source = std::ranges::find(sources, values[row].source) - sources.begin();
    text += value_line(comparison, row, static_cast<std::size_t>(source) + 1);
  }
  for (const ComparedCase& run : comparison.variants) text += variant_line(run);
  for (std::size_t i = 0; i < sources.size(); ++i) text += wrapped(fmt::format("  [{}]", i + 1), sources[i]);
  for (const std::string& reason : texts_of(values, &ComparedValue::listed_miss))
    if (!reason.empty()) text += wrapped("  listed miss:", reason);
  if (detail == Detail::brief) return text;
  for (const std::string& reason : texts_of(values, &ComparedValue::tolerance_reason))
    text += wrapped("  tolerance:", reason);
  return text;
}

std::string table_of(const std::vector<TraceDifference>& traces) {
  if (traces.empty()) return {};
  std::string text = fmt::format(
      "\ntraces of the Berkeley program (dt, oci, contacts, closed, penalty equal in every step; others within "
      "{:.0e})\n",
      study::kTraceTolerance);
  text += fmt::format("  {:42} {:>11} {:>8} {:>9} {:>9} {:>9} {:>9} {:>10}\n", "trace", "steps", "equal?", "polygon",
                      "position", "rotation", "stress", "disp_ratio");
  for (const TraceDifference& t : traces) {
    text += fmt::format("  {:42} {:>11} {:>8} {:>9.1e} {:>9.1e} {:>9.1e} {:>9.1e} {:>10.1e}  {}\n", t.name,
                        fmt::format("{}/{}", t.steps, t.steps_in_trace), t.unequal.empty() ? "yes" : "NO", t.polygon,
                        t.position, t.rotation, t.stress, t.disp_ratio, t.holds() ? "ok" : "MISSED");
    for (const std::string& unequal : t.unequal) text += fmt::format("    {}\n", unequal);
  }
  return text;
}

}  // namespace keyblock
