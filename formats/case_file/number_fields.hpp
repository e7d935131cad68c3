// Reads numbers of a case file: with units, which are converted, counted from 1, or as expressions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "formats/case_file/taken_fields.hpp"
#include "formats/text/demands.hpp"
#include "problem/formula.hpp"
#include "problem/units/measure.hpp"

namespace keyblock::formats {

/// Reads the numeric fields of one JSON value. A value is in the units of the case, or a text that names its unit and
/// is converted to them. Throws InputError at the place of a value that violates its condition.
class NumberFields : public TakenFields {
 public:
  using TakenFields::TakenFields;

  void real(std::string_view name, double& value, const Demand& demand = {{}, "a number"});
  template <class Integer>
  void integer(std::string_view name, Integer& value, const Demand& demand) {
    double number = static_cast<double>(value);
    real(name, number, demand);
    value = static_cast<Integer>(number);
  }
  void index(std::string_view name, int& value);
  void optional_index(std::string_view name, std::optional<int>& value);
  void optional_real(std::string_view name, std::optional<double>& value, const Demand& demand);
  void optional_integer(std::string_view name, std::optional<int>& value, const Demand& demand);
  void formula(std::string_view name, Formula& formula);
  void optional_formula(std::string_view name, std::optional<Formula>& formula);

 private:
  /// Throws InputError for a number so large that products of it would not be numbers.
  void require_measurable(std::string_view name, double value) const;

 protected:
  /// Returns true for a number with the name of a unit. Expressions do not match: x, y and functions are not units.
  static bool is_quantity(std::string_view text);

  /// Returns 0.01 for "1 %", 0.001 for "1 ‰".
  static std::optional<double> share_in(std::string_view text);

  /// Returns the number of a text, in the units of the case; `or_else`: other permitted input, for messages.
  static double converted_at(const JsonValue& value, std::string_view name, const std::optional<Measure>& of,
                             std::string_view or_else);
};

}  // namespace keyblock::formats
