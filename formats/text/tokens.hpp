// Holds numbers that know their place in a text, and the cursor with which every reader walks over them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "formats/format.hpp"
#include "formats/text/splitter.hpp"
#include "problem/limits.hpp"

namespace keyblock::formats {

/// Converts offsets of a text to line and column (bytes, both from 1). LF, CRLF and a lone CR all end a line. Refers to
/// the text. Lines are counted on request, from the nearest known place before.
class TextMap {
 public:
  TextMap(FileName file, std::string_view text) : file_(std::move(file)), text_(text) {}
  Place place(std::size_t offset) const;
  const FileName& file() const { return file_; }

 private:
  /// Start of a part of the text: its line, and the offset at which that line begins.
  struct Mark {
    std::size_t line;
    std::size_t line_start;
  };
  Mark advanced(Mark mark, std::size_t first, std::size_t last) const;

  FileName file_;
  std::string_view text_;
  mutable std::mutex guard_;         ///< for the marks: threads that read one text may fail at once
  mutable std::vector<Mark> marks_;  ///< one per part of the text, up to the last requested place
};

/// Returns the text without its UTF-8 byte order mark.
std::string_view without_bom(std::string_view text);

/// Returns the word in quotes for a message: short, and printable even if the file is not.
std::string in_quotes(std::string_view word);

/// Allocator of a list that `resize` does not fill: several threads write its numbers.
template <typename T>
struct Unfilled : std::allocator<T> {
  template <typename U>
  struct rebind {
    using other = Unfilled<U>;
  };
  void construct(T* place) { ::new (place) T; }
};
using Numbers = std::vector<double, Unfilled<double>>;

/// Text as leading numbers and the words after them. Refers to the text, which must outlive it. It takes little more
/// than one double per token, because files of a hundred megabytes are read through it: only the offset of every n-th
/// word is kept.
struct Tokens {
  /// Word and the offset at which it begins; no piece of text begins between it and the next mark.
  struct Mark {
    std::size_t word = 0;
    std::size_t offset = 0;
  };

  std::shared_ptr<const TextMap> map;
  std::string_view text;
  Syntax syntax = Syntax::native;
  std::size_t end = 0;         ///< offset at which the text ends
  std::size_t word_count = 0;  ///< words: runs of characters between separators
  Numbers numbers = {};        ///< the leading words that are finite numbers
  std::vector<Mark> marks = {};

  /// Returns the offset of a word, index below `word_count`, counted from the mark before it.
  std::size_t start_of(std::size_t index) const;
  std::string_view word(std::size_t index) const;
  /// Returns the first word that is not a number, such as `pen=0.1*g0` in mf13, or `nan`.
  std::optional<std::string_view> junk() const;
  Place place_of(std::size_t index) const;
};

/// Returns the first run of characters from `at` on that only white space and comments of a native text separate:
/// commas belong to it. Empty if none is left.
std::string_view next_run(std::string_view text, std::size_t at);

constexpr bool is_whole(double value) {
  return value >= -2147483647 && value <= 2147483647 && static_cast<double>(static_cast<int>(value)) == value;
}

/// Condition on a number, and its words in a message.
struct Demand {
  Range range;
  std::string_view wording;
  bool whole = false;
  std::optional<double> except = {};  ///< in the range, and not permitted

  constexpr bool holds(double value) const {
    return range.has(value) && (!whole || is_whole(value)) && !(except && value == *except);
  }
};

/// Record that is being read, for messages: "line 3 of 30".
struct Record {
  std::string_view noun;
  std::size_t number = 0;  ///< from 1; 0: the record is the only one
  std::size_t of = 0;
};

/// Walks over tokens by name. Every failure is `expected NAME of RECORD, found …` at the token.
class Cursor {
 public:
  /// `end_name` names the end of the tokens in messages: "end of file", "end of element".
  explicit Cursor(const Tokens& tokens, std::string_view end_name = "end of file")
      : tokens_(tokens), end_name_(end_name) {}

  void enter(Record record) { record_ = record; }
  void leave() { record_.reset(); }

  double next_real(std::string_view name) {
    if (numbers_left() == 0) fail(full_name(name));
    return tokens_.numbers[position_++];
  }
  double next_real(std::string_view name, const Demand& demand);
  double next_real_above(double limit, std::string_view name);
  int next_integer(std::string_view name) {
    if (numbers_left() > 0 && !is_whole(tokens_.numbers[position_])) fail_whole(name);
    return static_cast<int>(next_real(name));
  }
  int next_integer(std::string_view name, const Demand& demand);
  int next_integer_between(int least, int most, std::string_view name) {
    if (numbers_left() == 0) fail_between(least, most, name);
    const double value = tokens_.numbers[position_];
    if (!is_whole(value) || value < least || value > most) fail_between(least, most, name);
    ++position_;
    return static_cast<int>(value);
  }
  /// Reads an integer ≥ 0 that announces a number of records. Throws InputError if fewer words follow: no memory is
  /// allocated for records that cannot exist.
  int next_count(std::string_view name);
  /// Does the same for a part of a quantity that was counted before: `whole` in words, "the number of lines".
  int next_count_up_to(int limit, std::string_view whole, std::string_view name);
  /// Reads a number counted from 1 in the file; returns it from 0.
  int next_index(std::string_view name) { return next_integer(name) - 1; }

  /// Skips numbers that another reader reads, at most to their end.
  void skip(std::size_t count) { position_ += std::min(count, numbers_left()); }

  std::size_t position() const { return position_; }
  std::size_t numbers_left() const { return tokens_.numbers.size() - position_; }
  bool at_end() const { return position_ == tokens_.word_count; }
  Place place() const { return tokens_.place_of(position_); }
  /// Throws InputError at the next token.
  [[noreturn]] void fail(std::string_view expected) const;
  /// Returns a warning each for surplus numbers and for trailing text after the last record.
  Warnings remainder() const;

 private:
  [[noreturn]] void fail_whole(std::string_view name) const;
  [[noreturn]] void fail_between(int least, int most, std::string_view name) const;
  std::string full_name(std::string_view name) const;
  std::string found() const;

  const Tokens& tokens_;
  std::string_view end_name_;
  std::size_t position_ = 0;
  std::optional<Record> record_;
};

}  // namespace keyblock::formats
