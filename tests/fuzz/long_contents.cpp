// Builds one content per list; the rest of it is as small as a file may be.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/long_contents.hpp"

namespace keyblock::support {
namespace {

using formats::Content;

Drawing square() {
  Drawing drawing;
  drawing.edge_node_ratio = 0.1;
  drawing.joints = {
      {{{0, 0}, {4, 0}}, 0, {}}, {{{4, 0}, {4, 1}}, 0, {}}, {{{4, 1}, {0, 1}}, 0, {}}, {{{0, 1}, {0, 0}}, 0, {}}};
  drawing.boundary_count = drawing.joints.size();
  drawing.fixed_lines = {{{{1, 1}, {1, 1}}, {}}};
  return drawing;
}

Blocks triangle() {
  Blocks blocks;
  blocks.blocks = {{0, {{{0, 0}, 0}, {{1, 0}, 0}, {{1, 1}, 0}}, {}}};
  return blocks;
}

Cover one_element() {
  Cover cover;
  cover.elements = {{{0, 3}, 0, {0, 1, 2}}};
  cover.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 0}};
  cover.nodes = {{0, 0}, {1, 0}, {1, 1}};
  cover.loops = {{0, 3}};
  cover.loop_vertices = {{0, 0}, {1, 0}, {2, 0}, {0, 0}};
  return cover;
}

Analysis shortest_analysis() {
  Analysis analysis;
  analysis.step_count = 1;
  analysis.allowed_displacement_ratio = 1;
  analysis.time_step = 1;
  analysis.block_materials = {{1, 1, 1, 0, 0, {}, {}, {}, {}, 0, {}}};
  analysis.joint_materials = {{1, 0, 0, {}}};
  return analysis;
}

template <typename List>
void fill(List& list, std::size_t count, typename List::value_type item) {
  list.assign(count, item);
}

/// Content of one geometry, or of an analysis, in which one list grows.
template <typename Whole, typename Change>
LongContent grown(std::string name, Whole whole, const Change& change) {
  change(whole);
  Content content;
  if constexpr (std::is_same_v<Whole, Drawing>) content.drawing = std::move(whole);
  if constexpr (std::is_same_v<Whole, Blocks>) content.blocks = std::move(whole);
  if constexpr (std::is_same_v<Whole, Cover>) content.cover = std::move(whole);
  if constexpr (std::is_same_v<Whole, Analysis>) content.analysis = std::move(whole);
  return {std::move(name), std::move(content)};
}

void add_drawings(std::vector<LongContent>& all, std::size_t count) {
  const MarkedPoint mark{{1, 1}, {}};
  all.push_back(grown("joints", square(), [&](Drawing& d) { d.joints.resize(count + 4, d.joints[0]); }));
  all.push_back(grown("boundary lines", square(), [&](Drawing& d) {
    d.joints.resize(count, d.joints[0]);
    d.boundary_count = count;
  }));
  all.push_back(grown("material lines", square(), [&](Drawing& d) {
    fill(d.material_lines, count, {{{0, 0}, {1, 1}}, 0, {}});
  }));
  all.push_back(grown("bolt lines", square(), [&](Drawing& d) {
    fill(d.bolts, count, {{{0, 0}, {1, 1}}, 1, 1, 1, 0, {}});
  }));
  all.push_back(grown("fixed lines", square(), [&](Drawing& d) { fill(d.fixed_lines, count, d.fixed_lines[0]); }));
  all.push_back(grown("loading points", square(), [&](Drawing& d) { fill(d.loading_points, count, mark); }));
  all.push_back(grown("measured points", square(), [&](Drawing& d) { fill(d.measured_points, count, mark); }));
  all.push_back(grown("hole points", square(), [&](Drawing& d) { fill(d.hole_points, count, mark); }));
}

