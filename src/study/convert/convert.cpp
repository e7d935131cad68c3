// Combines the parts, derives the geometry that the target needs, writes, reads back and compares.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/convert/convert.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "api/named_files.hpp"
#include "base/nearest.hpp"
#include "formats/all_content.hpp"
#include "formats/berkeley/ddaml.hpp"
#include "formats/case_file/keyblock_case.hpp"
#include "formats/dxf/dxf.hpp"
#include "formats/shi/analysis_parts.hpp"
#include "formats/shi/dda_analysis.hpp"
#include "formats/shi/dda_blocks.hpp"
#include "formats/shi/dda_geometry.hpp"
#include "formats/shi/nmm_analysis.hpp"
#include "formats/shi/nmm_cover.hpp"
#include "formats/text/split.hpp"
#include "formats/text/tokens.hpp"
#include "formats/views/views.hpp"
#include "problem/checks/material_numbers.hpp"
#include "study/convert/berkeley_faults.hpp"
#include "study/convert/changed_rules.hpp"
#include "study/convert/derived_geometry.hpp"
#include "study/convert/dropped_comments.hpp"

namespace keyblock::study {
namespace {

using formats::Content;
using formats::Format;

bool has_geometry(const Content& content) {
  return content.drawing || content.blocks || content.cover;
}

struct Written {
  std::string text;     ///< empty if the format cannot hold any of the content
  std::string why_not;  ///< the reason in that case
};

Written written(const Format& format, const Content& content) {
  try {
    return {format.write(content), {}};
  } catch (const std::invalid_argument& error) {
    return {{}, error.what()};
  }
}

// One reader takes several layouts, of which the writer has one: points of 3 or 4 numbers, a head without its last
// count.
bool has_layout_of(const formats::FileReading& file, const Format& format, const std::string& text) {
  if (file.choice->format->read != format.read) return false;
  const bool is_marked = format.recognise != nullptr;
  if (is_marked || file.choice->recognition.fit == formats::Recognition::Fit::surplus)
    return file.choice->format == &format;
  return formats::tokenise(file.source).numbers.size() == formats::tokenise({"converted", text}).numbers.size();
}

// Returns the bytes of a file that already holds this text, in this format; null if none does.
const std::string* unchanged(const std::vector<formats::FileReading>& files, const Format& format,
                             const std::string& text) {
  for (const formats::FileReading& file : files)
    if (has_layout_of(file, format, text) && written(format, file.reading->content).text == text)
      return &file.source.text;
  return nullptr;
}

// Counts as the writers do: an analysis has as many curves as the geometry beside it has points.
formats::ReadHint hint_of(const Content& content) {
  formats::ReadHint hint = formats::counted_points(content);
  if (hint.geometry == formats::GeometryKind::unknown) hint.geometry = formats::GeometryKind::drawing;
  if (content.units) hint.length = content.units->length;
  if (!content.analysis) return hint;
  const auto count = [](const auto& curves) { return static_cast<int>(curves.size()); };
  if (!hint.fixed_points) hint.fixed_points = count(content.analysis->fixed_point_motions);
  if (!hint.loading_points) hint.loading_points = count(content.analysis->point_loads);
  return hint;
}

bool has_part(const Target& target, const Format& format) {
  return std::ranges::any_of(target.parts, [&](const Target::Part& part) { return part.format == &format; });
}

// Plain analysis files hold the weight of each material, and no gravity.
void state_weights(Content& content, const Target& target) {
  const bool holds_weights = has_part(target, formats::kDdaAnalysisShi) ||
                             has_part(target, formats::kDdaAnalysisBerkeley) || has_part(target, formats::kNmmAnalysis);
  if (!holds_weights || !content.analysis || !content.analysis->gravity) return;
  for (BlockMaterial& material : content.analysis->block_materials)
    material.unit_weight = material.density * *content.analysis->gravity;
  content.analysis->gravity.reset();
}

// Files in Shi's formats hold one curve per point of the geometry, even an empty one.
void complete_curves(Content& content, const Target& target) {
  const bool is_shi = has_part(target, formats::kDdaAnalysisShi);
  if (!content.analysis || (!is_shi && !has_part(target, formats::kNmmAnalysis))) return;
  const formats::ReadHint counts = hint_of(content);
  const auto grow = [](std::vector<TimeCurve>& curves, std::optional<int> size) {
    curves.resize(std::max(curves.size(), static_cast<std::size_t>(size.value_or(0))));
  };
  if (is_shi) grow(content.analysis->fixed_point_motions, counts.fixed_points);
  grow(content.analysis->point_loads, counts.loading_points);
}

// Old files run with the nearest material; a case file with its own materials has to name one that exists.
Content with_materials_in_range(Content content, const std::vector<formats::FileReading>& files, const Target& target) {
  const auto is_case = [](const formats::FileReading& file) { return file.choice->format == &formats::kKeyblockCase; };
  const bool is_old = std::ranges::none_of(files, is_case) && has_part(target, formats::kKeyblockCase);
  if (!content.analysis || !is_old) return content;
  if (content.drawing) clamp_materials(*content.drawing, *content.analysis);
  if (content.blocks) clamp_materials(*content.blocks, *content.analysis);
  if (content.cover) clamp_materials(*content.cover, *content.analysis);
  return content;
}

bool is_lacking(const Content& content, const Format& format) {
  return written(format, content).text.empty();
}

// Derives blocks or lines if the target holds these, and not the existing geometry.
std::optional<Derivation> derived_geometry(const Content& content, const Target& target) {
  const auto writes = [&](const Content& trial) {
    return std::ranges::any_of(target.parts,
                               [&](const Target::Part& part) { return !is_lacking(trial, *part.format); });
  };
  Content geometry, no_blocks, no_lines;
  geometry.drawing = content.drawing;
  geometry.blocks = content.blocks;
  geometry.cover = content.cover;
  no_blocks.blocks.emplace();
  no_lines.drawing.emplace();
  if (!has_geometry(geometry) || writes(geometry)) return std::nullopt;
  std::optional<Derivation> derived;
  if (writes(no_blocks)) derived = as_blocks(geometry);
  if (!derived && writes(no_lines)) derived = as_lines(geometry);
  return derived;
}

}  // namespace

const std::vector<Target>& targets() {
  using namespace formats;
  static const std::vector<Target> all{
      {"keyblock-case", "Keyblock case file", {{&kKeyblockCase, ".json"}}},
      {"ddaml", "Berkeley XML, geometry and analysis in one file", {{&kDdaml, ".xml"}}},
      {"dxf", "DXF drawing R12, lines by layer", {{&kDxf, ".dxf"}}},
      {"dda-geometry", "geometry (lines) of the old cutting program", {{&kDdaGeometry, ".geo"}}},
      {"dda-blocks", "block file, points of 4 numbers", {{&kDdaBlocks, ".blk"}}},
      {"dda-blocks-3", "block file, points of 3 numbers", {{&kDdaBlocksOfThree, ".blk"}}},
      {"dda-analysis-berkeley", "analysis file, Berkeley", {{&kDdaAnalysisBerkeley, ".ana"}}},
      {"dda-analysis-shi", "analysis file, Shi", {{&kDdaAnalysisShi, ".df"}}},
      {"nmm-cover", "cover of the manifold program", {{&kNmmCover, ".cv"}}},
      {"nmm-analysis", "analysis of the manifold program", {{&kNmmAnalysis, ".mf"}}},
      {"vtk", "for ParaView", {{&kVtk, ".vtu", left_out_by_vtk}}},
      {"csv", "a table of corners and marks, or of frames", {{&kCsv, ".csv", left_out_by_csv}}},
      {"berkeley",
       "lines and analysis, as Berkeley's program takes them",
       {{&kDdaGeometry, ".geo"}, {&kDdaAnalysisBerkeley, ".ana"}}},
      {"shi", "blocks and analysis, as Shi's df takes them", {{&kDdaBlocks, ".blk"}, {&kDdaAnalysisShi, ".df"}}},
      {"manifold", "cover and analysis, as Shi's mf takes them", {{&kNmmCover, ".cv"}, {&kNmmAnalysis, ".mf"}}},
  };
  return all;
}

const Target* find_target(std::string_view word) {
  const auto by_name = std::ranges::find(targets(), word, &Target::name);
  if (by_name != targets().end()) return &*by_name;
  const auto by_ending = std::ranges::find_if(targets(), [&](const Target& target) {
    return target.parts.size() == 1 && target.parts.front().ending.substr(1) == word;
  });
  return by_ending == targets().end() ? nullptr : &*by_ending;
}

const Target& target_named(std::string_view word) {
  if (const Target* target = find_target(word)) return *target;
  std::vector<std::string> names;
  for (const Target& target : targets()) names.emplace_back(target.name);
  throw std::invalid_argument(
      fmt::format("expected one of {}, found \"{}\"{}", target_names(), word, nearest_words(word, names)));
}

std::string target_names() {
  std::string names;
  for (const Target& target : targets()) names += (names.empty() ? "" : ", ") + std::string(target.name);
  return names;
}

Conversion convert(const std::vector<formats::FileReading>& files, const Target& target, Faults faults,
                   const std::filesystem::path& folder) {
  Conversion conversion;
  Content content;
  for (const formats::FileReading& file : files) {
    if (file.error) throw *file.error;
    formats::Reading reading = faults == Faults::berkeley ? as_berkeley_reads(file) : *file.reading;
    if (reading.content.choices && !folder.empty()) name_files_from(folder, *reading.content.choices);
    conversion.warnings = joined(std::move(conversion.warnings), reading.warnings);
    formats::add_content(content, reading.content, file.path);
  }
  // With a drawing its layers have been used; without one they wait for it.
  if (formats::has_used_layers(files)) content.layers = {};
  conversion.warnings = joined(std::move(conversion.warnings), formats::mismatches(content));
  if (std::optional<Derivation> derived = derived_geometry(content, target)) {
    content.drawing = std::move(derived->content.drawing);
    content.blocks = std::move(derived->content.blocks);
    content.cover.reset();
    conversion.losses.push_back({derived->from, 1, derived->sentence});
    conversion.warnings = joined(std::move(conversion.warnings), derived->warnings);
  }
  state_weights(content, target);
  complete_curves(content, target);
  conversion.hint = hint_of(content);
  const Content in_range = with_materials_in_range(content, files, target);
  Content back;
  std::string why_not;
  std::set<const std::string*> kept;
  for (const Target::Part& part : target.parts) {
    auto [text, reason] = written(*part.format, in_range);
    why_not = reason;
    if (text.empty()) {
      if (reason.empty())
        reason = fmt::format("the case has nothing that fits {}, {}", part.format->name, part.format->title);
      conversion.unwritten.push_back({part.ending, std::move(reason)});
      continue;
    }
    if (part.format->read)
      formats::add_content(back, part.format->read({"converted", text}, conversion.hint).content, "converted");
    const std::string* same = unchanged(files, *part.format, text);
    kept.insert(same);
    conversion.files.push_back({part.format, part.ending, same ? *same : std::move(text)});
  }
  if (conversion.files.empty())
    throw InputError({files.front().path},
                     fmt::format("expected something that {} holds, found none: {}", target.name, why_not));
  for (const formats::FileReading& file : files)
    if (std::optional<Warning> dropped = dropped_comments(file); dropped && !kept.contains(&file.source.text))
      conversion.warnings.push_back(std::move(*dropped));
  conversion.changed_rules = changed_rules(content, back, {files.front().path});
  const auto left_out = target.parts.front().left_out;
  for (Loss& loss : left_out != nullptr ? losses(content, left_out(content)) : losses(content, back))
    conversion.losses.push_back(std::move(loss));
  return conversion;
}

}  // namespace keyblock::study
