// One content a list; the rest of it is as small as a file may be.
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

}  // namespace

std::vector<LongContent> long_contents(std::size_t count) {
  std::vector<LongContent> all;
  const auto add = [&](std::string name, auto geometry, auto change) {
    change(geometry);
    Content content;
    using Geometry = decltype(geometry);
    if constexpr (std::is_same_v<Geometry, Drawing>) content.drawing = geometry;
    if constexpr (std::is_same_v<Geometry, Blocks>) content.blocks = geometry;
    if constexpr (std::is_same_v<Geometry, Cover>) content.cover = geometry;
    if constexpr (std::is_same_v<Geometry, Analysis>) content.analysis = geometry;
    all.push_back({std::move(name), std::move(content)});
  };
  const MarkedPoint mark{{1, 1}, {}};
  const BlockPoint point{{1, 1}, 0, {}};
  const CoverPoint cover_point{{1, 1}, 0, {}};
  add("joints", square(), [&](Drawing& d) { d.joints.resize(count + 4, d.joints[0]); });
  add("boundary lines", square(), [&](Drawing& d) {
    d.joints.resize(count, d.joints[0]);
    d.boundary_count = count;
  });
  add("material lines", square(), [&](Drawing& d) { fill(d.material_lines, count, {{{0, 0}, {1, 1}}, 0, {}}); });
  add("bolt lines", square(), [&](Drawing& d) { fill(d.bolts, count, {{{0, 0}, {1, 1}}, 1, 1, 1, 0, {}}); });
  add("fixed lines", square(), [&](Drawing& d) { fill(d.fixed_lines, count, d.fixed_lines[0]); });
  add("loading points", square(), [&](Drawing& d) { fill(d.loading_points, count, mark); });
  add("measured points", square(), [&](Drawing& d) { fill(d.measured_points, count, mark); });
  add("hole points", square(), [&](Drawing& d) { fill(d.hole_points, count, mark); });
  add("blocks", triangle(), [&](Blocks& b) { fill(b.blocks, count, b.blocks[0]); });
  add("vertices of a block", triangle(), [&](Blocks& b) { fill(b.blocks[0].outer, count, {{1, 1}, 0}); });
  add("bolts", triangle(), [&](Blocks& b) { fill(b.bolts, count, {{{0, 0}, {1, 1}}, 0, 0, 1, 1, 1}); });
  add("fixed points", triangle(), [&](Blocks& b) { fill(b.fixed_points, count, point); });
  add("measured points of blocks", triangle(), [&](Blocks& b) { fill(b.measured_points, count, point); });
  add("elements", one_element(), [&](Cover& c) { fill(c.elements, count, c.elements[0]); });
  add("vertex slots", one_element(), [&](Cover& c) { c.vertices.resize(count); });
  add("physical covers", one_element(), [&](Cover& c) { c.nodes.resize(count); });
  add("contact loops", one_element(), [&](Cover& c) { fill(c.loops, count, c.loops[0]); });
  add("loop vertices", one_element(), [&](Cover& c) { c.loop_vertices.resize(count); });
  add("points of elements", one_element(), [&](Cover& c) { fill(c.fixed_points, count, cover_point); });
  add("points outside elements", one_element(), [&](Cover& c) { fill(c.fixed_points, count, {{1, 1}, -1, {}}); });
  add("points outside blocks", triangle(), [&](Blocks& b) { fill(b.measured_points, count, {{1, 1}, -1, {}}); });
  add("block materials", shortest_analysis(),
      [&](Analysis& a) { fill(a.block_materials, count, a.block_materials[0]); });
  add("joint materials", shortest_analysis(),
      [&](Analysis& a) { fill(a.joint_materials, count, a.joint_materials[0]); });
  add("bolt properties", shortest_analysis(), [&](Analysis& a) { fill(a.bolt_properties, count, {1, 1, 1}); });
  const auto add_results = [&](std::string name, std::vector<Frame> frames, std::vector<MeasuredTrack> tracks) {
    Content content;
    content.frames = std::move(frames);
    content.tracks = std::move(tracks);
    all.push_back({std::move(name), std::move(content)});
  };
  const ElementFrame element{{{{0, 0}, {1, 0}, {0, 1}}}, 0, {}, {}, 0, {}, {}, 0, 0, 0};
  const Frame frame{0, 0, {element}, {}, {}, {}, {}};
  add_results("frames", std::vector(count / 3, frame), {});
  add_results("elements of a frame", {{0, 0, std::vector(count / 3, element), {}, {}, {}, {}}}, {});
  add_results("points of a frame", {{0, 0, {element}, std::vector(count, PointFrame{}), {}, {}, {}}}, {});
  add_results("bolts of a frame", {{0, 0, {element}, {}, {}, {}, std::vector(count, BoltFrame{})}}, {});
  add_results("tracks", {}, std::vector<MeasuredTrack>(count));
  add_results("rows of a track", {}, {{0, std::vector<MeasuredRow>(count)}});
  add("rows of a load", shortest_analysis(), [&](Analysis& a) {
    a.point_loads.resize(2);
    for (std::size_t i = 0; i < count; ++i) a.point_loads[0].times.push_back(static_cast<double>(i));
    a.point_loads[0].values.resize(count);
    a.point_loads[1] = {{0, 1}, {{0, 0}, {0, 0}}, {}};
    a.fixed_point_motions.resize(1);
  });
  return all;
}

}  // namespace keyblock::support
