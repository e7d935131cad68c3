// Numbers that know their place in a text, and the one cursor every reader walks over them with.
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

namespace keyblock::formats {

/// Offsets of a text to line and column (bytes, both from 1). LF, CRLF and a lone CR all end a line. Views the text:
/// lines are counted when a place is asked for, from the nearest place before that is known.
class TextMap {
 public:
  TextMap(FileName file, std::string_view text) : file_(std::move(file)), text_(text) {}
  Place place(std::size_t offset) const;
  const FileName& file() const { return file_; }

 private:
  /// Where a stretch of the text begins: its line, and the offset at which that line begins.
  struct Mark {
    std::size_t line;
    std::size_t line_start;
  };
  Mark advanced(Mark mark, std::size_t first, std::size_t last) const;

  FileName file_;
  std::string_view text_;
  mutable std::mutex guard_;         ///< of the marks: threads that read one text may fail at once
  mutable std::vector<Mark> marks_;  ///< one a stretch of text, as far as places were asked for
};

/// The text without its UTF-8 byte order mark.
std::string_view without_bom(std::string_view text);

/// The word in quotes as it may stand in a message: short, and printable whatever the file holds.
std::string in_quotes(std::string_view word);

/// A list that `resize` does not fill: its numbers are written by several threads.
template <typename T>
struct Unfilled : std::allocator<T> {
  template <typename U>
  struct rebind {
    using other = Unfilled<U>;
  };
  void construct(T* place) { ::new (place) T; }
};
using Numbers = std::vector<double, Unfilled<double>>;

/// A text as a leading run of numbers and whatever follows it. Views the text: keep that alive. Little more than one
/// double a token, because files of a hundred megabytes are read through it: only every so many-th word's offset is
/// kept.
struct Tokens {
  /// A word and the offset it begins at; no piece of text begins between it and the next mark.
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

  /// The offset of a word, index below `word_count`; found from the mark before it.
  std::size_t start_of(std::size_t index) const;
  std::string_view word(std::size_t index) const;
  /// First word that is no number; `pen=0.1*g0` in mf13, `nan` anywhere.
  std::optional<std::string_view> junk() const;
  Place place_of(std::size_t index) const;
};

/// The first run of characters from `at` on that only white space and comments of a native text part: commas belong to
/// it. Empty where none is left.
std::string_view next_run(std::string_view text, std::size_t at);

inline bool is_whole(double value) {
  return value >= -2147483647 && value <= 2147483647 && static_cast<double>(static_cast<int>(value)) == value;
}

/// What a number must satisfy, and the words by which a message says so.
struct Demand {
  bool (*holds)(double value);
  std::string_view wording;
};

/// The record being read, for messages: "line 3 of 30".
struct Record {
  std::string_view noun;
  std::size_t number = 0;  ///< from 1; 0: the record is the only one
  std::size_t of = 0;
};

/// Walks over tokens by name. Every failure is `expected NAME of RECORD, found …` at the token.
class Cursor {
 public:
  /// `end_name` says what running out of tokens is called: "end of file", "end of element".
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
  /// An integer ≥ 0 that announces as many records; refused where fewer words than that follow, so that
  /// nothing is ever allocated for records that cannot exist.
  int next_count(std::string_view name);
  /// The same where a part of something already counted is announced: `whole` in words, "the number of
  /// lines".
  int next_count_up_to(int limit, std::string_view whole, std::string_view name);
  /// A number counted from 1 in the file, given from 0.
  int next_index(std::string_view name) { return next_integer(name) - 1; }

  /// Passes over numbers that something else reads; no further than they go.
  void skip(std::size_t count) { position_ += std::min(count, numbers_left()); }

  std::size_t position() const { return position_; }
  std::size_t numbers_left() const { return tokens_.numbers.size() - position_; }
  bool at_end() const { return position_ == tokens_.word_count; }
  Place place() const { return tokens_.place_of(position_); }
  /// Throws InputError at the next token.
  [[noreturn]] void fail(std::string_view expected) const;
  /// What stands behind the last record: surplus numbers and trailing text, each as a warning.
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
