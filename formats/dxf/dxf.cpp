// Implements the DXF format: recognition, reading, and the edge-node ratio.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/dxf.hpp"

#include <fmt/format.h>

#include "base/sentences/sentences.hpp"
#include "formats/dxf/dxf_clip.hpp"
#include "formats/dxf/dxf_drawing.hpp"
#include "formats/dxf/dxf_entities.hpp"
#include "formats/dxf/dxf_units.hpp"
#include "formats/dxf/dxf_writer.hpp"
#include "formats/text/demands.hpp"
#include "formats/text/numbers.hpp"
#include "problem/lines/near_ends.hpp"

namespace keyblock::formats {
namespace {

Recognition recognise(const Source& source) {
  if (!opens_as_dxf(without_bom(source.text))) return {};
  return {Recognition::Fit::exact, "it opens with group 0 SECTION"};
}

/// Finds the comment of the writer.
const DxfGroup* ratio_in(const DxfDocument& document) {
  for (const DxfGroup& comment : document.comments())
    if (comment.value.starts_with(kDxfRatioComment)) return &comment;
  return nullptr;
}

double edge_node_ratio(const DxfDocument& document, const Place& file, Warnings& warnings) {
  if (const DxfGroup* comment = ratio_in(document)) {
    const std::string_view text = comment->value.substr(kDxfRatioComment.size());
    const auto ratio = parse_real(text);
    if (!ratio || !kEdgeNodeRatio.holds(*ratio))
      throw InputError(document.place(*comment),
                       fmt::format("expected the edge-node ratio ({}) behind \"{}\", found {}", kEdgeNodeRatio.wording,
                                   kDxfRatioComment, in_quotes(text)));
    return *ratio;
  }
  const Facts facts{{{"edge_node_ratio", kDxfEdgeNodeRatio}}};
  warnings.push_back(warning_of({"default_edge_node_ratio:of_dxf", facts}, file));
  return kDxfEdgeNodeRatio;
}

/// Returns the only section of that name; null if it is missing.
const DxfSection* find_section(const DxfDocument& document, std::string_view name) {
  const DxfSection* found = nullptr;
  for (const DxfSection& section : document.sections()) {
    if (section.name != name) continue;
    if (found != nullptr)
      throw InputError(document.place(section.head), fmt::format("expected one section {}, found a second", name));
    found = &section;
  }
  return found;
}

Reading read(const Source& source, const ReadHint& hint) {
  const DxfDocument document(source);
  const DxfSection* entities = find_section(document, "ENTITIES");
  if (entities == nullptr) throw InputError({source.name}, "expected a section ENTITIES, found none");
  const DxfUnit unit = unit_of(document, hint.length, hint.drawing.unit);
  Warnings warnings = joined(document.warnings(), unit.warnings);
  if (unit.length.empty() && unit.warnings.empty() && !hint.length.empty()) {
    Facts facts;
    facts.names = {{"unit", hint.length}};
    warnings.push_back(warning_of({"dxf_without_unit", std::move(facts)}, {source.name}));
  }
  const double ratio = edge_node_ratio(document, {source.name}, warnings);
  DxfDefinitions definitions(document, find_section(document, "BLOCKS"));
  DxfShapes shapes = read_entities(document, entities->records, definitions, DxfVisibility(document, hint.layers));
  keep_one_plane(shapes);
  DxfDrawing made = drawing_of(std::move(shapes), unit.factor, hint.layers);
  made.drawing.edge_node_ratio = ratio;
  made.drawing.place = {source.name};
  warnings = joined(joined(std::move(warnings), made.warnings), definitions.unused(document).warnings());
  warnings = joined(std::move(warnings), join_ends(made.drawing, hint.drawing.join));
  // Drawings written by this program are not clipped, even if their lines cross.
  if (!ratio_in(document)) warnings = joined(std::move(warnings), clip_joints(made.drawing));
  Reading reading{{std::move(made.drawing), {}, {}}, std::move(warnings)};
  reading.content.names = std::move(made.names);
  if (!unit.length.empty()) reading.content.units = Units{unit.length, "", ""};
  return reading;
}

}  // namespace

std::string_view drawing_program_binary(std::string_view text) {
  if (text.starts_with("AutoCAD Binary DXF")) return "a binary DXF file (save it as ASCII DXF)";
  const bool is_dwg = text.starts_with("AC10") && text.substr(0, 16).find('\0') != std::string_view::npos;
  return is_dwg ? "a DWG file (save it as ASCII DXF)" : "";
}

constinit const Format kDxf{
    .name = "dxf",
    .title = "DXF drawing (lines by layer)",
    .recognise = recognise,
    .read = read,
    .write = write_dxf,
    .evidence = "published layout",
    .sample =
        "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nBOUNDARY\n90\n4\n70\n1\n10\n0\n20\n0\n10\n4\n20\n0\n10\n4\n20\n1\n"
        "10\n0\n20\n1\n0\nLINE\n8\nJOINT_2\n10\n2\n20\n0\n11\n2\n21\n1\n0\nPOINT\n8\nFIXED\n10\n1\n20\n0.5\n"
        "0\nENDSEC\n0\nEOF\n"};

}  // namespace keyblock::formats
