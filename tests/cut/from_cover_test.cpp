// A cover file as a cut mesh: elements, covers, loops and materials are those of the file, and writing gives the file
// back.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/covers/from_cover.hpp"

#include <gtest/gtest.h>

#include <tuple>

#include "cut/bodies/cut_blocks.hpp"
#include "cut/covers/absorb.hpp"
#include "cut/covers/cut_cover.hpp"
#include "cut/covers/to_cover.hpp"
#include "cut/mesh/background_mesh.hpp"
#include "tests/cut/drawings.hpp"
#include "tests/cut/manifolds.hpp"
#include "tests/support/sample_covers.hpp"

namespace keyblock::from_cover_test {
namespace {

// Pieces and covers of each file, counted from their loops apart from this program. Bodies are the loops less two for
// every hole (a hole has a loop of its own, and two of five in cv15 are one ring).
struct Sample {
  const char* number;
  std::size_t elements;
  std::size_t covers;
  std::size_t loops;
  std::size_t bodies;
};
const std::vector<Sample> kSamples = {{"01", 43, 37, 2, 2},     {"02", 39, 31, 1, 1},     {"03", 61, 73, 11, 11},
                                      {"04", 96, 76, 4, 4},     {"06", 93, 81, 7, 7},     {"07", 125, 90, 1, 1},
                                      {"09", 65, 57, 2, 2},     {"10", 259, 269, 18, 18}, {"12", 115, 92, 3, 3},
                                      {"13", 288, 329, 44, 44}, {"14", 321, 226, 2, 2},   {"15", 362, 275, 5, 2}};

// Contents of a cover, in any order of its slots.
using Loop = std::vector<std::tuple<double, double, int>>;  // x, y, joint material

std::vector<Loop> loops_of(const Cover& cover) {
  std::vector<Loop> loops;
  for (const SlotRange& range : cover.loops) {
    const std::vector<Point> corners = cover.corners(range);
    Loop loop;
    for (std::size_t i = 0; i < corners.size(); ++i)
      loop.emplace_back(corners[i].x, corners[i].y,
                        cover.loop_vertices[static_cast<std::size_t>(range.first) + i].joint_material);
    loops.push_back(loop);
  }
  return loops;
}

void expect_same(const Cover& a, const Cover& b) {
  ASSERT_EQ(a.elements.size(), b.elements.size());
  for (std::size_t e = 0; e < a.elements.size(); ++e) {
    const auto first = a.polygon(a.elements[e]);
    const auto second = b.polygon(b.elements[e]);
    EXPECT_TRUE(std::equal(first.begin(), first.end(), second.begin(), second.end())) << "element " << e + 1;
    EXPECT_EQ(a.elements[e].covers, b.elements[e].covers);
    EXPECT_EQ(a.elements[e].material, b.elements[e].material);
  }
  EXPECT_EQ(a.nodes, b.nodes);
  EXPECT_EQ(loops_of(a), loops_of(b));
}

Blocks blocks_with(const ElementPoints& points) {
  Blocks blocks;
  const auto add = [](const std::vector<CoverPoint>& from, std::vector<BlockPoint>& to) {
    for (const CoverPoint& p : from) to.push_back({p.position, 0, p.place});
  };
  add(points.fixed, blocks.fixed_points);
  return blocks;
}

// A plate with a crack, a hole in one triangle and a joint right through.
Drawing plate() {
  Drawing drawing = drawing_of(rectangle_sides({0, 0}, {4, 2}) + rectangle_sides({1, 0.9}, {1.02, 0.93}) +
                                   std::vector<Segment>{{{2.5, 2.01}, {2.6, 0.7}}, {{3.2, -0.1}, {3.4, 2.1}}},
                               1e-4);
  drawing.hole_points.push_back({{1.01, 0.91}, {}});
  return drawing;
}

Cover own_cover(int half_rows, bool absorbs) {
  const BodyCut bodies = cut_bodies(plate());
  const Box box{{0, 0}, {4, 2}};
  Manifold manifold =
      cut_cover(bodies.graph, regular_triangles(box, centred_mesh(box, half_rows, MeshShape::equilateral)));
  if (absorbs) absorb_small_pieces(manifold);
  return to_cover(manifold, bodies.blocks.blocks);
}

}  // namespace

class SampleCovers : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_sample_covers()) GTEST_SKIP() << "no samples; name their folder in KEYBLOCK_SHARED";
  }
};

TEST_F(SampleCovers, are_cut_meshes_with_the_pieces_covers_loops_and_bodies_of_the_file) {
  for (const Sample& sample : kSamples) {
    SCOPED_TRACE(sample.number);
    const Cover cover = sample_cover(sample.number);
    const Manifold manifold = manifold_of(cover);
    EXPECT_EQ(manifold.elements.size(), sample.elements);
    EXPECT_EQ(manifold.covers.size(), sample.covers);
    EXPECT_EQ(manifold.boundary_loops.size(), sample.loops);
    EXPECT_EQ(manifold.body_materials.size(), sample.bodies);
    expect_loops_closed(manifold);
    expect_euler(manifold);
    double in_elements = 0;
    for (const ManifoldElement& element : manifold.elements) in_elements += area(manifold, element);
    EXPECT_NEAR(area_within_loops(manifold), in_elements, 1e-12 * in_elements);
    expect_same(to_cover(manifold, {}), cover);
  }
}

TEST(FromCover, our_own_cut_meshes_come_back) {
  for (const int half_rows : {2, 3, 5, 8}) {
    for (const bool absorbs : {false, true}) {
      const Cover cover = own_cover(half_rows, absorbs);
      const Manifold manifold = manifold_of(cover);
      if (!absorbs) expect_sound(manifold);
      EXPECT_EQ(manifold.body_materials.size(), 2U) << "the joint parts the plate";
      const Cover again = to_cover(manifold, blocks_with(points_of(cover)));
      expect_same(again, cover);
      EXPECT_EQ(again.vertices, cover.vertices);
      EXPECT_EQ(again.loop_vertices, cover.loop_vertices);
    }
  }
}

TEST(FromCover, a_hole_inside_one_element_is_a_hole_again) {
  const Manifold manifold = manifold_of(own_cover(3, false));
  ASSERT_EQ(manifold.holes.size(), 1U);
  EXPECT_EQ(manifold.holes[0].size, 4);
}

TEST(FromCover, an_edge_that_leads_nowhere_is_refused) {
  Cover cover = own_cover(3, false);
  cover.place = {"odd.cv"};
  cover.loops.pop_back();
  try {
    manifold_of(cover);
    FAIL() << "a loop is missing";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("shares two covers"), std::string::npos) << error.what();
  }
}

TEST(FromCover, a_loop_off_the_elements_is_refused) {
  Cover cover = own_cover(3, false);
  cover.loop_vertices[1].slot += 1;
  EXPECT_THROW(manifold_of(cover), InputError);
}

}  // namespace keyblock::from_cover_test
