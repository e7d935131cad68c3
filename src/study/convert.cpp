// Puts the parts together, derives the geometry that the target asks for, writes, reads back and compares.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/convert.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "formats/dda_analysis.hpp"
#include "formats/dda_blocks.hpp"
#include "formats/dda_geometry.hpp"
#include "formats/ddaml.hpp"
#include "formats/dxf.hpp"
#include "formats/keyblock_case.hpp"
#include "formats/nmm_analysis.hpp"
#include "formats/nmm_cover.hpp"
#include "formats/views.hpp"
#include "study/derived_geometry.hpp"

namespace keyblock::study {
namespace {

using formats::Content;
using formats::Format;

bool has_geometry(const Content& content) {
  return content.drawing || content.blocks || content.cover;
}

template <class Part>
void put(std::optional<Part>& into, const std::optional<Part>& part, const std::string& file, std::string_view noun) {
  if (!part) return;
  if (into) throw InputError({file}, fmt::format("expected one {} in all files, found a second", noun));
  into = part;
}

void add_to(Content& all, const Content& content, const std::string& file) {
  if (has_geometry(all) && has_geometry(content))
    throw InputError({file}, "expected one geometry in all files, found a second");
  put(all.drawing, content.drawing, file, "drawing");
  put(all.blocks, content.blocks, file, "set of blocks");
  put(all.cover, content.cover, file, "cover");
  put(all.analysis, content.analysis, file, "analysis");
  all.frames.insert(all.frames.end(), content.frames.begin(), content.frames.end());
  put(all.motion, content.motion, file, "motion");
  put(all.units, content.units, file, "set of units");
  put(all.choices, content.choices, file, "run");
}

// As the Berkeley program takes what it reads (legacy-formats 2.6 and 4).
Warnings take_as_berkeley(Content& content) {
  Warnings warnings;
  const auto warn = [&](const char* name, const Place& place, const char* sentence) {
    warnings.push_back({name, place, sentence});
  };
  if (content.drawing && !content.drawing->material_lines.empty()) {
    warn("first_material_line_lost", content.drawing->material_lines.front().place, "the first material line is lost");
    content.drawing->material_lines.erase(content.drawing->material_lines.begin());
  }
  if (content.drawing && !content.drawing->bolts.empty()) {
    warn("bolts_lost", content.drawing->bolts.front().place, "bolts are not read");
    content.drawing->bolts.clear();
  }
  if (!content.analysis) return warnings;
  Analysis& analysis = *content.analysis;
  if (analysis.velocity_carry_over > 0 && analysis.velocity_carry_over < 1) {
    warn("carry_over_cut", analysis.place, "the carry-over of velocities is read as a whole number: 0");
    analysis.velocity_carry_over = 0;
  }
  if (analysis.dialect != AnalysisDialect::ddaml) return warnings;
  for (BlockMaterial& material : analysis.block_materials) {
    Velocity& v = material.initial_velocity;
    std::array<double, 3>& e = material.initial_strain;
    if (v == Velocity{} && e == std::array<double, 3>{}) continue;
    warn("velocity_and_strain_swapped", material.place, "Ivelocity and Istrain change places");
    const Velocity old = v;
    v = {e[0], e[1], e[2]};
    e = {old.x, old.y, old.rotation};
  }
  return warnings;
}

// What of the content the format writes: what its own text gives back.
std::string written(const Format& format, const Content& content) {
  try {
    return format.write(content);
  } catch (const std::invalid_argument&) {
    return {};
  }
}

std::string why_not(const Format& format, const Content& content) {
  try {
    format.write(content);
    return {};
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

// The bytes of the file that already says this, in this format.
const std::string* unchanged(const std::vector<formats::FileReading>& files, const Format& format,
                             const std::string& text) {
  for (const formats::FileReading& file : files)
    if (file.choice->format->name == format.name && written(format, file.reading->content) == text)
      return &file.source.text;
  return nullptr;
}

formats::ReadHint hint_of(const Content& content) {
  using formats::GeometryKind;
  formats::ReadHint hint{std::nullopt, std::nullopt,
                         content.cover    ? GeometryKind::cover
                         : content.blocks ? GeometryKind::blocks
                                          : GeometryKind::drawing};
  if (content.analysis) {
    hint.fixed_points = static_cast<int>(content.analysis->fixed_point_motions.size());
    hint.loading_points = static_cast<int>(content.analysis->point_loads.size());
  }
  return hint;
}

// Files of Shi's line hold a curve for each point of the geometry, if only an empty one.
void complete_curves(Content& content, const Target& target) {
  const auto is_part = [&](const Format& format) {
    return std::ranges::any_of(target.parts, [&](const Target::Part& part) { return part.format == &format; });
  };
  const bool is_shi = is_part(formats::kDdaAnalysisShi);
  if (!content.analysis || (!is_shi && !is_part(formats::kNmmAnalysis))) return;
  const auto grow = [](std::vector<TimeCurve>& curves, std::size_t size) {
    if (curves.size() < size) curves.resize(size);
  };
  const auto points = [&](const auto& geometry) {
    if (is_shi) grow(content.analysis->fixed_point_motions, geometry.fixed_points.size());
    grow(content.analysis->point_loads, geometry.loading_points.size());
  };
  if (content.blocks) points(*content.blocks);
  if (content.cover) points(*content.cover);
}

bool is_lacking(const Content& content, const Format& format) {
  return written(format, content).empty();
}

// The geometry that one of the parts can write, where it cannot write the one there is.
Loss derive_geometry(Content& content, const Target& target) {
  const auto writes = [&](const Content& trial) {
    return std::ranges::any_of(target.parts,
                               [&](const Target::Part& part) { return !is_lacking(trial, *part.format); });
  };
  const Content whole = content;
  Content geometry;
  geometry.drawing = content.drawing;
  geometry.blocks = content.blocks;
  geometry.cover = content.cover;
  if (!has_geometry(geometry) || writes(geometry)) return {};
  for (Derivation& derivation : derivations(geometry)) {
    if (!writes(derivation.content)) continue;
    content.drawing = derivation.content.drawing;
    content.blocks = derivation.content.blocks;
    content.cover.reset();
    return {derivation.from, 1, derivation.sentence};
  }
  return {};
}

}  // namespace

const std::vector<Target>& targets() {
  using namespace formats;
  static const std::vector<Target> all{
      {"keyblock-case", "Keyblock case file", {{&kKeyblockCase, ".json"}}},
      {"ddaml", "Berkeley XML, geometry and analysis in one file", {{&kDdaml, ".xml"}}},
      {"dxf", "DXF drawing R12, lines by layer, in metres", {{&kDxf, ".dxf"}}},
      {"dda-geometry", "geometry (lines) of the old cutting program", {{&kDdaGeometry, ".geo"}}},
      {"dda-blocks", "block file, points of 4 numbers", {{&kDdaBlocks, ".blk"}}},
      {"dda-blocks-3", "block file, points of 3 numbers", {{&kDdaBlocksOfThree, ".blk"}}},
      {"dda-analysis-berkeley", "analysis file, Berkeley", {{&kDdaAnalysisBerkeley, ".ana"}}},
      {"dda-analysis-shi", "analysis file, Shi", {{&kDdaAnalysisShi, ".df"}}},
      {"nmm-cover", "cover of the manifold program", {{&kNmmCover, ".cv"}}},
      {"nmm-analysis", "analysis of the manifold program", {{&kNmmAnalysis, ".mf"}}},
      {"vtk", "for ParaView", {{&kVtk, ".vtu"}}},
      {"csv", "a table of corners and marks, or of frames", {{&kCsv, ".csv"}}},
      {"berkeley",
       "lines and analysis, as Berkeley's program takes them",
       {{&kDdaGeometry, ".geo"}, {&kDdaAnalysisBerkeley, ".ana"}}},
      {"shi", "blocks and analysis, as Shi's df takes them", {{&kDdaBlocks, ".blk"}, {&kDdaAnalysisShi, ".df"}}},
      {"manifold", "cover and analysis, as Shi's mf takes them", {{&kNmmCover, ".cv"}, {&kNmmAnalysis, ".mf"}}},
  };
  return all;
}

const Target* find_target(std::string_view name) {
  const auto found = std::ranges::find(targets(), name, &Target::name);
  return found == targets().end() ? nullptr : &*found;
}

Conversion convert(const std::vector<formats::FileReading>& files, const Target& target, Faults faults) {
  Conversion conversion;
  for (const formats::FileReading& file : files) {
    if (file.error) throw *file.error;
    conversion.warnings = joined(conversion.warnings, file.reading->warnings);
  }
  Content content;
  for (const formats::FileReading& file : files) add_to(content, file.reading->content, file.path);
  conversion.warnings = joined(conversion.warnings, formats::mismatches(content));
  if (faults == Faults::berkeley) conversion.warnings = joined(conversion.warnings, take_as_berkeley(content));
  if (const Loss derived = derive_geometry(content, target); derived.times > 0) conversion.losses.push_back(derived);
  complete_curves(content, target);
  conversion.hint = hint_of(content);
  Content back;
  for (const Target::Part& part : target.parts) {
    std::string text = written(*part.format, content);
    if (text.empty()) continue;
    if (part.format->read) add_to(back, part.format->read({"converted", text}, conversion.hint).content, "converted");
    const std::string* same = unchanged(files, *part.format, text);
    conversion.files.push_back({part.format, part.ending, same ? *same : std::move(text)});
  }
  if (conversion.files.empty())
    throw InputError({files.front().path}, fmt::format("expected something that {} holds, found none: {}", target.name,
                                                       why_not(*target.parts.back().format, content)));
  if (!target.parts.front().format->read) return conversion;  // a view: nothing is meant to come back
  for (Loss& loss : losses(content, back)) conversion.losses.push_back(std::move(loss));
  return conversion;
}

}  // namespace keyblock::study
