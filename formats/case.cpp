// Reads several files in the order of their dependencies, and pairs them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "base/context.hpp"
#include "base/nearest.hpp"
#include "formats/dxf/dxf.hpp"
#include "formats/dxf/dxf_layer_table.hpp"
#include "formats/dxf/dxf_units.hpp"
#include "formats/shi/analysis_parts.hpp"
#include "formats/shi/dda_analysis.hpp"
#include "formats/shi/nmm_analysis.hpp"
#include "formats/text/tokens.hpp"
#include "problem/checks/check.hpp"
#include "problem/lines/near_ends.hpp"

namespace keyblock::formats {
namespace {

constexpr std::array<std::string_view, 6> kMismatches{"joint_material_clamped", "block_material_clamped",
                                                      "bolt_type_clamped",      "bolts_without_properties",
                                                      "surplus_load_curves",    "loading_points_without_load"};

/// Chooses the format of a file, with the geometry next to it if known.
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
    file.error.reset();
  } catch (const InputError& error) {
    file.error = error;
  }
}

/// Returns true if the file is, or may be, an analysis that cannot be recognised or read without the geometry.
bool needs_geometry(const FileReading& file) {
  if (!file.choice) return !file.source.text.empty();
  const Format* format = file.choice->format;
  const bool is_poor_analysis =
      format == &kDdaAnalysisBerkeley && file.choice->recognition.fit != Recognition::Fit::exact;
  return format == &kDdaAnalysisShi || format == &kNmmAnalysis || is_poor_analysis;
}

/// Chooses the format and reads the file if it needs no other; splits its text once for both.
FileReading open(const std::string& path) {
  FileReading file{path, {}, {}, {}, {}};
  try {
    file.source = load_text(path);
    Opened opened(file.source);
    file.choice = opened.recognise();
    if (!needs_geometry(file)) file.reading = opened.read_as(*file.choice);
  } catch (const InputError& error) {
    file.error = error;
  }
  return file;
}

/// Returns the counts of the geometry. They stay unknown if points were dropped: the analysis file still has their
/// flags.
ReadHint hint_of(const Reading& reading) {
  const Content& content = reading.content;
  const auto is_dropped_point = [](const Warning& warning) { return warning.name == "point_outside_blocks"; };
  const bool lacks_points = std::ranges::any_of(reading.warnings, is_dropped_point);
  if (content.blocks && lacks_points) return {std::nullopt, std::nullopt, GeometryKind::blocks};
  return counted_points(content);
}

/// Appends the rows of a file to those of the files before. Returns false, with the error of the file, if a row has an
/// unknown part.
bool take_layers(FileReading& file, LayerTable& all) {
  const LayerTable& layers = file.reading->content.layers;
  try {
    check_layers(layers, {file.path});
  } catch (const InputError& error) {
    file.error = error;
    return false;
  }
  all.rows.insert(all.rows.end(), layers.rows.begin(), layers.rows.end());
  all.places.insert(all.places.end(), layers.places.begin(), layers.places.end());
  return true;
}

bool is_dxf(const FileReading& file) {
  return file.choice && file.choice->format == &kDxf;
}

/// Refuses a unit that no drawing has, and a distance below 0 or without bound. Throws UsageError.
void check_choices(const DrawingChoices& asked) {
  const std::string fault = asked.unit.empty() ? std::string() : unless_one_of(asked.unit, dxf_unit_names());
  if (!fault.empty()) throw ChoiceError("unit", fault);
  if (!(std::isfinite(asked.join) && asked.join >= 0))
    throw ChoiceError("join", fmt::format("expected a number above 0, found \"{}\"", asked.join));
}

/// Choices of the command line override those of the case file.
DrawingChoices with_choices_of(std::vector<FileReading>& files, DrawingChoices choices) {
  for (FileReading& file : files) {
    if (!file.reading) continue;
    const Content& content = file.reading->content;
    const std::vector<std::string> known = dxf_unit_names();
    if (!content.drawing_unit.empty() && std::ranges::find(known, content.drawing_unit) == known.end()) {
      file.error = InputError({file.path}, fmt::format("expected drawing_unit, one of {}, found {}",
                                                       fmt::join(known, ", "), in_quotes(content.drawing_unit)));
      file.reading.reset();
      continue;
    }
    if (choices.unit.empty()) choices.unit = content.drawing_unit;
    if (choices.join == 0) choices.join = content.join.value_or(0);
  }
  return choices;
}

