// Converts file contents into another format and lists what the target cannot hold.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/case.hpp"
#include "study/convert/losses.hpp"

namespace keyblock::study {

/// One or two formats that together hold a case, with the endings of their files.
struct Target {
  std::string_view name;      ///< for the user
  std::string_view sentence;  ///< description
  struct Part {
    const formats::Format* format;
    std::string_view ending;
    formats::LeftOut (*left_out)(const formats::Content&) = nullptr;  ///< for a view, from which nothing is read back
  };
  std::vector<Part> parts;
};

/// Returns every writable format alone, then the pairs of Shi's programs.
const std::vector<Target>& targets();
/// Returns the target by its name, or by the ending of its one file without the dot ("json"; the first target with that
/// ending). Null for other words.
const Target* find_target(std::string_view word);
/// Returns the same; throws std::invalid_argument for other words, with the names and a similar one.
const Target& target_named(std::string_view word);
/// Returns all names, separated by commas.
std::string target_names();

struct ConvertedFile {
  const formats::Format* format = nullptr;
  std::string_view ending;
  std::string text;
};

/// File of a target that is not written, because the case has nothing that its format holds.
struct UnwrittenFile {
  std::string_view ending;
  std::string reason;
};

struct Conversion {
  std::vector<ConvertedFile> files;
  std::vector<UnwrittenFile> unwritten;
  formats::ReadHint hint;  ///< data that a reader of one of the files alone needs
  std::vector<Loss> losses;
  Warnings warnings;
  Warnings changed_rules;  ///< rules of a run of the written files that differ, although the data are the same
};

enum class Faults { none, berkeley };

/// Converts the files. Lines are cut if the target holds blocks; blocks and covers become their edges if it holds
/// lines; loops of a cover become blocks. Each is reported as a loss. A file already in the target's format with
/// unchanged content keeps its bytes; other comments are dropped with a warning. `Faults::berkeley` reads the files as
/// the Berkeley program does (berkeley_faults.hpp). Settings then name files relative to `folder`, unless that is
/// empty. Throws the InputError of an unreadable file, or one if nothing fits the target.
Conversion convert(const std::vector<formats::FileReading>& files, const Target& target, Faults faults,
                   const std::filesystem::path& folder = {});

}  // namespace keyblock::study
