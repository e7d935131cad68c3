// Writes rows cell by cell; reads in one pass over the characters.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "formats/tables/run_tables.hpp"
#include "formats/text/numbers.hpp"
#include "formats/text/tokens.hpp"
#include "material/stress_invariants.hpp"

namespace keyblock::formats {
namespace {

void append_row(std::string& text, std::initializer_list<double> values) {
  for (double value : values) {
    text += ',';
    text += format_real(value);
  }
}

/// Splits a table into rows, one at a time.
class CsvScanner {
 public:
  explicit CsvScanner(const Source& source) : source_(source), text_(source.text) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
    line_start_ = text_.data();
  }

  /// Returns the next row that is not an empty line; a row without cells at the end of the text. LF, CRLF and a lone CR
  /// end a line.
  CsvRow next_row() {
    while (skip_line_end()) {
    }
    CsvRow row{{}, line_, {}, 0};
    if (text_.empty()) return row;
    do {
      row.columns.push_back(column());
      row.cells.push_back(next_cell());
    } while (skip(','));
    row.end = column();
    if (!text_.empty() && !skip_line_end())
      throw InputError({source_.name, line_, column()},
                       "expected a comma or the end of the line after a closing quote");
    return row;
  }

 private:
  int column() const { return static_cast<int>(text_.data() - line_start_) + 1; }

  bool skip(char c) {
    if (!text_.starts_with(c)) return false;
    text_.remove_prefix(1);
    return true;
  }

  bool skip_line_end() {
    const bool carriage_return = skip('\r');
    if (!skip('\n') && !carriage_return) return false;
    begin_line();
    return true;
  }

  void begin_line() {
    ++line_;
    line_start_ = text_.data();
  }

  std::string next_cell() {
    if (skip('"')) return quoted_cell();
    const std::size_t end = std::min(text_.find_first_of(",\n\r"), text_.size());
    std::string cell(text_.substr(0, end));
    text_.remove_prefix(end);
    return cell;
  }

  std::string quoted_cell() {
    const Place opened{source_.name, line_, column() - 1};
    std::string cell;
    while (!text_.empty()) {
      if (skip('"') && !text_.starts_with('"')) return cell;
      const bool ends_line = text_.starts_with('\n') || (text_.starts_with('\r') && !text_.starts_with("\r\n"));
      cell += text_.front();
      text_.remove_prefix(1);
      if (ends_line) begin_line();
    }
    throw InputError(opened, "expected a closing quote, found the end of the file");
  }

  const Source& source_;
  std::string_view text_;
  const char* line_start_ = nullptr;
  int line_ = 1;
};

// Number of columns at the end of a table that elastoplastic rock adds.
constexpr std::size_t kPlasticColumns = 10;

std::string headings_of(const RunTable& table, bool has_plastic, const Units& units) {
  std::vector<std::string_view> names;
  for (const Column& column : table.columns) names.push_back(column.name);
  if (!has_plastic) names.resize(names.size() - kPlasticColumns);
  return headings(table, names, units) + '\n';
}

void append_plastic(std::string& text, const std::optional<PlasticState>& plastic, const Stress& stress) {
  if (plastic) {
    append_row(text, {plastic->xx, plastic->yy, plastic->xy, plastic->zz, plastic->equivalent});
    text += fmt::format(",{},{:d}", static_cast<int>(plastic->region), plastic->has_yielded);
  } else {
    text += ",,,,,,,";
  }
  const StressInvariants invariants = invariants_of(stress);
  append_row(text, {invariants.mean, invariants.von_mises, invariants.lode_deg});
}

void append_number_or_nothing(std::string& text, std::span<const double> values, std::size_t index) {
  text += ',';
  if (index < values.size() && !std::isnan(values[index])) text += format_real(values[index]);
}

void append_totals(std::string& text, const std::optional<PlasticTotals>& plastic) {
  if (!plastic) {
    text += ",,,";
    return;
  }
  append_row(text, {plastic->yielded_fraction(), plastic->yielding_fraction()});
  text += ',';
  if (plastic->work) text += format_real(*plastic->work);
}

/// Number of columns of each kind in the rows of a history.
struct HistoryColumns {
  std::vector<std::size_t> points;  ///< their indices in a row
  std::size_t bolts = 0;
  std::size_t reactions = 0;
  std::size_t driven = 0;
  bool has_share = false;
  bool has_factor = false;
  bool has_plastic = false;

