// The record every file format fills in: how it is recognised, read and written.
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
#include "problem/output_plan.hpp"
#include "problem/run_choices.hpp"
#include "problem/stage.hpp"
#include "result/frame.hpp"
#include "result/measured_track.hpp"

namespace keyblock::formats {

/// A file in memory: the name it is reported under, and its bytes.
struct Source {
  std::string name;
  std::string text;
};

/// What layers of a drawing (DXF) are, where their names do not say it: pairs of a layer and a part in words. Whoever
/// reads the drawing reads the words.
struct LayerTable {
  std::vector<std::pair<std::string, std::string>> rows;
  std::vector<Place> places = {};  ///< one a row

  bool operator==(const LayerTable& other) const { return rows == other.rows; }
};

/// The names of materials, or of the layers of a drawing that hold them, by number from 0. Empty: no name.
struct MaterialNames {
  std::vector<std::string> rocks;
  std::vector<std::string> joints;
};

/// What a file can hold. DDAML may hold a drawing and an analysis in one file. `motion` is a horizontal acceleration as
/// a multiple of gravity.
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
  std::optional<RunChoices> choices = std::nullopt;
  std::optional<OutputPlan> outputs = std::nullopt;
  std::vector<Stage> stages = {};
  LayerTable layers = {};
  std::optional<double> join = std::nullopt;  ///< of a case file: `DrawingChoices` of its drawing
  std::string drawing_unit = {};              ///< likewise
  std::string drawing_file = {};              ///< of a case file that names one, as it names it
  Place drawing_file_place = {};
  MaterialNames names = {};  ///< for pictures; references to them are numbers by now
  bool is_own_case = false;  ///< of a case file of Keyblock, not of an old program
};

/// What reading gives: the content and everything odd that was met on the way.
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

/// What the geometry says that an analysis file cannot be read without: Shi's holds a flag and a curve for
/// each fixed and each loading point, but neither number, the manifold program's a load for each loading point. A
/// drawing knows its fixed points only after cutting.
struct ReadHint {
  std::optional<int> fixed_points;
  std::optional<int> loading_points;
  GeometryKind geometry = GeometryKind::unknown;
  std::string length = "";  ///< the unit that other files declare, to which a file of another is brought; empty: metres
  LayerTable layers = {};   ///< likewise: what its layers are
  DrawingChoices drawing = {};
};

/// How sure a format is that a file is its own, and from what it concludes so (one sentence for the user).
/// `damaged`: it begins like one, but the counts do not fit; its reader will say where. `surplus`: more
/// numbers than the counts ask for. `variant`: exact by a known variant of the layout.
struct Recognition {
  enum class Fit { none, damaged, surplus, variant, exact };
  Fit fit = Fit::none;
  std::string evidence;
};

struct Tokens;

/// One format. A missing function means "cannot"; a format is recognised by a mark in its text or by its numbers, of
/// which the registry makes one list for all formats. `read` throws InputError; `write` throws
/// std::invalid_argument where the content lacks the part it writes.
struct Format {
  std::string_view name;   ///< stable identifier, e.g. "dda-geometry"
  std::string_view title;  ///< one line for people
  Recognition (*recognise)(const Source&) = nullptr;
  Reading (*read)(const Source&, const ReadHint&) = nullptr;
  std::string (*write)(const Content&) = nullptr;
  Recognition (*recognise_numbers)(const Tokens&) = nullptr;
  Reading (*read_tokens)(const Tokens&, const ReadHint&) = nullptr;  ///< as `read`, of a text already split
};

}  // namespace keyblock::formats
