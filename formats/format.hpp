// Declares the record that every file format fills in: its recognition, reading and writing.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/error.hpp"
#include "problem/analysis.hpp"
#include "problem/blocks.hpp"
#include "problem/cover.hpp"
#include "problem/cover_plan.hpp"
#include "problem/drawing.hpp"
#include "problem/load_list.hpp"
#include "problem/output_plan.hpp"
#include "problem/run_choices.hpp"
#include "problem/stage.hpp"
#include "result/frame.hpp"
#include "result/measured_track.hpp"

namespace keyblock::formats {

/// File in memory: its name for messages, and its bytes.
struct Source {
  std::string name;
  std::string text;
};

/// Parts of layers of a drawing (DXF) whose names do not give them: pairs of a layer and a part in words. The reader of
/// the drawing parses the words.
struct LayerTable {
  std::vector<std::pair<std::string, std::string>> rows;
  std::vector<Place> places = {};  ///< one per row

  bool operator==(const LayerTable& other) const { return rows == other.rows; }
};

/// Names of materials, or of the layers of a drawing that hold them, by number from 0. Empty: no name.
struct MaterialNames {
  std::vector<std::string> rocks;
  std::vector<std::string> joints;
};

/// Content of a file. DDAML may hold a drawing and an analysis in one file. `motion` is a horizontal acceleration as a
/// multiple of gravity.
struct Content {
  std::optional<Drawing> drawing;
  std::optional<Blocks> blocks;
  std::optional<Analysis> analysis;
  std::optional<Cover> cover = std::nullopt;
  std::vector<Frame> frames = {};
  std::vector<MeasuredTrack> tracks = {};
  std::optional<TimeCurve> motion = std::nullopt;
  std::optional<Units> units = std::nullopt;
  std::optional<CoverPlan> covers = std::nullopt;
  std::optional<LoadList> loads = std::nullopt;
  std::optional<RunChoices> choices = std::nullopt;
  std::optional<OutputPlan> outputs = std::nullopt;
  std::vector<Stage> stages = {};
  LayerTable layers = {};
  std::optional<double> join = std::nullopt;  ///< of a case file: `DrawingChoices` of its drawing
  std::string drawing_unit = {};              ///< from a case file, too
  std::string drawing_file = {};              ///< from a case file, in its words
  Place drawing_file_place = {};
  MaterialNames names = {};  ///< for pictures; references to them are already numbers
  bool is_own_case = false;  ///< from a case file of Keyblock, not of Shi's or Berkeley's programs
};

/// Result of reading: the content and the warnings.
struct Reading {
  Content content;
  Warnings warnings;
};

enum class GeometryKind { unknown, drawing, blocks, cover };

/// Choices of a command for a drawing that it reads.
struct DrawingChoices {
  std::string unit = {};  ///< of a DXF file, instead of its own; a unit of length as case files name it
  double join = 0;  ///< ends of lines nearer than this to a line are joined to it [length, as the drawing is read]

  bool operator==(const DrawingChoices&) const = default;
};

/// Counts of the geometry without which an analysis file cannot be read. Shi's file holds a flag and a curve for each
/// fixed and each loading point, but neither number. The file of the manifold program holds a load for each loading
/// point. A drawing knows its fixed points only after cutting.
struct ReadHint {
  std::optional<int> fixed_points;
  std::optional<int> loading_points;
  GeometryKind geometry = GeometryKind::unknown;
  std::string length = "";  ///< declared by other files; others are converted to it; empty: metres
  LayerTable layers = {};   ///< declared by other files: the parts of its layers
  DrawingChoices drawing = {};
};

/// Confidence of a format that a file belongs to it, and the evidence (one sentence for the user). `damaged`: the file
/// begins like one, but the counts do not fit; its reader reports the place. `surplus`: more numbers than the counts
/// require. `variant`: exact by a known variant of the layout.
struct Recognition {
  enum class Fit { none, damaged, surplus, variant, exact };
  Fit fit = Fit::none;
  std::string evidence;
};

struct Tokens;

/// File format. A missing function means "cannot". A format is recognised by a mark in its text or by its numbers; the
/// registry splits these once for all formats. `read` throws InputError; `write` throws std::invalid_argument if the
/// content lacks the part that it writes.
struct Format {
  std::string_view name;   ///< stable identifier, e.g. "dda-geometry"
  std::string_view title;  ///< one line for users
  Recognition (*recognise)(const Source&) = nullptr;
  Reading (*read)(const Source&, const ReadHint&) = nullptr;
  std::string (*write)(const Content&) = nullptr;
  Recognition (*recognise_numbers)(const Tokens&) = nullptr;
  Reading (*read_tokens)(const Tokens&, const ReadHint&) = nullptr;  ///< like `read`, for a text that is already split
  std::string_view evidence;     ///< of its layout: data, public source, or inferred
  std::string_view sample = {};  ///< small, made for this project; empty if the layout is lost
};

}  // namespace keyblock::formats
