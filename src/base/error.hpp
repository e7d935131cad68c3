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

/// Name of a file, stored once for all places in it: a problem has one for every line of its drawing. It may also name
/// a choice of the caller, such as `--history`, with its value.
class FileName {
 public:
  FileName() = default;
  FileName(std::string text) : kept_(std::make_shared<const Kept>(Kept{std::move(text), {}})) {}
  FileName(const char* text) : FileName(std::string(text)) {}
  /// `choice`: as an option of the command, without dashes.
  static FileName of_choice(const std::string& choice, const std::string& value) {
    FileName name;
    name.kept_ = std::make_shared<const Kept>(Kept{"--" + choice + " " + value, choice});
    return name;
  }

  const std::string& text() const { return kept().text; }
  operator const std::string&() const { return text(); }
  /// Returns the choice; empty for a file.
  const std::string& choice() const { return kept().choice; }
  /// Returns the value of a choice.
  std::string value() const { return choice().empty() ? std::string() : text().substr(choice().size() + 3); }
  friend bool operator==(const FileName& a, const FileName& b) { return a.kept_ == b.kept_ || a.text() == b.text(); }

 private:
  struct Kept {
    std::string text, choice;
  };
  const Kept& kept() const {
    static const Kept kNone;
    return kept_ ? *kept_ : kNone;
  }

  std::shared_ptr<const Kept> kept_;
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

/// Choice of the caller that cannot be fulfilled, or that would help. Each front (command, library, Python) has its own
/// word for the choice; `what()` has that of the command.
class ChoiceError : public UsageError {
 public:
  /// `choice`: as an option of the command, without dashes. The message is `before`, the word, `after`.
  ChoiceError(std::string choice, std::string before, std::string after)
      : UsageError(before + "--" + choice + after),
        choice_(std::move(choice)),
        before_(std::move(before)),
        after_(std::move(after)) {}
  /// Message "--choice: sentence".
  ChoiceError(std::string choice, const std::string& sentence) : ChoiceError(std::move(choice), {}, ": " + sentence) {}

  const std::string& choice() const { return choice_; }
  const std::string& before() const { return before_; }
  const std::string& after() const { return after_; }

 private:
  std::string choice_, before_, after_;
};

/// Results that cannot be written, to a full disk or to a folder removed during the run; exit code 4.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace keyblock