void add_blocks(std::vector<LongContent>& all, std::size_t count) {
  const BlockPoint point{{1, 1}, 0, {}};
  all.push_back(grown("blocks", triangle(), [&](Blocks& b) { fill(b.blocks, count, b.blocks[0]); }));
  all.push_back(grown("vertices of a block", triangle(), [&](Blocks& b) {
    fill(b.blocks[0].outer, count, {{1, 1}, 0});
  }));
  all.push_back(grown("bolts", triangle(), [&](Blocks& b) {
    fill(b.bolts, count, {{{0, 0}, {1, 1}}, 0, 0, 1, 1, 1});
  }));
  all.push_back(grown("fixed points", triangle(), [&](Blocks& b) { fill(b.fixed_points, count, point); }));
  all.push_back(
      grown("measured points of blocks", triangle(), [&](Blocks& b) { fill(b.measured_points, count, point); }));
  all.push_back(grown("points outside blocks", triangle(), [&](Blocks& b) {
    fill(b.measured_points, count, {{1, 1}, -1, {}});
  }));
}

void add_covers(std::vector<LongContent>& all, std::size_t count) {
  const CoverPoint cover_point{{1, 1}, 0, {}};
  all.push_back(grown("elements", one_element(), [&](Cover& c) { fill(c.elements, count, c.elements[0]); }));
  all.push_back(grown("vertex slots", one_element(), [&](Cover& c) { c.vertices.resize(count); }));
  all.push_back(grown("physical covers", one_element(), [&](Cover& c) { c.nodes.resize(count); }));
  all.push_back(grown("contact loops", one_element(), [&](Cover& c) { fill(c.loops, count, c.loops[0]); }));
  all.push_back(grown("loop vertices", one_element(), [&](Cover& c) { c.loop_vertices.resize(count); }));
  all.push_back(
      grown("points of elements", one_element(), [&](Cover& c) { fill(c.fixed_points, count, cover_point); }));
  all.push_back(grown("points outside elements", one_element(), [&](Cover& c) {
    fill(c.fixed_points, count, {{1, 1}, -1, {}});
  }));
}

void add_analyses(std::vector<LongContent>& all, std::size_t count) {
  all.push_back(grown("block materials", shortest_analysis(),
                      [&](Analysis& a) { fill(a.block_materials, count, a.block_materials[0]); }));
  all.push_back(grown("joint materials", shortest_analysis(),
                      [&](Analysis& a) { fill(a.joint_materials, count, a.joint_materials[0]); }));
  all.push_back(grown("bolt properties", shortest_analysis(), [&](Analysis& a) {
    fill(a.bolt_properties, count, {1, 1, 1});
  }));
  all.push_back(grown("rows of a load", shortest_analysis(), [&](Analysis& a) {
    a.point_loads.resize(2);
    for (std::size_t i = 0; i < count; ++i) a.point_loads[0].times.push_back(static_cast<double>(i));
    a.point_loads[0].values.resize(count);
    a.point_loads[1] = {{0, 1}, {{0, 0}, {0, 0}}, {}};
    a.fixed_point_motions.resize(1);
  }));
}

void add_results(std::vector<LongContent>& all, std::size_t count) {
  const auto add = [&](std::string name, std::vector<Frame> frames, std::vector<MeasuredTrack> tracks) {
    Content content;
    content.frames = std::move(frames);
    content.tracks = std::move(tracks);
    all.push_back({std::move(name), std::move(content)});
  };
  const ElementFrame element{{{{0, 0}, {1, 0}, {0, 1}}}, 0, {}, {}, 0, {}, {}, 0, 0, 0};
  const Frame frame{0, 0, {element}, {}, {}, {}, {}};
  add("frames", std::vector(count / 3, frame), {});
  add("elements of a frame", {{0, 0, std::vector(count / 3, element), {}, {}, {}, {}}}, {});
  add("points of a frame", {{0, 0, {element}, std::vector(count, PointFrame{}), {}, {}, {}}}, {});
  add("bolts of a frame", {{0, 0, {element}, {}, {}, {}, std::vector(count, BoltFrame{})}}, {});
  add("tracks", {}, std::vector<MeasuredTrack>(count));
  add("rows of a track", {}, {{0, std::vector<MeasuredRow>(count)}});
}

}  // namespace

std::vector<LongContent> long_contents(std::size_t count) {
  std::vector<LongContent> all;
  add_drawings(all, count);
  add_blocks(all, count);
  add_covers(all, count);
  add_analyses(all, count);
  add_results(all, count);
  return all;
}

}  // namespace keyblock::support
