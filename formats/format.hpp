// The record every file format fills in: how it is recognised, read and written.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/error.hpp"
#include "problem/analysis.hpp"
#include "problem/blocks.hpp"
#include "problem/drawing.hpp"

namespace keyblock::formats {

/// A file in memory: the name it is reported under, and its bytes.
struct Source {
  std::string name;
  std::string text;
};

/// What a file can hold. DDAML may hold a drawing and an analysis in one file.
struct Content {
  std::optional<Drawing> drawing;
  std::optional<Blocks> blocks;
  std::optional<Analysis> analysis;
};

/// What reading gives: the content and everything odd that was met on the way.
struct Reading {
  Content content;
  Warnings warnings;
};

/// How sure a format is that a file is its own, and from what it concludes so (one sentence for the user).
struct Recognition {
  enum class Fit { none, surplus, exact };
  Fit fit = Fit::none;
  std::string evidence;
};

/// One format. A missing function means "cannot".
struct Format {
  std::string_view name;   ///< stable identifier, e.g. "dda-geometry"
  std::string_view title;  ///< one line for people
  Recognition (*recognise)(const Source&) = nullptr;
  Reading (*read)(const Source&) = nullptr;  ///< throws InputError
  std::string (*write)(const Content&) =
      nullptr;  ///< content → text; throws std::invalid_argument if it lacks the part
};

}  // namespace keyblock::formats
