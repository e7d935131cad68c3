// Writes table and totals of the energy balance from one list of named columns.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/ledger_report.hpp"

#include <fmt/format.h>

#include "formats/tables/run_tables.hpp"
#include "formats/text/numbers.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;

using Column = LedgerColumn;

const std::vector<Column> kStored{{"kinetic", [](const LedgerRow& r) { return r.stored.kinetic; }},
                                  {"strain", [](const LedgerRow& r) { return r.stored.strain; }},
                                  {"gravity", [](const LedgerRow& r) { return r.stored.gravity; }}};
const Column kExternal{"external", [](const LedgerRow& r) { return r.flow.external; }};
const std::vector<Column> kFlows{{"contact", [](const LedgerRow& r) { return r.stored.contact; }},
                                 kExternal,
                                 {"friction", [](const LedgerRow& r) { return r.flow.friction; }},
                                 {"damping", [](const LedgerRow& r) { return r.flow.damping; }},
                                 {"impact", [](const LedgerRow& r) { return r.flow.impact; }},
                                 {"closing", [](const LedgerRow& r) { return r.flow.closing; }},
                                 {"clean_up", [](const LedgerRow& r) { return r.flow.clean_up; }},
                                 {"rupture", [](const LedgerRow& r) { return r.flow.rupture; }},
                                 {"algorithmic", [](const LedgerRow& r) { return r.flow.algorithmic; }},
                                 {"projection", [](const LedgerRow& r) { return r.flow.projection; }},
                                 {"geometric", [](const LedgerRow& r) { return r.flow.geometric; }},
                                 {"creep", [](const LedgerRow& r) { return r.flow.creep; }}};
const std::vector<Column> kFracture{{"fracture", [](const LedgerRow& r) { return r.flow.fracture; }}};
const std::vector<Column> kPlastic{{"plastic", [](const LedgerRow& r) { return r.flow.plastic; }}};
const std::vector<Column> kChanges{{"change", [](const LedgerRow& r) { return r.flow.change; }}};
const std::vector<Column> kMomentum{{"momentum_x", [](const LedgerRow& r) { return r.momentum.linear.x; }},
                                    {"momentum_y", [](const LedgerRow& r) { return r.momentum.linear.y; }},
                                    {"angular_momentum", [](const LedgerRow& r) { return r.momentum.angular; }}};
const std::vector<Column> kImpulse{{"impulse_x", [](const LedgerRow& r) { return r.impulse.linear.x; }},
                                   {"impulse_y", [](const LedgerRow& r) { return r.impulse.linear.y; }},
                                   {"angular_impulse", [](const LedgerRow& r) { return r.impulse.angular; }}};

// Returns the change of momentum since `start` that loads do not explain: the impulse of fixed blocks and points.
std::vector<Column> reactions_since(const LedgerRow& start) {
  return {{"reaction_impulse_x",
           [=](const LedgerRow& r) { return r.momentum.linear.x - start.momentum.linear.x - r.impulse.linear.x; }},
          {"reaction_impulse_y",
           [=](const LedgerRow& r) { return r.momentum.linear.y - start.momentum.linear.y - r.impulse.linear.y; }},
          {"angular_reaction_impulse",
           [=](const LedgerRow& r) { return r.momentum.angular - start.momentum.angular - r.impulse.angular; }}};
}

// Closures are relative to the largest energy, and to the largest sum of the absolute momenta.
Json closure_json(const LedgerScope& scope, const LedgerSums& sums) {
  Json closure = Json::object();
  if (!scope.has_flows) return closure;
  closure["energy"] = sums.energy_closure();
  if (scope.has_supports) return closure;
  closure["linear_momentum"] = sums.linear_momentum_closure();
  closure["angular_momentum"] = sums.angular_momentum_closure();
  return closure;
}

}  // namespace

std::vector<Column> ledger_columns(const LedgerScope& scope, const LedgerRow& start) {
  std::vector<Column> columns = kStored;
  const auto append = [&](const std::vector<Column>& more) { columns.insert(columns.end(), more.begin(), more.end()); };
  if (scope.has_flows) append(kFlows);
  if (!scope.has_flows && scope.has_work) append({kExternal});
  if (scope.has_flows && scope.may_yield) append(kPlastic);
  if (scope.has_flows && scope.may_crack) append(kFracture);
  if (scope.has_flows && scope.has_changes) append(kChanges);
  append(kMomentum);
  if (!scope.has_flows) return columns;
  append(kImpulse);
  if (scope.has_supports) append(reactions_since(start));
  return columns;
}

Json ledger_json(const Ledger& ledger, const LedgerSums& sums, int kept_every, const Units& units) {
  const std::vector<Column> columns = ledger_columns(ledger.scope, sums.first);
  Json names = {"step", formats::heading(formats::kLedgerTable, "time", units)};
  Json end = Json::object();
  for (const Column& column : columns) names.push_back(formats::heading(formats::kLedgerTable, column.name, units));
  if (!ledger.rows.empty())
    for (const Column& column : columns) end[column.name] = column.value(ledger.rows.back());
  return {{"closure", closure_json(ledger.scope, sums)},
          {"largest_energy", sums.largest_energy()},
          {"momentum_about", {ledger.scope.centre.x, ledger.scope.centre.y}},
          {"end", end},
          {"table", formats::kLedgerTable.file},
          {"columns", names},
          {"kept_every", kept_every}};
}

std::string ledger_csv(const Ledger& ledger, const LedgerSums& sums, const Units& units) {
  const std::vector<Column> columns = ledger_columns(ledger.scope, sums.first);
  std::string text = "step," + formats::heading(formats::kLedgerTable, "time", units);
  for (const Column& column : columns) text += ',' + formats::heading(formats::kLedgerTable, column.name, units);
  text += '\n';
  for (const LedgerRow& row : ledger.rows) {
    text += fmt::format("{},{}", row.step, formats::format_real(row.time));
    for (const Column& column : columns) text += fmt::format(",{}", formats::format_real(column.value(row)));
    text += '\n';
  }
  return text;
}

}  // namespace keyblock
