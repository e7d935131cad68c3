// Writes the table of steps from one list of named columns.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/step_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <variant>

#include "formats/tables/run_tables.hpp"
#include "formats/text/numbers.hpp"

namespace keyblock {
namespace {

using Number = std::variant<int, double>;

struct Column {
  const char* name;
  Number (*value)(const StepReport&);
};

const std::vector<Column> kColumns{
    {"step", [](const StepReport& s) -> Number { return s.step; }},
    {"time", [](const StepReport& s) -> Number { return s.time; }},
    {"dt", [](const StepReport& s) -> Number { return s.dt; }},
    {"passes", [](const StepReport& s) -> Number { return s.passes; }},
    {"redos", [](const StepReport& s) -> Number { return s.redos; }},
    {"fallbacks", [](const StepReport& s) -> Number { return s.fallbacks; }},
    {"contacts", [](const StepReport& s) -> Number { return s.contacts; }},
    {"closed", [](const StepReport& s) -> Number { return s.closed; }},
    {"penalty", [](const StepReport& s) -> Number { return s.penalty; }},
    {"greatest_penetration", [](const StepReport& s) -> Number { return s.greatest_penetration; }},
    {"displacement_ratio", [](const StepReport& s) -> Number { return s.displacement_ratio; }},
    {"residual", [](const StepReport& s) -> Number { return s.residual; }},
    {"unsettled_contacts", [](const StepReport& s) -> Number { return s.unsettled_contacts; }}};
const Column kParts{"parts", [](const StepReport& s) -> Number { return s.parts; }};

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
      const Number number = column.value(row);
      if (const int* count = std::get_if<int>(&number))
        text += std::to_string(*count);
      else
        formats::append_real(text, std::get<double>(number));
      text += ',';
    }
    text.back() = '\n';
  }
  return text;
}

}  // namespace keyblock
