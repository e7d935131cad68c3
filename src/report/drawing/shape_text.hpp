// Collects elements of an SVG document; consecutive ones of one style share it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/point.hpp"

namespace keyblock::report {

class ShapeText {
 public:
  /// Adds `<element style rest`. `rest` is `/>`, or `>`, content and the closing tag.
  void add(std::string_view element, std::string_view style, std::string_view rest = "/>");

  /// Adds text as it is.
  void add_plain(std::string_view text);

  /// Adds the elements of another text.
  void append(ShapeText&& other);

  std::size_t size() const { return text_.size() + run_.size(); }
  std::string str() const;

 private:
  void end_run();

  std::string text_;
  // Elements of one style, in a group as soon as there are two.
  std::string run_;
  std::string style_;
  std::size_t count_ = 0;
  std::size_t place_ = 0;  ///< of the style within the first element
};

/// Returns the text of a page coordinate; hundredths are finer than any screen.
std::string page_number(double value);

/// Returns the text of points: "1,2 3.5,4".
std::string coordinates(const std::vector<Point>& points);

}  // namespace keyblock::report
