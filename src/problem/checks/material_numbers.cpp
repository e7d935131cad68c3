// Replaces each number out of range by the nearest; one finding per number.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/checks/material_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "problem/checks/shared_ground.hpp"

namespace keyblock {
namespace {

/// Ranges of both materials, and what was out of them.
struct MaterialRanges {
  explicit MaterialRanges(const Analysis& analysis)
      : joint("joint material", analysis.joint_materials.size()),
        block("block material", analysis.block_materials.size()) {}

  std::vector<NumberOutOfRange> replaced(std::string_view of_joints, std::string_view of_blocks) const {
    std::vector<NumberOutOfRange> all = joint.replaced("joint_material_clamped", of_joints);
    for (NumberOutOfRange& one : block.replaced("block_material_clamped", of_blocks)) all.push_back(std::move(one));
    return all;
  }

  NumberRange joint;
  NumberRange block;
};

}  // namespace

NumberRange::NumberRange(std::string noun, std::size_t count)
    : noun_(std::move(noun)), last_(static_cast<int>(count) - 1) {}

int NumberRange::operator()(int number, const Place& place) {
  if (last_ < 0 || (number >= 0 && number <= last_)) return number;
  ++met_.try_emplace(number, Met{place, 0}).first->second.times;
  return std::clamp(number, 0, last_);
}

std::vector<NumberOutOfRange> NumberRange::replaced(const std::string& code, std::string_view carriers) const {
  std::vector<NumberOutOfRange> all;
  for (const auto& [number, met] : met_) {
    const long long written = static_cast<long long>(number) + 1;
    Facts facts{
        {{"number", written}, {"count", met.times}, {"last", last_ + 1}, {"taken", std::clamp(number, 0, last_) + 1}},
        {{"noun", noun_}, {"carriers", std::string(carriers)}}};
    all.push_back({{code, std::move(facts)},
                   met.place,
                   fmt::format("expected a {} from 1 to {}, found {} (of {} {})", noun_, last_ + 1, written, met.times,
                               carriers)});
  }
  return all;
}

std::vector<NumberOutOfRange> clamp_materials(Drawing& drawing, const Analysis& analysis) {
  MaterialRanges in_range(analysis);
  for (JointLine& line : drawing.joints) line.joint_material = in_range.joint(line.joint_material, line.place);
  for (MaterialLine& line : drawing.material_lines)
    line.block_material = in_range.block(line.block_material, line.place);
  return in_range.replaced("lines", "material lines");
}

std::vector<NumberOutOfRange> clamp_materials(Blocks& blocks, const Analysis& analysis) {
  MaterialRanges in_range(analysis);
  for (BlockPolygon& block : blocks.blocks) {
    const Place& place = place_of(block, blocks);
    block.material = in_range.block(block.material, place);
    for (BlockVertex& vertex : block.outer) vertex.joint_material = in_range.joint(vertex.joint_material, place);
    for (BlockLoop& hole : block.holes)
      for (BlockVertex& vertex : hole) vertex.joint_material = in_range.joint(vertex.joint_material, place);
  }
  return in_range.replaced("edges", "blocks");
}

std::vector<NumberOutOfRange> clamp_materials(Cover& cover, const Analysis& analysis) {
  MaterialRanges in_range(analysis);
  for (CoverElement& element : cover.elements) element.material = in_range.block(element.material, cover.place);
  for (LoopVertex& vertex : cover.loop_vertices)
    vertex.joint_material = in_range.joint(vertex.joint_material, cover.place);
  return in_range.replaced("edges", "elements");
}

}  // namespace keyblock