  HistoryColumns(const History& history, const std::vector<std::size_t>& chosen) : points(chosen) {
    std::size_t most = 0;
    for (const HistoryRow& row : history.rows) {
      most = std::max(most, row.points.size());
      bolts = std::max(bolts, row.bolt_forces.size());
      reactions = std::max(reactions, row.reactions.size());
      driven = std::max(driven, row.driven.size());
      has_share = has_share || row.load_share.has_value();
      has_factor = has_factor || row.load_factor != 1;
      has_plastic = has_plastic || row.plastic.has_value();
    }
    for (std::size_t i = 0; chosen.empty() && i < most; ++i) points.push_back(i);
  }

  std::string header(const Units& units) const {
    std::vector<std::string> names{"step", "time"};
    const auto put_at = [&](std::size_t i, std::initializer_list<const char*> of_each) {
      for (const char* name : of_each) names.push_back(fmt::format(fmt::runtime(name), i + 1));
    };
    const auto put = [&](std::size_t count, std::initializer_list<const char*> of_each) {
      for (std::size_t i = 0; i < count; ++i) put_at(i, of_each);
    };
    for (const std::size_t i : points) put_at(i, {"x{}", "y{}", "dx{}", "dy{}"});
    put(bolts, {"bolt{}"});
    put(reactions, {"reaction{}_x", "reaction{}_y"});
    put(driven, {"driven{}"});
    if (has_share) names.emplace_back("load_share");
    if (has_factor) names.emplace_back("load_factor");
    if (has_plastic) names.insert(names.end(), {"yielded_fraction", "yielding_fraction", "plastic_work"});
    return headings(kHistoryTable, std::vector<std::string_view>(names.begin(), names.end()), units) + '\n';
  }
};

}  // namespace

std::string history_csv(const History& history, const Units& units, const std::vector<std::size_t>& chosen) {
  const HistoryColumns columns(history, chosen);
  std::string text = columns.header(units);
  for (const HistoryRow& row : history.rows) {
    text += fmt::format("{}", row.step);
    append_row(text, {row.time});
    for (const std::size_t i : columns.points) {
      if (i < row.points.size() && is_there(row.points[i]))
        append_row(text, {row.points[i].position.x, row.points[i].position.y, row.points[i].displacement.x,
                          row.points[i].displacement.y});
      else
        text += ",,,,";
    }
    for (std::size_t i = 0; i < columns.bolts; ++i) append_number_or_nothing(text, row.bolt_forces, i);
    for (std::size_t i = 0; i < columns.reactions; ++i) {
      if (i < row.reactions.size())
        append_row(text, {row.reactions[i].x, row.reactions[i].y});
      else
        text += ",,";
    }
    for (std::size_t i = 0; i < columns.driven; ++i) append_number_or_nothing(text, row.driven, i);
    if (columns.has_share) append_row(text, {row.load_share.value_or(0)});
    if (columns.has_factor) append_row(text, {row.load_factor});
    if (columns.has_plastic) append_totals(text, row.plastic);
    text += '\n';
  }
  return text;
}

std::string points_csv(const History& history, const Units& units) {
  const bool has_plastic = HistoryColumns(history, {}).has_plastic;
  std::string text = headings_of(kPointsTable, has_plastic, units);
  for (const HistoryRow& row : history.rows) {
    for (std::size_t i = 0; i < row.points.size(); ++i) {
      const PointFrame& p = row.points[i];
      if (!is_there(p)) continue;
      text += fmt::format("{}", row.step);
      append_row(text, {row.time});
      text += fmt::format(",{}", i + 1);
      append_row(text, {p.position.x, p.position.y, p.displacement.x, p.displacement.y, p.stress.xx, p.stress.yy,
                        p.stress.xy, p.stress.zz});
      if (has_plastic) append_plastic(text, p.plastic, p.stress);
      text += '\n';
    }
  }
  return text;
}

