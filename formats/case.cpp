// Reading of several files in the order they need each other, and their pairing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "formats/dda_analysis.hpp"
#include "formats/nmm_analysis.hpp"

namespace keyblock::formats {
namespace {

constexpr std::array<std::string_view, 6> kMismatches{"joint_material_clamped", "block_material_clamped",
                                                      "bolt_type_clamped",      "bolts_without_properties",
                                                      "surplus_load_curves",    "loading_points_without_load"};

/// What the file is, with the geometry beside it if known.
void choose(FileReading& file, GeometryKind geometry) {
  file.choice.reset();
  file.error.reset();
  try {
    file.choice = recognise(file.source, geometry);
  } catch (const InputError& error) {
    file.error = error;
  }
}

void read_into(FileReading& file, const ReadHint& hint) {
  try {
    file.reading = read_as(*file.choice, file.source, hint);
  } catch (const InputError& error) {
    file.error = error;
  }
}

/// Whether the file is, or may be, an analysis that cannot be told or read without the geometry.
bool needs_geometry(const FileReading& file) {
  if (!file.choice) return !file.source.text.empty();
  const Format* format = file.choice->format;
  const bool is_poor_analysis =
      format == &kDdaAnalysisBerkeley && file.choice->recognition.fit != Recognition::Fit::exact;
  return format == &kDdaAnalysisShi || format == &kNmmAnalysis || is_poor_analysis;
}

/// Chosen, and read if nothing beside it is needed: both from one splitting of its text.
FileReading open(const std::string& path) {
  FileReading file{path, {}, {}, {}, {}};
  try {
    file.source = load(path);
    Opened opened(file.source);
    file.choice = opened.recognise();
    if (!needs_geometry(file)) file.reading = opened.read_as(*file.choice);
  } catch (const InputError& error) {
    file.error = error;
  }
  return file;
}

bool is_one_point(const FixedLine& line) {
  return line.segment.start == line.segment.end;
}

/// The numbers stay unknown where points were dropped: the analysis file still has their flags.
ReadHint hint_of(const Reading& reading) {
  const Content& content = reading.content;
  const auto is_dropped_point = [](const Warning& warning) { return warning.name == "point_outside_blocks"; };
  const bool lacks_points = std::ranges::any_of(reading.warnings, is_dropped_point);
  const auto count = [](const auto& points) { return static_cast<int>(points.size()); };
  if (content.cover) return {std::nullopt, count(content.cover->loading_points), GeometryKind::cover};
  if (content.blocks && lacks_points) return {std::nullopt, std::nullopt, GeometryKind::blocks};
  if (content.blocks)
    return {count(content.blocks->fixed_points), count(content.blocks->loading_points), GeometryKind::blocks};
  if (!content.drawing) return {};
  const Drawing& drawing = *content.drawing;
  ReadHint hint{std::nullopt, count(drawing.loading_points), GeometryKind::drawing};
  if (std::ranges::all_of(drawing.fixed_lines, is_one_point)) hint.fixed_points = count(drawing.fixed_lines);
  return hint;
}

[[noreturn]] void refuse_second(const Place& second, const Place& first, std::string_view noun) {
  throw InputError(second, fmt::format("expected one {}, found a second; the first is {}", noun, first.file.text()));
}

template <typename Geometry>
void put_geometry(Problem& problem, const std::optional<Geometry>& geometry) {
  if (!geometry) return;
  const auto place_of = [](const auto& first) {
    if constexpr (requires { first.place; }) return first.place;
    return Place{};
  };
  if (!std::holds_alternative<std::monostate>(problem.geometry))
    refuse_second(geometry->place, std::visit(place_of, problem.geometry), "geometry");
  problem.geometry = *geometry;
}

Problem with_content(Problem problem, const Content& content) {
  put_geometry(problem, content.drawing);
  put_geometry(problem, content.blocks);
  put_geometry(problem, content.cover);
  if (content.analysis) {
    if (problem.analysis) refuse_second(content.analysis->place, problem.analysis->place, "analysis");
    problem.analysis = content.analysis;
  }
  if (content.units) problem.units = *content.units;
  if (content.choices) problem.choices = *content.choices;
  return problem;
}

}  // namespace

std::vector<FileReading> read_files(const std::vector<std::string>& paths) {
  std::vector<FileReading> files;
  for (const std::string& path : paths) files.push_back(open(path));
  ReadHint hint;
  for (FileReading& file : files) {
    if (file.reading && hint.geometry == GeometryKind::unknown) hint = hint_of(*file.reading);
  }
  for (FileReading& file : files) {
    if (!needs_geometry(file)) continue;
    choose(file, hint.geometry);
    if (file.choice) read_into(file, hint);
  }
  return files;
}

Problem pair(const std::vector<Content>& contents) {
  Problem problem;
  for (const Content& content : contents) problem = with_content(std::move(problem), content);
  return problem;
}

Warnings mismatches(const Content& content) {
  if (!content.analysis) return {};
  Warnings found = check(pair({content})).warnings;
  std::erase_if(
      found, [](const Warning& warning) { return std::ranges::find(kMismatches, warning.name) == kMismatches.end(); });
  return found;
}

Case load_case(const std::vector<std::string>& paths) {
  std::vector<Content> contents;
  Case result;
  result.files = read_files(paths);
  for (const FileReading& file : result.files) {
    if (file.error) throw *file.error;
    contents.push_back(file.reading->content);
    result.warnings = joined(std::move(result.warnings), file.reading->warnings);
  }
  const Problem problem = pair(contents);
  if (std::holds_alternative<std::monostate>(problem.geometry) && !problem.analysis)
    throw InputError({paths.front()}, "expected a geometry or an analysis, found neither");
  Checked checked = check(problem);
  if (!checked.errors.empty()) throw checked.errors.front();
  result.problem = std::move(checked.problem);
  result.warnings = joined(std::move(result.warnings), checked.warnings);
  return result;
}

}  // namespace keyblock::formats
