// Writes rows of contacts, joints and bolts cell by cell.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/contact_csv.hpp"

#include <fmt/format.h>

#include <array>
#include <initializer_list>
#include <span>
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

std::string contacts_csv_rows(const FrameColumns& frame) {
  const FramePart& contacts = frame.part("contacts");
  if (contacts.rows == 0) return {};
  const std::array integers{contacts.at("block").integers(), contacts.at("other").integers(),
                            contacts.at("joint_material").integers(), contacts.at("joint").integers()};
  const std::span<const int> states = contacts.at("state").integers();
  const std::array pairs{contacts.at("place").reals(), contacts.at("normal").reals()};
  const std::array reals{contacts.at("gap").reals(), contacts.at("slip").reals(), contacts.at("normal_force").reals(),
                         contacts.at("shear_force").reals()};
  const std::span<const double> force = contacts.at("force").reals();
  const std::string first = opening(frame.step, frame.time);
  std::string text;
  text.reserve(kRow * contacts.rows);
  for (std::size_t i = 0; i < contacts.rows; ++i) {
    text += first;
    for (const std::span<const int> column : integers) append_integers(text, {column[i]});
    text += ',';
    text += word_for(static_cast<ContactCondition>(states[i]));
    for (const std::span<const double> column : pairs) append(text, {column[2 * i], column[2 * i + 1]});
    for (const std::span<const double> column : reals) append(text, {column[i]});
    append(text, {force[2 * i], force[2 * i + 1]});
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
