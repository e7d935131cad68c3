// Fills structs from a case file as a visitor: unknown keys and missing values are errors at their place.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "formats/case_file/material_library.hpp"
#include "formats/case_file/number_fields.hpp"
#include "problem/units/unit_names.hpp"

namespace keyblock::formats {

/// Reads the fields of one JSON value into one struct.
class CaseReading : public NumberFields {
 public:
  static constexpr bool is_writing = false;

  using NumberFields::NumberFields;

  /// Selects the defaults of an analysis: those of version 1 of the layout, or after this call those of version 2.
  void take_defaults_of_today() { is_of_today_ = true; }
  Analysis start_of_analysis() const;

  void flag(std::string_view name, bool& value);
  void text(std::string_view name, std::string& value);
  /// Reads the name at the end of a row, which may lack it.
  void name_at_end(std::string_view name, Rare<std::string>& value);
  /// Reads a unit of force or stress, from which that of mass follows.
  void mass_by(std::string_view force, std::string_view stress, Units& units);
  /// Accepts a word by which other parts of the file refer to this one; it is not stored.
  void name(std::string_view name);
  /// Takes the values of a library material, if the key names one; values next to it override them.
  template <class Material>
  void of_library(std::string_view name, Material& material) {
    std::string wanted;
    text(name, wanted);
    if (wanted.empty()) return;
    if (const std::string why = take_from_library(wanted, from_.units(), material); !why.empty()) value_->fail(why);
  }
  /// Reads an object, or the name of a file that holds it.
  template <class T>
  void object_or_file(std::string_view name, std::optional<T>& value, std::string& file, Place& place) {
    if (!take(name)) return;
    if (value_->kind() == JsonKind::string) {
      file = value_->string();
      place = value_->place();
      if (file.empty()) value_->fail(fmt::format("{}: the name of a file, such as \"slope.dxf\"", name));
    } else {
      fill(of_kind(JsonKind::object, name), name, value.emplace());
    }
  }
  template <class Enum>
  void word(std::string_view name, Enum& value, std::span<const std::string_view> words) {
    std::string found(words[static_cast<std::size_t>(value)]);
    text(name, found);
    const auto at = std::ranges::find(words, found);
    if (at == words.end()) value_->fail(fmt::format("{} of {}: one of {}", name, noun_, fmt::join(words, ", ")));
    value = static_cast<Enum>(at - words.begin());
  }
  template <class Enum>
  void optional_word(std::string_view name, std::optional<Enum>& value, std::span<const std::string_view> words) {
    if (from_.member(name)) word(name, value ? *value : value.emplace(), words);
  }

  template <class T>
  void row(std::string_view name, T& value) {
    if (take(name)) fill(of_kind(JsonKind::array, name), name, value);
  }
  template <class T>
  void optional_row(std::string_view name, std::optional<T>& value) {
    if (take(name)) fill(of_kind(JsonKind::array, name), name, value.emplace());
  }
  template <class T>
  void object(std::string_view name, T& value) {
    if (take(name)) fill(of_kind(JsonKind::object, name), name, value);
  }
  template <class T>
  void optional_object(std::string_view name, std::optional<T>& value, const T& start = {}) {
    if (take(name)) fill(of_kind(JsonKind::object, name), name, value.emplace(start));
  }
  template <class T>
  void rows(std::string_view name, std::vector<T>& values, std::optional<std::size_t> least = std::nullopt) {
    list(name, JsonKind::array, values);
    require(name, values.size(), least);
  }
  template <class T>
  void objects(std::string_view name, std::vector<T>& values) {
    list(name, JsonKind::object, values);
  }
  template <class T>
  void lists(std::string_view name, std::vector<std::vector<T>>& values,
             std::optional<std::size_t> least = std::nullopt) {
    if (take(name)) {
      values.reserve(size_of(of_kind(JsonKind::array, name)));
      for (const JsonValue item : *value_) fill_list(item, name, JsonKind::array, values.emplace_back());
    }
    require(name, values.size(), least);
  }
  void curve(std::string_view name, TimeCurve& curve);
  void optional_curve(std::string_view name, std::optional<TimeCurve>& curve);
  void curves(std::string_view name, std::vector<TimeCurve>& curves);
  void pairs(std::string_view name, std::vector<std::pair<std::string, std::string>>& pairs);

 private:
  static constexpr std::size_t kMostRoom = 12;  // over the size of the file, reserved at once for a list

  template <class T>
  static void fill(const JsonValue& from, std::string_view noun, T& value) {
    CaseReading reading(from, noun);
    describe(reading, value);
    reading.finish();
    if constexpr (requires { value.place.line; }) value.place = from.place();
  }
  template <class T>
  void list(std::string_view name, JsonKind kind, std::vector<T>& values) {
    if (take(name)) fill_list(*value_, name, kind, values);
  }
  template <class T>
  void fill_list(const JsonValue& from, std::string_view name, JsonKind kind, std::vector<T>& values) {
    if (from.kind() != JsonKind::array) from.fail(fmt::format("{}: an array", name));
    // Reserves space if the items take about as much memory as text; a growing vector would hold three times as much.
    if (const std::size_t size = size_of(from); size * sizeof(T) <= kMostRoom * from.file_size()) values.reserve(size);
    for (const JsonValue item : from) {
      if (item.kind() != kind)
        item.fail(fmt::format("{}: an array of {}", name, kind == JsonKind::array ? "arrays" : "objects"));
      fill(item, name, values.emplace_back());
    }
  }
  static TimeCurve curve_of(const JsonValue& from, std::string_view name);

  bool is_of_today_ = false;
};

}  // namespace keyblock::formats