std::string steps_csv(std::span<const StepReport> steps, const Units& units) {
  std::string text = headings(kTraceOfSteps, units) + '\n';
  for (const StepReport& step : steps) {
    text += fmt::format("{}", step.step);
    append_row(text, {step.time, step.dt});
    text += fmt::format(",{},{},{},{}", step.passes, step.contacts, step.closed, step.matrix_blocks);
    append_row(text, {step.penalty, step.displacement_ratio, step.greatest_penetration});
    text += '\n';
  }
  return text;
}

std::string rounds_csv(std::span<const StepReport> steps) {
  std::string text = headings(kTraceOfRounds, {}) + '\n';
  for (const StepReport& step : steps)
    for (std::size_t i = 0; i < step.residuals.size(); ++i) {
      text += fmt::format("{},{}", step.step, i);
      append_row(text, {step.residuals[i]});
      text += '\n';
    }
  return text;
}

std::string blocks_csv(std::span<const Frame> frames, const Units& units) {
  const bool has_plastic = std::ranges::any_of(frames, [](const Frame& frame) { return frame.plastic.has_value(); });
  std::string text = headings_of(kTraceOfBlocks, has_plastic, units);
  for (const Frame& frame : frames) {
    for (std::size_t i = 0; i < frame.elements.size(); ++i) {
      const ElementFrame& block = frame.elements[i];
      text += fmt::format("{}", frame.step);
      append_row(text, {frame.time});
      text += fmt::format(",{},{}", number_of(frame, i) + 1, block.material + 1);
      append_row(text, {block.centroid.x, block.centroid.y, block.rotation, block.displacement.x, block.displacement.y,
                        block.stress.xx, block.stress.yy, block.stress.xy, block.area, block.stress.zz});
      if (has_plastic) append_plastic(text, block.plastic, block.stress);
      text += '\n';
    }
  }
  return text;
}

namespace {

/// Returns the column of the first surplus cell, or of the end of a row that is too short.
int surplus_column(const CsvRow& row, std::size_t wanted) {
  return row.cells.size() > wanted ? row.columns[wanted] : row.end;
}

}  // namespace

CsvTable read_csv(const Source& source) {
  CsvScanner scanner(source);
  CsvTable table{source.name, scanner.next_row().cells, {}};
  if (table.header.empty()) throw InputError({source.name}, "expected a header line, found nothing");
  for (CsvRow row = scanner.next_row(); !row.cells.empty(); row = scanner.next_row()) {
    if (row.cells.size() != table.header.size())
      throw InputError(
          {source.name, row.line, surplus_column(row, table.header.size())},
          fmt::format("expected {} cells as in the header, found {}", table.header.size(), row.cells.size()));
    table.rows.push_back(std::move(row));
  }
  return table;
}

CsvHeading csv_heading(std::string_view text) {
  const std::size_t bracket = text.find(" [");
  if (bracket == std::string_view::npos || !text.ends_with(']')) return {std::string(text), {}};
  return {std::string(text.substr(0, bracket)), std::string(text.substr(bracket + 2, text.size() - bracket - 3))};
}

std::size_t csv_column(const CsvTable& table, std::string_view heading) {
  const auto found = std::ranges::find_if(
      table.header, [&](const std::string& h) { return h == heading || csv_heading(h).name == heading; });
  if (found == table.header.end())
    throw InputError({table.name, 1, 1}, fmt::format("expected a column \"{}\", found {}", heading,
                                                     in_quotes(fmt::format("{}", fmt::join(table.header, ",")))));
  return static_cast<std::size_t>(found - table.header.begin());
}

double csv_real(const CsvTable& table, const CsvRow& row, std::size_t column) {
  const std::optional<double> value = parse_real(row.cells.at(column));
  if (!value)
    throw InputError({table.name, row.line, row.columns[column]},
                     fmt::format("expected a number in column {}, found {}", in_quotes(table.header.at(column)),
                                 in_quotes(row.cells[column])));
  return *value;
}

}  // namespace keyblock::formats
