// Adds part by part. Sections of a case file replace those that the writer makes of their content.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/all_content.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "formats/case_file/keyblock_case.hpp"
#include "formats/dxf/dxf.hpp"
#include "formats/strict_json.hpp"

namespace keyblock::formats {
namespace {

using Json = nlohmann::ordered_json;

bool has_geometry(const Content& content) {
  return content.drawing || content.blocks || content.cover;
}

template <class Part>
void put(std::optional<Part>& into, const std::optional<Part>& part, const std::string& file, std::string_view noun) {
  if (!part) return;
  if (into) throw InputError({file}, fmt::format("expected one {} in all files, found a second", noun));
  into = part;
}

bool is_case_file(const FileReading& file) {
  return file.choice && file.choice->format == &kKeyblockCase;
}

// Names of materials and values with units are lost in content; the analysis of the file has them.
void keep_sections(Json& merged, const FileReading& own) {
  const Json file = Json::parse(strict_json(own.source));
  for (const char* section : {"keyblock", "analysis", "covers", "loads", "stages", "outputs", "run"})
    if (file.contains(section) && merged.contains(section)) merged[section] = file[section];
}

}  // namespace

void add_content(Content& all, const Content& content, const std::string& file) {
  if (has_geometry(all) && has_geometry(content))
    throw InputError({file}, "expected one geometry in all files, found a second");
  put(all.drawing, content.drawing, file, "drawing");
  put(all.blocks, content.blocks, file, "set of blocks");
  put(all.cover, content.cover, file, "cover");
  put(all.covers, content.covers, file, "set of covers");
  put(all.loads, content.loads, file, "list of loads");
  put(all.analysis, content.analysis, file, "analysis");
  all.frames.insert(all.frames.end(), content.frames.begin(), content.frames.end());
  all.tracks.insert(all.tracks.end(), content.tracks.begin(), content.tracks.end());
  put(all.motion, content.motion, file, "motion");
  put_units(all.units, content.units, {file});
  put(all.choices, content.choices, file, "run");
  all.is_own_case = all.is_own_case || content.is_own_case;
  put(all.outputs, content.outputs, file, "set of outputs");
  if (all.layers.rows.empty()) all.layers = content.layers;
  if (!all.stages.empty() && !content.stages.empty())
    throw InputError({file}, "expected stages in one of the files, found more");
  all.stages.insert(all.stages.end(), content.stages.begin(), content.stages.end());
}

bool has_used_layers(const std::vector<FileReading>& files) {
  return std::ranges::any_of(files,
                             [](const FileReading& file) { return file.choice && file.choice->format == &kDxf; });
}

std::string case_file_text(const std::vector<FileReading>& files) {
  for (const FileReading& file : files)
    if (file.error) throw *file.error;
  if (files.size() == 1 && is_case_file(files.front())) return strict_json(files.front().source);
  Content content;
  for (const FileReading& file : files) add_content(content, file.reading->content, file.path);
  if (has_used_layers(files)) content.layers = {};
  Json merged = Json::parse(kKeyblockCase.write(content));
  for (const FileReading& file : files)
    if (is_case_file(file)) keep_sections(merged, file);
  return merged.dump(1);
}

}  // namespace keyblock::formats
