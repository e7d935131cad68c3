// Defines errors of input, command line and output, which stop a run, and warnings, which do not.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/words/finding.hpp"

namespace keyblock {

/// Name of a file, stored once for all places in it: a problem has one for every line of its drawing.
class FileName {
 public:
  FileName() = default;
  FileName(std::string text) : text_(std::make_shared<const std::string>(std::move(text))) {}
  FileName(const char* text) : FileName(std::string(text)) {}

  const std::string& text() const {
    static const std::string kNone;
    return text_ ? *text_ : kNone;
  }
  operator const std::string&() const { return text(); }
  friend bool operator==(const FileName& a, const FileName& b) { return a.text_ == b.text_ || a.text() == b.text(); }

 private:
  std::shared_ptr<const std::string> text_;
};

/// Place in a text file; line and column count from 1, 0 means "the file as a whole".
struct Place {
  FileName file;
  int line = 0;
  int column = 0;

  bool operator==(const Place&) const = default;
};

/// Returns "file:line:column", shortened if line or column is unknown.
std::string to_string(const Place& place);

/// Unusable input. `what()` is `file:line:column: error: expected …, found …`; exit code 3.
class InputError : public std::runtime_error {
 public:
  InputError(Place place, const std::string& sentence);

  const Place& place() const { return place_; }
  const std::string& sentence() const { return sentence_; }

 private:
  Place place_;
  std::string sentence_;
};

/// Usable input that is likely a mistake. `name` is a stable identifier (snake_case) by which warnings are counted and
/// tested; `facts` are the values behind the sentence.
struct Warning {
  std::string name;
  Place place;
  std::string sentence;
  Facts facts = {};

  bool operator==(const Warning&) const = default;
};

using Warnings = std::vector<Warning>;

/// Adds a warning about one record of many. A list that holds `kMostWarnings` takes one more, which states that the
/// rest is not listed. It then takes no more, because a file may have a mistake in every record.
void add_warning(Warnings& warnings, Warning warning);
inline constexpr std::size_t kMostWarnings = 1000;

/// Returns both lists, in that order.
inline Warnings joined(Warnings first, const Warnings& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Returns `file:line:column: level: sentence [name]`; the level is that of the code: error, warning or note.
std::string to_string(const Warning& warning);

/// Request of the user that cannot be fulfilled; exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Results that cannot be written, to a full disk or to a folder removed during the run; exit code 4.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace keyblock
