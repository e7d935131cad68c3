// Declares the tables, column by column; csv.hpp, contact_csv.hpp and tips_csv.hpp describe their content.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/tables/run_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include "formats/columns/contact_columns.hpp"

namespace keyblock::formats {
namespace {

namespace m = measures;

constexpr std::array kHistory{Column("step", m::kNumber),
                              Column("time", m::kTime),
                              Column("x#", m::kLength),
                              Column("y#", m::kLength),
                              Column("dx#", m::kLength),
                              Column("dy#", m::kLength),
                              Column("bolt#", m::kForce),
                              Column("reaction#_x", m::kForce),
                              Column("reaction#_y", m::kForce),
                              Column("driven#", m::kLength),
                              Column("load_share", m::kNumber),
                              Column("load_factor", m::kNumber),
                              Column("yielded_fraction", m::kNumber),
                              Column("yielding_fraction", m::kNumber),
                              Column("plastic_work", m::kEnergy)};
constexpr std::array kPoints{Column("step", m::kNumber),
                             Column("time", m::kTime),
                             Column("point", m::kNumber),
                             Column("x", m::kLength),
                             Column("y", m::kLength),
                             Column("dx", m::kLength),
                             Column("dy", m::kLength),
                             Column("sxx", m::kStress),
                             Column("syy", m::kStress),
                             Column("sxy", m::kStress),
                             Column("szz", m::kStress),
                             Column("plastic_strain_xx", m::kNumber),
                             Column("plastic_strain_yy", m::kNumber),
                             Column("plastic_strain_xy", m::kNumber),
                             Column("plastic_strain_zz", m::kNumber),
                             Column("equivalent_plastic_strain", m::kNumber),
                             Column("yield_state", m::kNumber),
                             Column("has_yielded", m::kNumber),
                             Column("mean_stress", m::kStress),
                             Column("von_mises_stress", m::kStress),
                             Column("lode_angle", m::kDegrees)};
// Each row names the unit of its value.
constexpr std::array kHistories{Column("step", m::kNumber), Column("time", m::kTime),       Column("what", m::kNumber),
                                Column("name", m::kNumber), Column("quantity", m::kNumber), Column("value", m::kNumber),
                                Column("unit", m::kNumber)};
// All columns of contacts, a point as two.
std::vector<Column> contact_cells() {
  std::vector<Column> cells{Column("step", m::kNumber), Column("time", m::kTime)};
  for (const ContactColumn& column : contact_columns())
    if (column.is_point())
      for (const std::string_view name : column.of_point) cells.emplace_back(name, column.measure);
    else
      cells.emplace_back(column.name, column.measure);
  return cells;
}

// Lists columns of one number, then those of two. Places are the points of the file.
std::vector<Column> contact_arrays() {
  std::vector<Column> arrays;
  for (const bool is_point : {false, true})
    for (const ContactColumn& column : contact_columns())
      if (column.is_point() == is_point && column.name != "place") arrays.emplace_back(column.name, column.measure);
  return arrays;
}

const std::vector<Column> kContacts = contact_cells();
constexpr std::array kJoints{Column("step", m::kNumber),           Column("time", m::kTime),
                             Column("block", m::kNumber),          Column("other", m::kNumber),
                             Column("joint_material", m::kNumber), Column("contacts", m::kNumber),
                             Column("closed", m::kNumber),         Column("sliding", m::kNumber),
                             Column("normal_force", m::kForce),    Column("shear_force", m::kForce),
                             Column("force_x", m::kForce),         Column("force_y", m::kForce)};
constexpr std::array kJointLines{
    Column("step", m::kNumber),           Column("time", m::kTime),           Column("joint", m::kNumber),
    Column("joint_material", m::kNumber), Column("contacts", m::kNumber),     Column("closed", m::kNumber),
    Column("sliding", m::kNumber),        Column("normal_force", m::kForce),  Column("shear_force", m::kForce),
    Column("greatest_gap", m::kLength),   Column("greatest_slip", m::kLength)};
constexpr std::array kBolts{Column("step", m::kNumber), Column("time", m::kTime),   Column("bolt", m::kNumber),
                            Column("x1", m::kLength),   Column("y1", m::kLength),   Column("x2", m::kLength),
                            Column("y2", m::kLength),   Column("force", m::kForce), Column("is_broken", m::kNumber),
                            Column("name", m::kNumber)};
constexpr std::array kTips{
    Column("step", m::kNumber),    Column("time", m::kTime),      Column("load_factor", m::kNumber),
    Column("tip", m::kNumber),     Column("crack", m::kNumber),   Column("end", m::kNumber),
    Column("x", m::kLength),       Column("y", m::kLength),       Column("length", m::kLength),
    Column("K_I", m::kToughness),  Column("K_II", m::kToughness), Column("J", m::kEnergyPerArea),
    Column("K_eq", m::kToughness), Column("kink", m::kDegrees),   Column("toughness", m::kToughness),
    Column("goes_on", m::kNumber), Column("kind", m::kNumber)};
constexpr std::array kStepRows{Column("step", m::kNumber),
                               Column("time", m::kTime),
                               Column("dt", m::kTime),
                               Column("passes", m::kNumber),
                               Column("redos", m::kNumber),
                               Column("fallbacks", m::kNumber),
                               Column("contacts", m::kNumber),
                               Column("closed", m::kNumber),
                               Column("penalty", m::kStiffness),
                               Column("greatest_penetration", m::kLength),
                               Column("displacement_ratio", m::kNumber),
                               Column("residual", m::kNumber),
                               Column("unsettled_contacts", m::kNumber),
                               Column("parts", m::kNumber)};
constexpr std::array kLedgerRows{Column("step", m::kNumber),
                                 Column("time", m::kTime),
                                 Column("kinetic", m::kEnergy),
                                 Column("strain", m::kEnergy),
                                 Column("gravity", m::kEnergy),
                                 Column("contact", m::kEnergy),
                                 Column("external", m::kEnergy),
                                 Column("friction", m::kEnergy),
                                 Column("damping", m::kEnergy),
                                 Column("impact", m::kEnergy),
                                 Column("closing", m::kEnergy),
                                 Column("clean_up", m::kEnergy),
                                 Column("rupture", m::kEnergy),
                                 Column("algorithmic", m::kEnergy),
                                 Column("projection", m::kEnergy),
                                 Column("geometric", m::kEnergy),
                                 Column("creep", m::kEnergy),
                                 Column("plastic", m::kEnergy),
                                 Column("fracture", m::kEnergy),
                                 Column("change", m::kEnergy),
                                 Column("momentum_x", m::kMomentum),
                                 Column("momentum_y", m::kMomentum),
                                 Column("angular_momentum", m::kAngularMomentum),
                                 Column("impulse_x", m::kMomentum),
                                 Column("impulse_y", m::kMomentum),
                                 Column("angular_impulse", m::kAngularMomentum),
                                 Column("reaction_impulse_x", m::kMomentum),
                                 Column("reaction_impulse_y", m::kMomentum),
                                 Column("angular_reaction_impulse", m::kAngularMomentum)};
constexpr std::array kSteps{Column("step", m::kNumber),       Column("time", m::kTime),
                            Column("dt", m::kTime),           Column("oci", m::kNumber),
                            Column("contacts", m::kNumber),   Column("closed", m::kNumber),
                            Column("k_blocks", m::kNumber),   Column("penalty", m::kStiffness),
                            Column("disp_ratio", m::kNumber), Column("max_penetration", m::kLength)};
constexpr std::array kBlocks{Column("step", m::kNumber),
                             Column("time", m::kTime),
                             Column("block", m::kNumber),
                             Column("material", m::kNumber),
                             Column("cx", m::kLength),
                             Column("cy", m::kLength),
                             Column("rot", m::kRadians),
                             Column("dx", m::kLength),
                             Column("dy", m::kLength),
                             Column("sxx", m::kStress),
                             Column("syy", m::kStress),
                             Column("sxy", m::kStress),
                             Column("area", m::kArea),
                             Column("szz", m::kStress),
                             Column("plastic_strain_xx", m::kNumber),
                             Column("plastic_strain_yy", m::kNumber),
                             Column("plastic_strain_xy", m::kNumber),
                             Column("plastic_strain_zz", m::kNumber),
                             Column("equivalent_plastic_strain", m::kNumber),
                             Column("yield_state", m::kNumber),
                             Column("has_yielded", m::kNumber),
                             Column("mean_stress", m::kStress),
                             Column("von_mises_stress", m::kStress),
                             Column("lode_angle", m::kDegrees)};
constexpr std::array kRounds{Column("step", m::kNumber), Column("round", m::kNumber), Column("residual", m::kNumber)};

constexpr std::array kOfBlocks{Column("block", m::kNumber),
                               Column("origin", m::kNumber),
                               Column("body", m::kNumber),
                               Column("material", m::kNumber),
                               Column("stress_xx", m::kStress),
                               Column("stress_yy", m::kStress),
                               Column("stress_xy", m::kStress),
                               Column("stress_zz", m::kStress),
                               Column("principal_stress_greatest", m::kStress),
                               Column("principal_stress_least", m::kStress),
                               Column("principal_axis", m::kNumber),
                               Column("displacement", m::kLength),
                               Column("velocity", m::kVelocity),
                               Column("rotation", m::kRadians),
                               Column("rotation_rate", m::kRotationRate),
                               Column("area", m::kArea),
                               Column("fixed_points", m::kNumber),
                               Column("elastic_strain_xx", m::kNumber),
                               Column("elastic_strain_yy", m::kNumber),
                               Column("elastic_strain_xy", m::kNumber),
                               Column("elastic_strain_zz", m::kNumber),
                               Column("plastic_strain_xx", m::kNumber),
                               Column("plastic_strain_yy", m::kNumber),
                               Column("plastic_strain_xy", m::kNumber),
                               Column("plastic_strain_zz", m::kNumber),
                               Column("equivalent_plastic_strain", m::kNumber),
                               Column("mean_stress", m::kStress),
                               Column("von_mises_stress", m::kStress),
                               Column("lode_angle", m::kDegrees),
                               Column("yield_state", m::kNumber),
                               Column("has_yielded", m::kNumber)};
constexpr std::array kOfCorners{Column("displacement", m::kLength),
                                Column("stress_xx", m::kStress),
                                Column("stress_yy", m::kStress),
                                Column("stress_xy", m::kStress),
                                Column("stress_zz", m::kStress),
                                Column("principal_stress_greatest", m::kStress),
                                Column("principal_stress_least", m::kStress),
                                Column("principal_axis", m::kNumber),
                                Column("elastic_strain_xx", m::kNumber),
                                Column("elastic_strain_yy", m::kNumber),
                                Column("elastic_strain_xy", m::kNumber),
                                Column("elastic_strain_zz", m::kNumber),
                                Column("plastic_strain_xx", m::kNumber),
                                Column("plastic_strain_yy", m::kNumber),
                                Column("plastic_strain_xy", m::kNumber),
                                Column("plastic_strain_zz", m::kNumber),
                                Column("equivalent_plastic_strain", m::kNumber),
                                Column("mean_stress", m::kStress),
                                Column("von_mises_stress", m::kStress),
                                Column("lode_angle", m::kDegrees)};
const std::vector<Column> kOfContacts = contact_arrays();
constexpr std::array kOfBolts{Column("bolt", m::kNumber), Column("force", m::kForce), Column("is_broken", m::kNumber)};

constexpr std::array kOfJoints{
    Column("block", m::kNumber),        Column("other", m::kNumber),        Column("joint_material", m::kNumber),
    Column("joint", m::kNumber),        Column("contacts", m::kNumber),     Column("closed", m::kNumber),
    Column("sliding", m::kNumber),      Column("normal_force", m::kForce),  Column("shear_force", m::kForce),
    Column("greatest_gap", m::kLength), Column("greatest_slip", m::kLength)};
constexpr std::array kOfCracks{Column("displacement", m::kLength), Column("crack", m::kNumber),
                               Column("side", m::kNumber), Column("is_shear", m::kNumber)};

// Returns true for "x12" if the column is "x#".
bool is_of(const Column& column, std::string_view name) {
  const std::size_t mark = column.name.find('#');
  if (mark == std::string_view::npos) return column.name == name;
  if (!name.starts_with(column.name.substr(0, mark))) return false;
  name.remove_prefix(mark);
  const std::size_t digits = name.find_first_not_of("0123456789");
  return digits != 0 &&
         (digits == std::string_view::npos ? std::string_view() : name.substr(digits)) == column.name.substr(mark + 1);
}

std::string heading_of(const RunTable& table, const Column& column, std::string_view name, const Units& units) {
  const bool is_said = column.measure.angle.empty() ? is_declared(column.measure, units) : units != Units{};
  // Stresses never had letters.
  const bool has_letters = table.has_letters && column.measure != m::kStress;
  const bool has_unit = has_letters || is_said || column.measure == m::kDegrees;
  return has_unit ? with_unit(name, column.measure, units) : std::string(name);
}

}  // namespace

const RunTable kHistoryTable{"history.csv", kHistory, true};
const RunTable kPointsTable{"points.csv", kPoints, true};
const RunTable kHistoriesTable{"histories.csv", kHistories, true};
const RunTable kContactsTable{"contacts.csv", kContacts, true};
const RunTable kJointsTable{"joints.csv", kJoints, true};
const RunTable kJointLinesTable{"joint_lines.csv", kJointLines, true};
const RunTable kBoltsTable{"bolts.csv", kBolts, true};
const RunTable kTipsTable{"tips.csv", kTips, true};
const RunTable kStepTable{"step_table.csv", kStepRows};
const RunTable kLedgerTable{"ledger.csv", kLedgerRows};
const RunTable kTraceOfSteps{"steps.csv", kSteps};
const RunTable kTraceOfBlocks{"blocks.csv", kBlocks};
const RunTable kTraceOfRounds{"rounds.csv", kRounds};
const RunTable kBlockArrays{"frames", kOfBlocks};
const RunTable kCornerArrays{"frames", kOfCorners};
const RunTable kContactArrays{"frames", kOfContacts};
const RunTable kBoltArrays{"frames", kOfBolts};
const RunTable kCrackArrays{"frames", kOfCracks};
const RunTable kJointArrays{"frames", kOfJoints};

std::span<const RunTable* const> run_tables() {
  static const std::array<const RunTable*, 19> tables{
      &kHistoryTable,    &kPointsTable,   &kHistoriesTable, &kContactsTable, &kJointsTable,
      &kJointLinesTable, &kBoltsTable,    &kTipsTable,      &kStepTable,     &kLedgerTable,
      &kTraceOfSteps,    &kTraceOfBlocks, &kTraceOfRounds,  &kBlockArrays,   &kCornerArrays,
      &kContactArrays,   &kBoltArrays,    &kCrackArrays,    &kJointArrays};
  return tables;
}

bool has_column(const RunTable& table, std::string_view name) {
  return std::ranges::any_of(table.columns, [&](const Column& c) { return is_of(c, name); });
}

const Column& column_of(const RunTable& table, std::string_view name) {
  const auto found = std::ranges::find_if(table.columns, [&](const Column& c) { return is_of(c, name); });
  if (found == table.columns.end()) throw std::logic_error(fmt::format("{} declares no column {}", table.file, name));
  return *found;
}

std::string heading(const RunTable& table, std::string_view name, const Units& units) {
  return heading_of(table, column_of(table, name), name, units);
}

std::string headings(const RunTable& table, std::span<const std::string_view> names, const Units& units) {
  std::string text;
  for (const std::string_view name : names) text.append(text.empty() ? "" : ",").append(heading(table, name, units));
  return text;
}

std::string headings(const RunTable& table, const Units& units) {
  std::vector<std::string_view> names;
  for (const Column& column : table.columns) names.push_back(column.name);
  return headings(table, names, units);
}

}  // namespace keyblock::formats