/// Joins lines of drawings other than DXF files. DXF drawings were joined before their joints were cut off at the
/// boundary.
void join_drawings(std::vector<FileReading>& files, double distance, const DrawingChoices& asked) {
  const auto has_drawing = [](const FileReading& file) { return file.reading && file.reading->content.drawing; };
  if (!asked.unit.empty() && std::ranges::none_of(files, is_dxf))
    throw ChoiceError("unit", "expected a DXF drawing, whose unit it is, found none");
  if (asked.join > 0 && std::ranges::none_of(files, has_drawing) &&
      std::ranges::all_of(files, [](const FileReading& file) { return file.reading.has_value(); }))
    throw ChoiceError("join", "expected a drawing, whose lines are joined, found none");
  for (FileReading& file : files)
    if (has_drawing(file) && !is_dxf(file))
      file.reading->warnings =
          joined(std::move(file.reading->warnings), join_ends(*file.reading->content.drawing, distance));
}

/// Reads files of drawing programs again in the length unit, and with the layers, that other files declare. A separate
/// table of layers precedes those of a case file.
void read_drawings_again(std::vector<FileReading>& files, const DrawingChoices& choices) {
  ReadHint hint;
  hint.drawing = choices;
  FileReading* with_layers = nullptr;
  for (const bool is_table : {true, false})
    for (FileReading& file : files) {
      if (!file.reading || is_dxf(file) || (file.choice->format == &kDxfLayers) != is_table) continue;
      if (file.reading->content.units) hint.length = file.reading->content.units->length;
      if (file.reading->content.layers.rows.empty()) continue;
      if (!take_layers(file, hint.layers)) return;
      with_layers = &file;
    }
  if (hint.length.empty() && hint.layers.rows.empty() && choices == DrawingChoices{}) return;
  bool is_read = false;
  for (FileReading& file : files)
    if (file.choice && is_dxf(file) && (file.reading || !hint.layers.rows.empty())) {
      read_into(file, hint);
      is_read = true;
    }
  if (with_layers != nullptr && !is_read)
    with_layers->reading->warnings.push_back(
        {"layers_without_drawing", {with_layers->path}, "layers of a drawing are named, and no DXF file is there"});
}

[[noreturn]] void refuse_second(const Place& second, const Place& first, std::string_view noun) {
  throw InputError(second, fmt::format("expected one {}, found a second; the first is {}", noun, first.file.text()));
}

/// Opens a drawing that a case file names, relative to its own folder, unless it was given too.
void open_named_drawings(std::vector<FileReading>& files) {
  namespace fs = std::filesystem;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (!files[i].reading || files[i].reading->content.drawing_file.empty()) continue;
    const Content content = files[i].reading->content;
    const auto refuse = [&](const std::string& found) {
      files[i].error = InputError(
          content.drawing_file_place,
          fmt::format("expected the name of a drawing in the folder of the case, such as \"slope.dxf\", found {}",
                      found));
      files[i].reading.reset();
    };
    const std::string path = (fs::path(files[i].path).parent_path() / content.drawing_file).string();
    std::error_code error;
    const bool is_given = std::ranges::any_of(
        files, [&](const FileReading& file) { return fs::equivalent(located(file.path), located(path), error); });
    if (is_given) continue;
    if (!fs::is_regular_file(located(path), error)) {
      refuse(fs::is_directory(located(path), error)
                 ? fmt::format("the folder \"{}\"", content.drawing_file)
                 : fmt::format("\"{}\": there is no file {}", content.drawing_file, path));
      continue;
    }
    FileReading drawing = open(path);
    const bool has_geometry = drawing.reading && (drawing.reading->content.drawing || drawing.reading->content.blocks ||
                                                  drawing.reading->content.cover);
    if (drawing.reading && !has_geometry) {
      refuse(fmt::format("\"{}\", a {} without one", content.drawing_file, drawing.choice->format->title));
      continue;
    }
    files.push_back(std::move(drawing));
  }
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
  if (content.motion) {
    if (problem.motion) refuse_second(content.motion->place, problem.motion->place, "motion");
    problem.motion = content.motion;
  }
  std::optional<Units> units = problem.units;
  put_units(units, content.units, content.drawing ? content.drawing->place : Place{});
  problem.units = *units;
  if (content.covers) problem.covers = content.covers;
  if (content.loads) {
    if (!problem.loads.empty()) refuse_second(content.loads->place, problem.loads.place, "list of loads");
    problem.loads = *content.loads;
  }
  if (content.choices) problem.choices = *content.choices;
  if (content.outputs) problem.outputs = *content.outputs;
  if (!content.stages.empty()) problem.stages = content.stages;
  problem.has_own_case = problem.has_own_case || content.is_own_case;
  return problem;
}

