// Converts $INSUNITS of the header by a table of units.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/dxf_units.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/sentences/sentences.hpp"
#include "formats/text/numbers.hpp"

namespace keyblock::formats {
namespace {

struct Unit {
  std::string_view name;
  std::string_view length;  ///< in a case file; empty: unknown there
  double metres;
};

constexpr int kMetre = 6;  // in this list
constexpr std::array<Unit, 22> kUnits{{
    {"no unit", "", 1},
    {"inch", "in", 0.0254},
    {"foot", "ft", 0.3048},
    {"mile", "", 1609.344},
    {"millimetre", "mm", 0.001},
    {"centimetre", "cm", 0.01},
    {"metre", "m", 1},
    {"kilometre", "km", 1000},
    {"microinch", "", 2.54e-8},
    {"mil", "", 2.54e-5},
    {"yard", "yd", 0.9144},
    {"ångström", "", 1e-10},
    {"nanometre", "", 1e-9},
    {"micrometre", "", 1e-6},
    {"decimetre", "dm", 0.1},
    {"decametre", "", 10},
    {"hectometre", "", 100},
    {"gigametre", "", 1e9},
    {"astronomical unit", "", 149597870700.0},
    {"light year", "", 9460730472580800.0},
    {"parsec", "", 3.0856775814913673e16},
    {"US survey foot", "", 1200.0 / 3937},
}};

const DxfGroup* units_group(const DxfDocument& document) {
  for (const DxfSection& section : document.sections()) {
    if (section.name != "HEADER") continue;
    for (std::size_t i = 0; i + 1 < section.groups.size(); ++i)
      if (section.groups[i].code == 9 && section.groups[i].value == "$INSUNITS") return &section.groups[i + 1];
  }
  return nullptr;
}

}  // namespace

DxfUnit unit_of(const DxfDocument& document, std::string_view wanted, std::string_view overruling) {
  const DxfGroup* group = units_group(document);
  const Place place = group == nullptr ? Place{} : document.place(*group);
  const int own = group == nullptr ? 0 : document.integer(*group, "the unit", "$INSUNITS");
  const int number = overruling.empty() ? own : dxf_unit_number(overruling);
  if (number == 0) return {};
  if (number < 0 || number >= static_cast<int>(kUnits.size()))
    return {1, "", {warning_of({"dxf_unit_unknown", {{{"insunits", number}}}}, place)}};
  Warnings warnings;
  const bool is_known = own > 0 && own < static_cast<int>(kUnits.size());
  if (is_known && own != number) {
    Facts facts{{{"insunits", own}}};
    facts.names = {{"unit", std::string(kUnits[static_cast<std::size_t>(own)].name)},
                   {"taken", std::string(kUnits[static_cast<std::size_t>(number)].name)}};
    warnings.push_back(warning_of({"dxf_unit_overruled", std::move(facts)}, place));
  }
  const Unit& unit = kUnits[static_cast<std::size_t>(number)];
  const int target_number = dxf_unit_number(wanted);
  const Unit& target = kUnits[static_cast<std::size_t>(target_number > 0 ? target_number : kMetre)];
  if (unit.metres == target.metres) return {1, std::string(target.length), std::move(warnings)};
  const double factor = unit.metres / target.metres;
  Facts facts{{{"factor", factor}},
              {{"source", overruling.empty() ? "file" : "drawing"}, {"written", format_real(factor)}}};
  facts.names = {{"unit", std::string(unit.name)}, {"unit_taken", std::string(target.name)}};
  const char* const form = target.length == "m" ? "dxf_scaled_to_metres" : "dxf_scaled_to_declared_unit";
  warnings.push_back(warning_of({form, std::move(facts)}, place));
  return {factor, std::string(target.length), std::move(warnings)};
}

std::vector<std::string> dxf_unit_names() {
  std::vector<std::string> names;
  for (const Unit& unit : kUnits)
    if (!unit.length.empty()) names.emplace_back(unit.length);
  return names;
}

int dxf_unit_number(std::string_view length) {
  if (length.empty()) return 0;
  const auto found = std::ranges::find(kUnits, length, &Unit::length);
  return found == kUnits.end() ? 0 : static_cast<int>(found - kUnits.begin());
}

}  // namespace keyblock::formats
