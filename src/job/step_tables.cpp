// Writes the table of steps from one list of named columns.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/step_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "formats/tables/run_tables.hpp"
#include "formats/text/numbers.hpp"

namespace keyblock {
namespace {

struct Column {
  const char* name;
  double (*value)(const StepReport&);
};

const std::vector<Column> kColumns{
    {"step", [](const StepReport& s) { return double(s.step); }},
    {"time", [](const StepReport& s) { return s.time; }},
    {"dt", [](const StepReport& s) { return s.dt; }},
    {"passes", [](const StepReport& s) { return double(s.passes); }},
    {"redos", [](const StepReport& s) { return double(s.redos); }},
    {"fallbacks", [](const StepReport& s) { return double(s.fallbacks); }},
    {"contacts", [](const StepReport& s) { return double(s.contacts); }},
    {"closed", [](const StepReport& s) { return double(s.closed); }},
    {"penalty", [](const StepReport& s) { return s.penalty; }},
    {"greatest_penetration", [](const StepReport& s) { return s.greatest_penetration; }},
    {"displacement_ratio", [](const StepReport& s) { return s.displacement_ratio; }},
    {"residual", [](const StepReport& s) { return s.residual; }},
    {"unsettled_contacts", [](const StepReport& s) { return double(s.unsettled_contacts); }}};
const Column kParts{"parts", [](const StepReport& s) { return double(s.parts); }};

std::vector<Column> columns_of(const std::vector<StepReport>& rows) {
  std::vector<Column> columns = kColumns;
  if (std::ranges::any_of(rows, [](const StepReport& s) { return !s.residuals.empty(); })) columns.push_back(kParts);
  return columns;
}

}  // namespace

std::vector<std::string> step_columns(const std::vector<StepReport>& rows, const Units& units) {
  std::vector<std::string> names;
  for (const Column& column : columns_of(rows))
    names.push_back(formats::heading(formats::kStepTable, column.name, units));
  return names;
}

std::string step_table_csv(const std::vector<StepReport>& rows, const Units& units) {
  std::string text = fmt::format("{}\n", fmt::join(step_columns(rows, units), ","));
  const std::vector<Column> columns = columns_of(rows);
  for (const StepReport& row : rows) {
    for (const Column& column : columns) {
      formats::append_real(text, column.value(row));
      text += ',';
    }
    text.back() = '\n';
  }
  return text;
}

}  // namespace keyblock
