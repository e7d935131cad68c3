// Reads a JSON text into values that know their place; hides nlohmann's parser.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/format.hpp"
#include "formats/text/tokens.hpp"

namespace keyblock::formats {

class JsonText;

enum class JsonKind : std::uint8_t { null, no, yes, number, string, array, object };

/// Value of a text. Refers to the text, which must outlive it.
class JsonValue {
 public:
  JsonValue(const JsonText& text, std::size_t node) : text_(&text), node_(node) {}

  JsonKind kind() const;
  Place place() const;
  std::size_t file_size() const;    ///< bytes of the whole text
  const Units& units() const;       ///< declared by the text
  double number() const;            ///< of a number
  std::string_view string() const;  ///< of a string

  /// Iterates over the items of an array, in order; for an object over its keys and values in turn.
  class Iterator {
   public:
    Iterator(const JsonText& text, std::size_t node) : text_(&text), node_(node) {}
    JsonValue operator*() const { return {*text_, node_}; }
    Iterator& operator++();
    bool operator==(const Iterator& other) const { return node_ == other.node_; }

   private:
    const JsonText* text_;
    std::size_t node_;
  };
  Iterator begin() const { return {*text_, node_ + 1}; }
  Iterator end() const;

  /// Returns the value of a key of an object; nothing if it is absent.
  std::optional<JsonValue> member(std::string_view key) const;

  /// Throws InputError at an object without a required key: `expected …, found none`.
  [[noreturn]] void fail_missing(std::string_view expected) const;

  /// Throws InputError at this value: `expected …, found …`, with the text found here.
  [[noreturn]] void fail(std::string_view expected) const;

 private:
  friend class JsonText;

  const JsonText* text_;
  std::size_t node_;
};

/// Well-formed JSON text. Comments as in C++ are skipped, and so is a comma after the last item of a list. A value
/// takes two words of memory. Refers to the source, which must outlive it.
class JsonText {
 public:
  /// Throws InputError at the place where the text stops being well-formed, or nests deeper than any case file does.
  explicit JsonText(const Source& source);

  /// Makes a text without values, for a reader of another language (case_file/yaml_text.hpp).
  struct Unread {};
  JsonText(const Source& source, Unread /*unread*/);

  JsonValue root() const { return {*this, 0}; }

  /// Replaces a string by a number.
  void replace(const JsonValue& string, double number);
  /// Sets the units of its numbers, after they are read.
  void declare(const Units& units) { units_ = units; }

 private:
  friend class JsonValue;
  friend class JsonReader;
  friend class YamlReader;  // case_file/yaml_text.cpp

  struct Node {
    std::uint64_t offset : 56;  ///< in the text
    std::uint64_t kind : 8;
    union {
      double number;
      std::uint64_t end;  ///< of an array or object: the node after its last
      struct {
        std::uint32_t length;
        std::uint32_t first;  ///< in `strings_`
      } string;
    };
  };

  TextMap map_;
  std::size_t size_;         ///< of the text
  std::vector<Node> nodes_;  ///< each before its items
  std::string strings_;      ///< concatenated, escapes resolved
  Units units_;
};

}  // namespace keyblock::formats
