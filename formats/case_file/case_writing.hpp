// Writes structs as a case file, as a visitor: objects by lines, rows on one line each, without empty lists.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/text/demands.hpp"
#include "problem/formula.hpp"

namespace keyblock::formats {

/// Writes the fields of one struct: as an object, or in one line as a row.
class CaseWriting {
 public:
  static constexpr bool is_writing = true;
  enum class Shape { object, row };

  CaseWriting(std::string& text, Shape shape, int depth);
  void finish();

  void real(std::string_view name, double value, const Demand& = {});
  template <class Integer>
  void integer(std::string_view name, Integer value, const Demand&) {
    next(name);
    text_ += std::to_string(value);
  }
  void index(std::string_view name, int value) { integer(name, static_cast<long long>(value) + 1, {}); }
  void optional_index(std::string_view name, const std::optional<int>& value) {
    if (value) index(name, *value);
  }
  void flag(std::string_view name, bool value);
  void text(std::string_view name, const std::string& value);
  void name_at_end(std::string_view name, const Rare<std::string>& value) {
    if (value) text(name, *value);
  }
  static void mass_by(std::string_view, std::string_view, const Units&) {}
  void name(std::string_view) {}
  template <class Material>
  void of_library(std::string_view, const Material&) {}
  template <class T>
  void object_or_file(std::string_view name, const std::optional<T>& value, const std::string&, const Place&) {
    if (value) object(name, *value);
  }
  static Analysis start_of_analysis() { return {}; }
  void formula(std::string_view name, const Formula& formula);
  void optional_formula(std::string_view name, const std::optional<Formula>& formula);
  template <class Enum>
  void word(std::string_view name, Enum value, std::span<const std::string_view> words) {
    text(name, std::string(words[static_cast<std::size_t>(value)]));
  }
  template <class Enum>
  void optional_word(std::string_view name, const std::optional<Enum>& value, std::span<const std::string_view> words) {
    if (value) word(name, *value, words);
  }
  void optional_real(std::string_view name, const std::optional<double>& value, const Demand&);
  void optional_integer(std::string_view name, const std::optional<int>& value, const Demand&);

  template <class T>
  void row(std::string_view name, const T& value) {
    next(name);
    put(value, Shape::row);
  }
  template <class T>
  void optional_row(std::string_view name, const std::optional<T>& value) {
    if (value) row(name, *value);
  }
  template <class T>
  void object(std::string_view name, const T& value) {
    next(name);
    put(value, Shape::object);
  }
  template <class T>
  void optional_object(std::string_view name, const std::optional<T>& value, const T& /*start*/ = {}) {
    if (value) object(name, *value);
  }
  template <class T>
  void rows(std::string_view name, const std::vector<T>& values, std::optional<std::size_t> least = std::nullopt) {
    list(name, values, least, [](CaseWriting& to, const T& value) { to.put(value, Shape::row); });
  }
  template <class T>
  void objects(std::string_view name, const std::vector<T>& values) {
    list(name, values, std::nullopt, [](CaseWriting& to, const T& value) { to.put(value, Shape::object); });
  }
  template <class T>
  void lists(std::string_view name, const std::vector<std::vector<T>>& values,
             std::optional<std::size_t> least = std::nullopt) {
    list(name, values, least, [](CaseWriting& to, const std::vector<T>& rows) {
      to.put_list(rows, [](CaseWriting& into, const T& value) { into.put(value, Shape::row); });
    });
  }
  void curve(std::string_view name, const TimeCurve& curve);
  void optional_curve(std::string_view name, const std::optional<TimeCurve>& curve);
  void curves(std::string_view name, const std::vector<TimeCurve>& curves);
  void pairs(std::string_view name, const std::vector<std::pair<std::string, std::string>>& pairs);

 private:
  void next(std::string_view name);
  void new_line(int depth);
  void quote(std::string_view value);
  void put_curve(const TimeCurve& curve);

  template <class T>
  void put(const T& value, Shape shape) {
    CaseWriting part(text_, shape, depth_ + 1);
    describe(part, value);
    part.finish();
  }
  template <class T, class Put>
  void put_list(const std::vector<T>& values, Put put_one) {
    text_ += '[';
    ++depth_;
    bool first = true;
    for (const T& value : values) {
      if (!std::exchange(first, false)) text_ += ',';
      new_line(depth_ + 1);
      put_one(*this, value);
    }
    --depth_;
    if (!values.empty()) new_line(depth_ + 1);
    text_ += ']';
  }
  template <class T, class Put>
  void list(std::string_view name, const std::vector<T>& values, std::optional<std::size_t> least, Put put_one) {
    if (values.empty() && !least) return;
    next(name);
    put_list(values, put_one);
  }

  std::string& text_;
  Shape shape_;
  int depth_;
  bool is_first_ = true;
};

}  // namespace keyblock::formats
