// A run of elements of one style ends with the first element of another one.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/shape_text.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>

namespace keyblock::report {
namespace {

void add_number(std::string& text, double value) {
  std::array<char, 400> buffer{};  // room for the greatest number
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, 2);
  if (error != std::errc()) return;
  std::string_view digits(buffer.data(), end);
  digits.remove_suffix(digits.size() - 1 - digits.find_last_not_of('0'));
  if (digits.ends_with('.')) digits.remove_suffix(1);
  text += digits == "-0" ? "0" : digits;
}

}  // namespace

void ShapeText::add(std::string_view element, std::string_view style, std::string_view rest) {
  if (count_ == 0 || style != style_) {
    end_run();
    style_ = style;
    place_ = element.size();
  }
  run_ += element;
  run_ += rest;
  run_ += '\n';
  ++count_;
}

void ShapeText::add_plain(std::string_view text) {
  end_run();
  text_ += text;
}

void ShapeText::append(ShapeText&& other) {
  other.end_run();
  add_plain(other.text_);
}

std::string ShapeText::str() const {
  ShapeText whole = *this;
  whole.end_run();
  return std::move(whole.text_);
}

void ShapeText::end_run() {
  if (count_ == 1)
    text_ += run_.insert(place_, style_);
  else if (count_ > 1)
    text_ += fmt::format("<g{}>\n{}</g>\n", style_, run_);
  run_.clear();
  count_ = 0;
}

std::string page_number(double value) {
  std::string text;
  add_number(text, value);
  return text;
}

std::string coordinates(const std::vector<Point>& points) {
  std::string text;
  text.reserve(14 * points.size());
  for (const Point p : points) {
    if (!text.empty()) text += ' ';
    add_number(text, p.x);
    text += ',';
    add_number(text, p.y);
  }
  return text;
}

}  // namespace keyblock::report
