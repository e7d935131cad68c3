// Numbers of a case file: with units, which are converted, counted from 1, or as expressions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "formats/case_file/taken_fields.hpp"
#include "formats/text/demands.hpp"
#include "problem/formula.hpp"
#include "problem/units/measure.hpp"

namespace keyblock::formats {

/// The fields of one JSON value that are numbers. A value is in the units of the case, or a text that names its unit
/// and is converted to them. Throws InputError at the place of one that does not meet its demand.
class NumberFields : public TakenFields {
 public:
  using TakenFields::TakenFields;

  void real(std::string_view name, double& value, const Demand& demand = {[](double) { return true; }, "a number"});
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
  /// A number and the name of a unit, which no expression is: x, y and functions are none.
  static bool is_quantity(std::string_view text);

  /// 0.01 of "1 %", 0.001 of "1 ‰".
  static std::optional<double> share_in(std::string_view text);

  /// The number that a text stands for, in the units of the case; `or_else`: what else may stand there.
  static double converted_at(const JsonValue& value, std::string_view name, const std::optional<Measure>& of,
                             std::string_view or_else);
};

}  // namespace keyblock::formats
