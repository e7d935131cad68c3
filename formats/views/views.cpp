// Makes a frame at rest from the available geometry, and rows of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/views/views.hpp"

#include <fmt/format.h>

#include <array>
#include <initializer_list>
#include <stdexcept>

#include "formats/text/csv.hpp"
#include "formats/text/numbers.hpp"
#include "formats/views/vtk.hpp"
#include "geometry/polygon.hpp"

namespace keyblock::formats {
namespace {

ElementFrame at_rest(std::vector<std::vector<Point>> loops, int material) {
  ElementFrame element;
  for (const std::vector<Point>& loop : loops) element.area += area(loop);
  element.centroid = centroid(loops.front());
  element.loops = std::move(loops);
  element.material = material;
  return element;
}

Frame frame_of(const Blocks& blocks) {
  Frame frame;
  for (const BlockPolygon& block : blocks.blocks) {
    std::vector<std::vector<Point>> loops{points_of(block.outer)};
    for (const BlockLoop& hole : block.holes) loops.push_back(points_of(hole));
    frame.elements.push_back(at_rest(std::move(loops), block.material));
  }
  return frame;
}

Frame frame_of(const Cover& cover) {
  Frame frame;
  for (const CoverElement& element : cover.elements) {
    const auto polygon = cover.polygon(element);
    frame.elements.push_back(at_rest({{polygon.begin(), polygon.end()}}, element.material));
  }
  return frame;
}

std::string drawn(const Frame& frame) {
  return vtu(with_derived(columns_of(frame, {})), {}, VtkCoding::text);
}

std::string write_vtk(const Content& content) {
  if (!content.frames.empty()) return drawn(content.frames.back());
  if (content.blocks) return drawn(frame_of(*content.blocks));
  if (content.cover) return drawn(frame_of(*content.cover));
  throw std::invalid_argument("there are no blocks, elements or frames to write");
}

class Rows {
 public:
  void add(const char* kind, std::size_t part, std::size_t loop, Point p, int material) {
    text +=
        fmt::format("{},{},{},{},{},{}\n", kind, part + 1, loop + 1, format_real(p.x), format_real(p.y), material + 1);
  }
  template <class Line>
  void add_lines(const char* kind, const std::vector<Line>& lines, int Line::*material) {
    for (std::size_t i = 0; i < lines.size(); ++i) add_line(kind, i, lines[i].segment, lines[i].*material);
  }
  void add_line(const char* kind, std::size_t part, const Segment& line, int material) {
    add(kind, part, 0, line.start, material);
    add(kind, part, 0, line.end, material);
  }
  template <class Mark>
  void add_points(const char* kind, const std::vector<Mark>& points) {
    for (std::size_t i = 0; i < points.size(); ++i) add(kind, i, 0, points[i].position, 0);
  }

