// Writes rows of contacts, joints and bolts cell by cell.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/contact_csv.hpp"

#include <fmt/format.h>

#include <initializer_list>
#include <string_view>

#include "base/printable.hpp"
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

}  // namespace

std::string contacts_csv_header(const Units& units) {
  return headings(kContactsTable, units) + '\n';
}

std::string contacts_csv_rows(int step, double time, const ContactFrames& contacts) {
  const std::string first = opening(step, time);
  std::string text;
  text.reserve(kRow * contacts.size());
  for (const ContactFrame& c : contacts) {
    text += first;
    append_integers(text, {c.element + 1, c.other + 1, c.joint_material + 1, c.joint_line + 1});
    text += ',';
    text += word_for(c.condition);
    const Point force = c.force();
    append(text, {c.position.x, c.position.y, c.normal.x, c.normal.y, c.gap, c.slip, c.normal_force, c.shear_force,
                  force.x, force.y});
    text += '\n';
  }
  return text;
}

std::string joints_csv_header(const Units& units) {
  return headings(kJointsTable, units) + '\n';
}

std::string joints_csv_rows(int step, double time, const ContactFrames& contacts) {
  const std::string first = opening(step, time);
  std::string text;
  for (const JointSum& sum : joint_sums(contacts)) {
    text += first;
    append_integers(text, {sum.element + 1, sum.other + 1, sum.joint_material + 1});
    append_integers(text, {sum.contacts, sum.closed, sum.sliding});
    append(text, {sum.normal_force, sum.shear_force, sum.force.x, sum.force.y});
    text += '\n';
  }
  return text;
}

std::string joint_lines_csv_header(const Units& units) {
  return headings(kJointLinesTable, units) + '\n';
}

std::string joint_lines_csv_rows(int step, double time, const ContactFrames& contacts) {
  const std::string first = opening(step, time);
  std::string text;
  for (const JointLineSum& sum : joint_line_sums(contacts)) {
    text += first;
    append_integers(text, {sum.joint_line + 1, sum.joint_material + 1, sum.contacts, sum.closed, sum.sliding});
    append(text, {sum.normal_force, sum.shear_force, sum.greatest_gap, sum.greatest_slip});
    text += '\n';
  }
  return text;
}

std::string bolts_csv_header(const Units& units) {
  return headings(kBoltsTable, units) + '\n';
}

std::string bolts_csv_rows(const Frame& frame) {
  const std::string first = opening(frame.step, frame.time);
  std::string text;
  for (std::size_t i = 0; i < frame.bolts.size(); ++i) {
    const BoltFrame& bolt = frame.bolts[i];
    text += fmt::format("{},{}", first, (bolt.number < 0 ? static_cast<int>(i) : bolt.number) + 1);
    append(text, {bolt.first.x, bolt.first.y, bolt.second.x, bolt.second.y, bolt.force});
    text += fmt::format(",{:d},{}\n", bolt.is_broken, csv_cell(bolt.name));
  }
  return text;
}

}  // namespace keyblock::formats
