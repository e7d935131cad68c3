// Reading of several files in the order they need each other, and their pairing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "formats/dda_analysis.hpp"

namespace keyblock::formats {
namespace {

FileReading open(const std::string& path) {
  FileReading file{path, {}, {}, {}, {}};
  try {
    file.source = load(path);
    file.choice = recognise(file.source);
  } catch (const InputError& error) {
    file.error = error;
  }
  return file;
}

void read_into(FileReading& file, const ReadHint& hint) {
  try {
    file.reading = read_as(*file.choice, file.source, hint);
  } catch (const InputError& error) {
    file.error = error;
  }
}

bool needs_geometry(const FileReading& file) {
  return file.choice && file.choice->format == &kDdaAnalysisShi;
}

bool is_one_point(const FixedLine& line) {
  return line.segment.start == line.segment.end;
}

/// Nothing where fixed points were dropped: the analysis file still has their flags.
ReadHint hint_of(const Reading& reading) {
  const Content& content = reading.content;
  const auto is_dropped_point = [](const Warning& warning) { return warning.name == "point_outside_blocks"; };
  if (std::ranges::any_of(reading.warnings, is_dropped_point)) return {};
  if (content.blocks)
    return {static_cast<int>(content.blocks->fixed_points.size()),
            static_cast<int>(content.blocks->loading_points.size())};
  if (!content.drawing) return {};
  const Drawing& drawing = *content.drawing;
  ReadHint hint;
  hint.loading_points = static_cast<int>(drawing.loading_points.size());
  if (std::ranges::all_of(drawing.fixed_lines, is_one_point))
    hint.fixed_points = static_cast<int>(drawing.fixed_lines.size());
  return hint;
}

[[noreturn]] void refuse_second(const Place& second, const Place& first, std::string_view noun) {
  throw InputError(second, fmt::format("expected one {}, found a second; the first is {}", noun, first.file));
}

Place geometry_place(const Problem& problem) {
  if (const auto* drawing = std::get_if<Drawing>(&problem.geometry)) return drawing->place;
  if (const auto* blocks = std::get_if<Blocks>(&problem.geometry)) return blocks->place;
  return {};
}

Problem with_content(Problem problem, const Content& content) {
  const bool has_geometry = !std::holds_alternative<std::monostate>(problem.geometry);
  const auto refuse_second_geometry = [&](const Place& second) {
    if (has_geometry) refuse_second(second, geometry_place(problem), "geometry");
  };
  if (content.drawing) {
    refuse_second_geometry(content.drawing->place);
    problem.geometry = *content.drawing;
  }
  if (content.blocks) {
    refuse_second_geometry(content.blocks->place);
    problem.geometry = *content.blocks;
  }
  if (content.analysis) {
    if (problem.analysis) refuse_second(content.analysis->place, problem.analysis->place, "analysis");
    problem.analysis = content.analysis;
  }
  return problem;
}

}  // namespace

std::vector<FileReading> read_files(const std::vector<std::string>& paths) {
  std::vector<FileReading> files;
  for (const std::string& path : paths) files.push_back(open(path));
  ReadHint hint;
  for (FileReading& file : files) {
    if (!file.choice || needs_geometry(file)) continue;
    read_into(file, {});
    if (file.reading && !hint.loading_points) hint = hint_of(*file.reading);
  }
  for (FileReading& file : files)
    if (needs_geometry(file)) read_into(file, hint);
  return files;
}

Problem pair(const std::vector<Content>& contents) {
  Problem problem;
  for (const Content& content : contents) problem = with_content(std::move(problem), content);
  return problem;
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
  Checked checked = check(pair(contents));
  if (!checked.errors.empty()) throw checked.errors.front();
  result.problem = std::move(checked.problem);
  result.warnings = joined(std::move(result.warnings), checked.warnings);
  return result;
}

}  // namespace keyblock::formats
