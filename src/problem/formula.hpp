// A number that a file gives, or an expression of the place that stands for it.
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

/// As it was written. Operators + - * / ^, comparisons, && || and ?:, functions (sin, cos, atan2, sqrt, exp, ln, log10,
/// abs, min, max, …), the constants _pi and _e, and the variables of its use: it can reach nothing else.
struct Formula {
  std::string text = "0";
  Place place = {};  ///< of the value: the opening quote of a text

  bool operator==(const Formula& other) const { return text == other.text; }
};

/// True if the text is one finite number and nothing else.
bool is_number(const Formula& formula);

/// A formula ready to be computed. Copies share it: not for two threads at once.
class Compiled {
 public:
  /// Throws InputError at the character of the formula that makes no sense.
  Compiled(const Formula& formula, std::span<const std::string_view> variables);

  /// The value where the variables, in their order, have these values. Throws InputError where it is not finite.
  double operator()(std::initializer_list<double> values) const;

  /// Whether it is the number 0, wherever it is asked for.
  bool is_zero() const;

 private:
  struct Expression;
  double number_ = 0;
  std::shared_ptr<Expression> expression_;  ///< none for a number
};

}  // namespace keyblock
