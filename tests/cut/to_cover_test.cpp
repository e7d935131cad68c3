// A cut mesh written as a cover file holds the same areas, loops and points, and its holes on one chain.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/covers/to_cover.hpp"

#include <gtest/gtest.h>

#include "cut/bodies/cut_blocks.hpp"
#include "cut/covers/cut_cover.hpp"
#include "cut/mesh/background_mesh.hpp"
#include "formats/registry.hpp"
#include "formats/shi/nmm_cover.hpp"
#include "tests/cut/drawings.hpp"
#include "tests/cut/manifolds.hpp"

namespace keyblock::to_cover_test {
namespace {

/// A rectangle with a crack from its upper edge and a small hole, one point of each kind.
Drawing plate() {
  Drawing drawing = drawing_of(rectangle_sides({0, 0}, {4, 2}) + rectangle_sides({1, 0.9}, {1.02, 0.93}) +
                                   std::vector<Segment>{{{2.5, 2}, {2.6, 0.7}}},
                               1e-4);
  drawing.hole_points.push_back({{1.01, 0.91}, {}});
  drawing.fixed_lines.push_back({{{0.3, 0}, {0.3, 0}}, {}});
  drawing.loading_points.push_back({{4, 2}, {}});
  drawing.measured_points.push_back({{3.1, 1.2}, {}});
  return drawing;
}

struct Cut {
  BodyCut bodies;
  Manifold manifold;
  Cover cover;
};

Cut cut_plate() {
  Cut cut;
  cut.bodies = cut_bodies(plate());
  const Box box{{0, 0}, {4, 2}};
  cut.manifold = cut_cover(cut.bodies.graph, regular_triangles(box, centred_mesh(box, 3, MeshShape::equilateral)));
  cut.cover = to_cover(cut.manifold, cut.bodies.blocks.blocks);
  return cut;
}

}  // namespace

TEST(ToCover, elements_and_loops_enclose_the_body) {
  const Cut cut = cut_plate();
  expect_sound(cut.manifold);
  const double expected = 8 - 0.02 * 0.03;
  double in_elements = 0;
  double in_loops = 0;
  for (const CoverElement& element : cut.cover.elements) in_elements += area(cut.cover.polygon(element));
  for (const SlotRange& loop : cut.cover.loops) in_loops += area(cut.cover.corners(loop));
  EXPECT_NEAR(in_elements, expected, 1e-12);
  EXPECT_NEAR(in_loops, expected, 1e-12);
  EXPECT_EQ(cut.cover.loops.size(), 2U);
  ASSERT_EQ(cut.manifold.holes.size(), 1U) << "the hole lies inside one triangle";
}

TEST(ToCover, points_are_in_elements_that_hold_them) {
  const Cut cut = cut_plate();
  ASSERT_EQ(cut.cover.fixed_points.size(), 1U);
  ASSERT_EQ(cut.cover.loading_points.size(), 1U);
  ASSERT_EQ(cut.cover.measured_points.size(), 1U);
  for (const auto& point : {cut.cover.fixed_points[0], cut.cover.loading_points[0], cut.cover.measured_points[0]}) {
    const CoverElement& element = cut.cover.elements[static_cast<std::size_t>(point.element)];
    EXPECT_NE(side(cut.cover.polygon(element), point.position), Side::outside);
  }
}

TEST(ToCover, a_loop_edge_is_an_edge_of_the_element_that_has_its_slot) {
  const Cut cut = cut_plate();
  for (const SlotRange& loop : cut.cover.loops) {
    for (int i = loop.first; i < loop.first + loop.size; ++i) {
      const int slot = cut.cover.loop_vertices[static_cast<std::size_t>(i)].slot;
      const int next = cut.cover.loop_vertices[static_cast<std::size_t>(i) + 1].slot;
      EXPECT_EQ(cut.cover.vertices[static_cast<std::size_t>(slot) + 1],
                cut.cover.vertices[static_cast<std::size_t>(next)]);
    }
  }
}

TEST(ToCover, the_file_reads_back) {
  const Cut cut = cut_plate();
  formats::Content content;
  content.cover = cut.cover;
  const std::string text = formats::kNmmCover.write(content);
  const formats::Reading reading = formats::read({"plate.cv", text}, {});
  ASSERT_TRUE(reading.content.cover.has_value());
  EXPECT_EQ(reading.content.cover->elements, cut.cover.elements);
  EXPECT_EQ(reading.content.cover->vertices, cut.cover.vertices);
  EXPECT_EQ(reading.content.cover->loop_vertices, cut.cover.loop_vertices);
}

}  // namespace keyblock::to_cover_test