  std::string text = "kind,part,loop,x,y,material\n";
};

std::string rows_of(const Drawing& drawing) {
  Rows rows;
  rows.add_lines("joint", drawing.joints, &JointLine::joint_material);
  rows.add_lines("material_line", drawing.material_lines, &MaterialLine::block_material);
  rows.add_lines("bolt", drawing.bolts, &BoltLine::type);
  for (std::size_t i = 0; i < drawing.fixed_lines.size(); ++i)
    rows.add_line("fixed", i, drawing.fixed_lines[i].segment, 0);
  rows.add_points("loading", drawing.loading_points);
  rows.add_points("measured", drawing.measured_points);
  rows.add_points("hole", drawing.hole_points);
  return rows.text;
}

template <class Geometry>
void add_carried(Rows& rows, const Geometry& geometry) {
  rows.add_points("fixed", geometry.fixed_points);
  rows.add_points("loading", geometry.loading_points);
  rows.add_points("measured", geometry.measured_points);
}

std::string rows_of(const Blocks& blocks) {
  Rows rows;
  for (std::size_t i = 0; i < blocks.blocks.size(); ++i) {
    const BlockPolygon& block = blocks.blocks[i];
    for (const BlockVertex& v : block.outer) rows.add("block", i, 0, v.position, v.joint_material);
    for (std::size_t hole = 0; hole < block.holes.size(); ++hole)
      for (const BlockVertex& v : block.holes[hole]) rows.add("block", i, hole + 1, v.position, v.joint_material);
  }
  for (std::size_t i = 0; i < blocks.bolts.size(); ++i) rows.add_line("bolt", i, blocks.bolts[i].segment, 0);
  add_carried(rows, blocks);
  return rows.text;
}

std::string rows_of(const Cover& cover) {
  Rows rows;
  for (std::size_t i = 0; i < cover.elements.size(); ++i)
    for (const Point p : cover.polygon(cover.elements[i])) rows.add("element", i, 0, p, cover.elements[i].material);
  for (std::size_t i = 0; i < cover.loops.size(); ++i) {
    const std::vector<Point> corners = cover.corners(cover.loops[i]);
    for (std::size_t k = 0; k < corners.size(); ++k)
      rows.add("loop", i, 0, corners[k],
               cover.loop_vertices[static_cast<std::size_t>(cover.loops[i].first) + k].joint_material);
  }
  add_carried(rows, cover);
  return rows.text;
}

std::string write_csv(const Content& content) {
  if (!content.frames.empty()) return blocks_csv(content.frames);
  if (content.drawing) return rows_of(*content.drawing);
  if (content.blocks) return rows_of(*content.blocks);
  if (content.cover) return rows_of(*content.cover);
  throw std::invalid_argument("there is no geometry and there are no frames to write");
}

constexpr std::array<std::string_view, 7> kNeverShown{"units",  "covers", "analysis", "motion",
                                                      "tracks", "run",    "outputs"};

// Lists everything except the part that the view writes.
LeftOut all_but(std::string_view part) {
  LeftOut left_out{{kNeverShown.begin(), kNeverShown.end()}, 0};
  for (const std::string_view geometry : {"drawing", "blocks", "cover"})
    if (geometry != part) left_out.items.push_back(geometry);
  return left_out;
}

LeftOut with(LeftOut left_out, std::initializer_list<std::string_view> items) {
  left_out.items.insert(left_out.items.end(), items);
  return left_out;
}

}  // namespace

LeftOut left_out_by_vtk(const Content& content) {
  if (!content.frames.empty()) {
    LeftOut left_out =
        with(all_but("frames"),
             {"frames[].step", "frames[].elements[].mass", "frames[].elements[].moment_of_inertia",
              "frames[].fixed_points", "frames[].loading_points", "frames[].measured_points", "frames[].bolts"});
    left_out.frames_shown = 1;
    return left_out;
  }
  if (content.blocks)
    return with(all_but("blocks"),
                {"blocks.blocks[].outer[].joint_material", "blocks.blocks[].holes[][].joint_material", "blocks.bolts",
                 "blocks.fixed_points", "blocks.loading_points", "blocks.measured_points"});
  return with(all_but("cover"), {"cover.elements[].cover_1", "cover.elements[].cover_2", "cover.elements[].cover_3",
                                 "cover.nodes", "cover.loops", "cover.loop_vertices", "cover.fixed_points",
                                 "cover.loading_points", "cover.measured_points"});
}

LeftOut left_out_by_csv(const Content& content) {
  if (!content.frames.empty()) {
    LeftOut left_out = with(
        all_but("frames"),
        {"frames[].elements[].loops", "frames[].elements[].velocity_x", "frames[].elements[].velocity_y",
         "frames[].elements[].velocity_rotation", "frames[].elements[].mass", "frames[].elements[].moment_of_inertia",
         "frames[].fixed_points", "frames[].loading_points", "frames[].measured_points", "frames[].bolts"});
    left_out.frames_shown = content.frames.size();
    return left_out;
  }
  if (content.drawing)
    return with(all_but("drawing"), {"drawing.edge_node_ratio", "drawing.boundary_count", "drawing.bolts[].stiffness",
                                     "drawing.bolts[].strength", "drawing.bolts[].pretension"});
  if (content.blocks)
    return with(all_but("blocks"),
                {"blocks.blocks[].material", "blocks.bolts[].first_block", "blocks.bolts[].second_block",
                 "blocks.bolts[].stiffness", "blocks.bolts[].strength", "blocks.bolts[].pretension",
                 "blocks.fixed_points[].block", "blocks.loading_points[].block", "blocks.measured_points[].block"});
  return with(all_but("cover"),
              {"cover.elements[].cover_1", "cover.elements[].cover_2", "cover.elements[].cover_3", "cover.nodes",
               "cover.fixed_points[].element", "cover.loading_points[].element", "cover.measured_points[].element"});
}

constinit const Format kVtk{.name = "vtk",
                            .title = "VTK unstructured grid, for ParaView",
                            .write = write_vtk,
                            .evidence = "documented by VTK; written for viewers, not read"};
constinit const Format kCsv{.name = "csv",
                            .title = "table of corners and marks, or of frames",
                            .write = write_csv,
                            .evidence = "documented here: formats/views/views.hpp; not read"};

}  // namespace keyblock::formats
