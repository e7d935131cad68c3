// Contents of files turned into another format: what is written, and what the target cannot hold.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/case.hpp"
#include "study/convert/losses.hpp"

namespace keyblock::study {

/// One or two formats that together hold a case, and the name endings of their files.
struct Target {
  std::string_view name;      ///< for the user
  std::string_view sentence;  ///< what it is
  struct Part {
    const formats::Format* format;
    std::string_view ending;
    formats::LeftOut (*left_out)(const formats::Content&) = nullptr;  ///< of a view, from which nothing is read back
  };
  std::vector<Part> parts;
};

/// Every format that is written, singly, then the pairs of the old programs.
const std::vector<Target>& targets();
/// Returns the target by its name, or by the ending of its one file without the dot ("json"; the first target with that
/// ending). Null for a word that is neither.
const Target* find_target(std::string_view word);
/// The same; throws std::invalid_argument that lists the names, and says which is near, for a word that is neither.
const Target& target_named(std::string_view word);
/// All names, joined by commas.
std::string target_names();

struct ConvertedFile {
  const formats::Format* format = nullptr;
  std::string_view ending;
  std::string text;
};

struct Conversion {
  std::vector<ConvertedFile> files;
  formats::ReadHint hint;  ///< what a reader of one of the files alone must be told
  std::vector<Loss> losses;
  Warnings warnings;
  Warnings changed_rules;  ///< by which a run of what is written goes, though it says the same
};

enum class Faults { none, berkeley };

/// Lines are cut where the target holds blocks, blocks and covers become their edges where it holds lines, loops of a
/// cover become blocks: each said as a loss. A file already in the target's format whose content stays comes out with
/// the same bytes; comments of any other are dropped with a warning.
/// `Faults::berkeley` takes the files as the Berkeley program does (berkeley_faults.hpp).
/// Throws the InputError of a file that cannot be read, or where nothing of the files fits the target.
Conversion convert(const std::vector<formats::FileReading>& files, const Target& target, Faults faults);

}  // namespace keyblock::study
