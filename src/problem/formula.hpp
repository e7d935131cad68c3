// Evaluates a number given in a file, or an expression of position.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace keyblock {

/// Text as written in the file. It may use operators + - * / ^, comparisons, && || and ?:, functions (sin, cos, atan2,
/// sqrt, exp, ln, log10, abs, min, max, …), the constants _pi and _e, and the variables of its use. It has access to
/// nothing else.
struct Formula {
  std::string text = "0";
  Place place = {};  ///< of the value: the opening quote of a text

  bool operator==(const Formula& other) const { return text == other.text; }
};

/// Returns true if the text is one finite number and nothing else.
bool is_number(const Formula& formula);

/// Returns true if the text uses the variable. An invalid text uses none.
bool uses(const Formula& formula, const std::string& variable);

/// Compiled formula. Copies share it; a lock admits one thread at a time.
class Compiled {
 public:
  /// Throws InputError at the first invalid character of the formula.
  Compiled(const Formula& formula, std::span<const std::string_view> variables);

  /// Returns the value for these values of the variables, in their order. Throws InputError if it is not finite.
  double operator()(std::initializer_list<double> values) const;

  /// Returns true if the formula is the number 0 everywhere.
  bool is_zero() const;

 private:
  struct Expression;
  double number_ = 0;
  std::shared_ptr<Expression> expression_;  ///< null for a number
};

}  // namespace keyblock
