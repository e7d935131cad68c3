// A JSON text whose values know their place; nlohmann's parser stays behind this file.
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

/// One value of a text. Views it: keep the text alive.
class JsonValue {
 public:
  JsonValue(const JsonText& text, std::size_t node) : text_(&text), node_(node) {}

  JsonKind kind() const;
  Place place() const;
  std::size_t file_size() const;    ///< bytes of the whole text
  const Units& units() const;       ///< that the text declares
  double number() const;            ///< of a number
  std::string_view string() const;  ///< of a string

  /// What stands in an array, in order; for an object its keys and values in turn.
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

  /// The value of a key of an object; nothing where it is absent.
  std::optional<JsonValue> member(std::string_view key) const;

  /// Throws InputError at an object that lacks a key: `expected …, found none`.
  [[noreturn]] void fail_missing(std::string_view expected) const;

  /// Throws InputError here: `expected …, found …`, with what stands here.
  [[noreturn]] void fail(std::string_view expected) const;

 private:
  friend class JsonText;

  const JsonText* text_;
  std::size_t node_;
};

/// A well-formed JSON text; comments as in C++ are passed over, and so is a comma behind the last of a list. Two words
/// of memory a value. Views the source: keep it alive.
class JsonText {
 public:
  /// Views the source: keep that alive. Throws InputError at the place where the text stops being well-formed, or nests
  /// deeper than any case file does.
  explicit JsonText(const Source& source);

  /// Without values yet, for a reader of another language (case_file/yaml_text.hpp).
  struct Unread {};
  JsonText(const Source& source, Unread /*unread*/);

  JsonValue root() const { return {*this, 0}; }

  /// Puts a number where a string stood.
  void replace(const JsonValue& string, double number);
  /// The units of its numbers, once they are read.
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
      std::uint64_t end;  ///< of an array or object: the node behind its last
      struct {
        std::uint32_t length;
        std::uint32_t first;  ///< in `strings_`
      } string;
    };
  };

  TextMap map_;
  std::size_t size_;         ///< of the text
  std::vector<Node> nodes_;  ///< each before what stands in it
  std::string strings_;      ///< one behind the other, escapes resolved
  Units units_;
};

}  // namespace keyblock::formats
