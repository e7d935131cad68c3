// ext-04: every case of legacy_cases has the same displacements far from the origin as near it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "api/case_folder.hpp"
#include "formats/case.hpp"
#include "tests/extremes/extreme.hpp"
#include "tests/extremes/extreme_scenes.hpp"

namespace keyblock::extremes {
namespace {

constexpr Point kFar{1e7, 1e7};
constexpr double kSameDisplacement = 1e-6;
// Over the area of a block: the corners of a floor of 40 m2 are rounded in the input already, by 1e-9 m each.
constexpr double kSameArea = 1e-8;
// One of the full list for each kind of motion.
constexpr std::array<const char*, 6> kBrief{"sliding_block/a30_p20", "free_fall/released", "free_fall/spinning",
                                            "stack/five_blocks",     "push_block/ramp",    "block_at_rest/dynamic"};

template <class Marks, class Where>
void move_all(Marks& marks, Where where) {
  for (auto& mark : marks) where(mark) = where(mark) + kFar;
}

template <class Lines>
void move_lines(Lines& lines) {
  for (auto& line : lines) line.segment = {line.segment.start + kFar, line.segment.end + kFar};
}

Drawing moved(Drawing drawing) {
  move_lines(drawing.joints);
  move_lines(drawing.material_lines);
  move_lines(drawing.bolts);
  move_lines(drawing.fixed_lines);
  const auto position = [](MarkedPoint& mark) -> Point& { return mark.position; };
  move_all(drawing.loading_points, position);
  move_all(drawing.measured_points, position);
  move_all(drawing.hole_points, position);
  return drawing;
}

Blocks moved(Blocks blocks) {
  const auto corner = [](BlockVertex& vertex) -> Point& { return vertex.position; };
  for (BlockPolygon& block : blocks.blocks) {
    move_all(block.outer, corner);
    for (BlockLoop& hole : block.holes) move_all(hole, corner);
  }
  const auto position = [](BlockPoint& point) -> Point& { return point.position; };
  move_lines(blocks.bolts);
  move_all(blocks.fixed_points, position);
  move_all(blocks.loading_points, position);
  move_all(blocks.measured_points, position);
  return blocks;
}

Problem far_away(Problem problem) {
  if (const auto* drawing = std::get_if<Drawing>(&problem.geometry)) problem.geometry = moved(*drawing);
  if (const auto* blocks = std::get_if<Blocks>(&problem.geometry)) problem.geometry = moved(*blocks);
  return problem;
}

Extremes compare(const CaseFolder& folder) {
  const Problem problem = formats::load_case(folder.inputs()).problem;
  const Run here = run_standard(problem);
  const Run there = run_standard(far_away(problem));
  if (!here.is_sound() || !there.is_sound())
    return {{"ext-04", folder.name + ": trouble is as near the origin", 1, here.trouble == there.trouble ? 1.0 : 0.0, 0,
             here.trouble + "; far away: " + there.trouble}};
  double displacement = 0;
  double area = 0;
  for (std::size_t i = 0; i < here.last.elements.size(); ++i) {
    const ElementFrame& a = here.last.elements[i];
    const ElementFrame& b = there.last.elements[i];
    displacement = std::max(displacement, distance(a.displacement, b.displacement));
    area = std::max(area, std::abs(b.area / a.area - 1));
  }
  return {{"ext-04", folder.name + ": difference of displacement", 0, displacement, kSameDisplacement, {}},
          {"ext-04", folder.name + ": difference of area / area", 0, area, kSameArea, {}}};
}

}  // namespace

Extremes coordinate_offset(Effort effort) {
  Extremes rows;
  for (const CaseFolder& folder : find_cases({KEYBLOCK_SOURCE_DIR "/legacy_cases"})) {
    const bool is_brief = std::ranges::any_of(kBrief, [&](const char* name) { return folder.name == name; });
    if (!folder.has_expected || (effort == Effort::brief && !is_brief)) continue;
    const Extremes more = compare(folder);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

}  // namespace keyblock::extremes
