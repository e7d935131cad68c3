// Declares the keys of drawings, blocks and covers in a case file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/case_file/fields/field_demands.hpp"

namespace keyblock::formats {

template <class F>
void describe(F& f, In<F, Point>& point) {
  f.real("x", point.x);
  f.real("y", point.y);
}

template <class F>
void describe(F& f, In<F, Segment>& segment) {
  f.real("x1", segment.start.x);
  f.real("y1", segment.start.y);
  f.real("x2", segment.end.x);
  f.real("y2", segment.end.y);
}

template <class F>
void describe(F& f, In<F, JointLine>& line) {
  describe(f, line.segment);
  f.index("joint_material", line.joint_material);
}

template <class F>
void describe(F& f, In<F, MaterialLine>& line) {
  describe(f, line.segment);
  f.index("block_material", line.block_material);
}

template <class F>
void describe(F& f, In<F, BoltLine>& bolt) {
  describe(f, bolt.segment);
  f.real("stiffness", bolt.stiffness);
  f.real("strength", bolt.strength);
  f.real("pretension", bolt.pretension);
  f.index("type", bolt.type);
  f.name_at_end("name", bolt.name);
}

template <class F>
void describe(F& f, In<F, FixedLine>& line) {
  describe(f, line.segment);
}

template <class F>
void describe(F& f, In<F, MarkedPoint>& point) {
  describe(f, point.position);
}

template <class F>
void describe(F& f, In<F, Drawing>& drawing) {
  f.real("edge_node_ratio", drawing.edge_node_ratio, kEdgeNodeRatio);
  f.integer("boundary_count", drawing.boundary_count, kWhole);
  f.rows("joints", drawing.joints);
  f.rows("material_lines", drawing.material_lines);
  f.rows("bolts", drawing.bolts);
  f.rows("fixed_lines", drawing.fixed_lines);
  f.rows("loading_points", drawing.loading_points);
  f.rows("measured_points", drawing.measured_points);
  f.rows("hole_points", drawing.hole_points);
}

template <class F>
void describe(F& f, In<F, BlockVertex>& vertex) {
  describe(f, vertex.position);
  f.index("joint_material", vertex.joint_material);
}

template <class F>
void describe(F& f, In<F, BlockPolygon>& block) {
  f.index("material", block.material);
  f.rows("outer", block.outer, 3);
  f.lists("holes", block.holes);
}

template <class F>
void describe(F& f, In<F, BlockBolt>& bolt) {
  describe(f, bolt.segment);
  f.index("first_block", bolt.first_block);
  f.index("second_block", bolt.second_block);
  f.real("stiffness", bolt.stiffness);
  f.real("strength", bolt.strength);
  f.real("pretension", bolt.pretension);
  f.name_at_end("name", bolt.name);
}

template <class F>
void describe(F& f, In<F, BlockPoint>& point) {
  describe(f, point.position);
  f.index("block", point.block);
}

template <class F>
void describe(F& f, In<F, Blocks>& blocks) {
  f.objects("blocks", blocks.blocks);
  f.rows("bolts", blocks.bolts);
  f.rows("fixed_points", blocks.fixed_points);
  f.rows("loading_points", blocks.loading_points);
  f.rows("measured_points", blocks.measured_points);
}

template <class F>
void describe(F& f, In<F, SlotRange>& range) {
  f.index("first", range.first);
  f.integer("size", range.size, kWhole);
}

template <class F>
void describe(F& f, In<F, CoverElement>& element) {
  describe(f, element.vertices);
  f.index("material", element.material);
  f.index("cover_1", element.covers[0]);
  f.index("cover_2", element.covers[1]);
  f.index("cover_3", element.covers[2]);
}

template <class F>
void describe(F& f, In<F, LoopVertex>& vertex) {
  f.index("slot", vertex.slot);
  f.index("joint_material", vertex.joint_material);
}

template <class F>
void describe(F& f, In<F, CoverPoint>& point) {
  describe(f, point.position);
  f.index("element", point.element);
}

template <class F>
void describe(F& f, In<F, Cover>& cover) {
  f.rows("elements", cover.elements);
  f.rows("vertices", cover.vertices);
  f.rows("nodes", cover.nodes);
  f.rows("loops", cover.loops);
  f.rows("loop_vertices", cover.loop_vertices);
  f.rows("fixed_points", cover.fixed_points);
  f.rows("loading_points", cover.loading_points);
  f.rows("measured_points", cover.measured_points);
}

}  // namespace keyblock::formats