/// Explains a drawing without lines: the warnings of its reader name the parts left out.
InputError with_what_was_left_out(const InputError& error, const Problem& problem, const Warnings& warnings) {
  constexpr std::array<std::string_view, 3> kReasons{"dxf_hidden_layers", "dxf_skipped", "dxf_layer_not_there"};
  const auto* drawing = std::get_if<Drawing>(&problem.geometry);
  if (drawing == nullptr || !drawing->joints.empty()) return error;
  std::string why = error.sentence();
  for (const Warning& warning : warnings)
    if (std::ranges::find(kReasons, warning.name) != kReasons.end()) why += "; " + warning.sentence;
  return {error.place(), why};
}

}  // namespace

std::vector<FileReading> read_files(const std::vector<std::string>& paths, const DrawingChoices& asked) {
  check_choices(asked);
  std::vector<FileReading> files;
  for (const std::string& path : paths) files.push_back(open(path));
  open_named_drawings(files);
  const DrawingChoices choices = with_choices_of(files, asked);
  read_drawings_again(files, choices);
  join_drawings(files, choices.join, asked);
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

void put_units(std::optional<Units>& into, const std::optional<Units>& units, const Place& place) {
  if (!units) return;
  if (!into) into = Units{};
  const auto put = [&](std::string& known, const std::string& unit, std::string_view noun) {
    if (!known.empty() && !unit.empty() && known != unit)
      throw InputError(place,
                       fmt::format("expected the same unit of {} in all files, {}, found {}", noun, known, unit));
    if (known.empty()) known = unit;
  };
  put(into->length, units->length, "length");
  put(into->mass, units->mass, "mass");
  put(into->time, units->time, "time");
}

MaterialNames names_of(const std::vector<FileReading>& files) {
  MaterialNames all;
  const auto add = [](std::vector<std::string>& names, const std::vector<std::string>& more) {
    names.resize(std::max(names.size(), more.size()));
    for (std::size_t i = 0; i < more.size(); ++i)
      if (names[i].empty()) names[i] = more[i];
  };
  for (const bool is_of_analysis : {true, false})
    for (const FileReading& file : files) {
      if (!file.reading || file.reading->content.analysis.has_value() != is_of_analysis) continue;
      add(all.rocks, file.reading->content.names.rocks);
      add(all.joints, file.reading->content.names.joints);
    }
  return all;
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

Case load_case(const std::vector<std::string>& paths, const DrawingChoices& choices) {
  return case_of(read_files(paths, choices));
}

Case case_of(std::vector<FileReading> files) {
  std::vector<Content> contents;
  Case result;
  result.files = std::move(files);
  for (const FileReading& file : result.files) {
    if (file.error) throw *file.error;
    contents.push_back(file.reading->content);
    result.warnings = joined(std::move(result.warnings), file.reading->warnings);
  }
  const Problem problem = pair(contents);
  if (std::holds_alternative<std::monostate>(problem.geometry) && !problem.analysis)
    throw InputError({result.files.front().path}, "expected a geometry or an analysis, found neither");
  Checked checked = check(problem);
  if (!checked.errors.empty()) throw with_what_was_left_out(checked.errors.front(), problem, result.warnings);
  result.problem = std::move(checked.problem);
  if (!result.files.empty()) result.problem.place = {result.files.front().path, 0, 0};
  result.warnings = joined(std::move(result.warnings), checked.warnings);
  return result;
}

}  // namespace keyblock::formats
