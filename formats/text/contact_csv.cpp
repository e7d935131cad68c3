// Writes rows of contacts, joints and bolts cell by cell.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/contact_csv.hpp"

#include <fmt/format.h>

#include <initializer_list>
#include <span>
#include <string_view>

#include "base/printable.hpp"
#include "formats/columns/joint_sums.hpp"
#include "formats/tables/run_tables.hpp"
#include "formats/text/numbers.hpp"

namespace keyblock::formats {
namespace {

constexpr std::size_t kRow = 200;  // characters, of a long row

std::string opening(int step, double time) {
  return fmt::format("{},{}", step, format_real(time));
}

void append_integers(std::string& text, std::initializer_list<int> values) {
  for (const int value : values) {
    text += ',';
    append_integer(text, value);
  }
}

void append(std::string& text, std::initializer_list<double> values) {
  for (const double value : values) {
    text += ',';
    append_rounded(text, value);
  }
}

void append_cells(std::string& text, const FrameColumn& column, std::size_t row) {
  if (column.name == "state") {
    text += ',';
    text += word_for(static_cast<ContactCondition>(column.integers()[row]));
  } else if (column.numbers.index() == 1) {
    append_integers(text, {column.integers()[row]});
  } else {
    const std::size_t width = width_of(column.shape);
    for (const double value : column.reals().subspan(width * row, width)) append(text, {value});
  }
}

}  // namespace

std::string contacts_csv_header(const Units& units) {
  return headings(kContactsTable, units) + '\n';
}

std::string contacts_csv_rows(const FrameColumns& frame) {
  const FramePart& contacts = frame.part("contacts");
  const std::string first = opening(frame.step, frame.time);
  std::string text;
  text.reserve(kRow * contacts.rows);
  for (std::size_t i = 0; i < contacts.rows; ++i) {
    text += first;
    for (const FrameColumn& column : contacts.columns) append_cells(text, column, i);
    text += '\n';
  }
  return text;
}

std::string joints_csv_header(const Units& units) {
  return headings(kJointsTable, units) + '\n';
}

std::string joints_csv_rows(int step, double time, const FramePart& contacts) {
  const std::string first = opening(step, time);
  std::string text;
  for (const JointSum& sum : joint_sums(contacts, JointsBy::bodies)) {
    text += first;
    append_integers(text, {sum.block, sum.other, sum.joint_material});
    append_integers(text, {sum.contacts, sum.closed, sum.sliding});
    append(text, {sum.normal_force, sum.shear_force, sum.force.x, sum.force.y});
    text += '\n';
  }
  return text;
}

std::string joint_lines_csv_header(const Units& units) {
  return headings(kJointLinesTable, units) + '\n';
}

std::string joint_lines_csv_rows(int step, double time, const FramePart& contacts) {
  const std::string first = opening(step, time);
  std::string text;
  for (const JointSum& sum : joint_sums(contacts, JointsBy::line)) {
    text += first;
    append_integers(text, {sum.joint, sum.joint_material, sum.contacts, sum.closed, sum.sliding});
    append(text, {sum.normal_force, sum.shear_force, sum.greatest_gap, sum.greatest_slip});
    text += '\n';
  }
  return text;
}

std::string bolts_csv_header(const Units& units) {
  return headings(kBoltsTable, units) + '\n';
}

std::string bolts_csv_rows(const FrameColumns& frame, const std::vector<BoltFrame>& named) {
  const FramePart& bolts = frame.part("bolts");
  if (bolts.rows == 0) return {};
  const std::span<const int> numbers = bolts.at("bolt").integers(), broken = bolts.at("is_broken").integers();
  const std::span<const double> ends = bolts.at("ends").reals(), forces = bolts.at("force").reals();
  const std::string first = opening(frame.step, frame.time);
  std::string text;
  for (std::size_t i = 0; i < bolts.rows; ++i) {
    text += fmt::format("{},{}", first, numbers[i]);
    append(text, {ends[4 * i], ends[4 * i + 1], ends[4 * i + 2], ends[4 * i + 3], forces[i]});
    text += fmt::format(",{},{}\n", broken[i], csv_cell(named[i].name));
  }
  return text;
}

}  // namespace keyblock::formats
