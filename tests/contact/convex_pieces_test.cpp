// Convex pieces: corners of convex blocks, cuts of others.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/find/convex_pieces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/polygon.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::convex_pieces_test {
namespace {

Model model_of(const BlockLoop& loop, std::vector<BlockLoop> holes = {}) {
  Blocks blocks;
  blocks.blocks = {{0, loop, std::move(holes)}};
  return model_from_blocks(blocks, support::plain_analysis(1, 1));
}

ConvexPieces pieces_of(const BlockLoop& loop, std::vector<BlockLoop> holes = {}) {
  return convex_pieces(model_of(loop, std::move(holes)), {0});
}

BlockLoop loop_of(const std::vector<Point>& points) {
  BlockLoop loop;
  for (Point p : points) loop.push_back({p, 0});
  return loop;
}

}  // namespace

TEST(ConvexPieces, a_vertex_on_a_straight_edge_is_no_corner) {
  const ConvexPieces pieces = pieces_of(loop_of({{0, 0}, {1, 0}, {1, 0.4}, {1, 1}, {0, 1}}));
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].corners, (std::vector<VertexIndex>{{0}, {1}, {3}, {4}}));
  EXPECT_EQ(pieces[0].is_inner, (std::vector<bool>{false, false, false, false}));
}

TEST(ConvexPieces, a_tip_is_a_corner_and_a_repeated_vertex_is_one) {
  EXPECT_EQ(pieces_of(loop_of({{0, 0}, {1, 0}, {0.5, 1e5}})).front().corners.size(), 3U);
  const ConvexPieces square = pieces_of(loop_of({{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_EQ(square.front().corners, (std::vector<VertexIndex>{{0}, {1}, {3}, {4}}));
}

// The feet of a hill lie on one line: a diagonal between them would put an inner edge on that line too.
TEST(ConvexPieces, no_inner_edge_lies_on_one_line_with_an_edge_of_the_boundary) {
  const Model model = model_of(loop_of({{-1, -2}, {10, -2}, {10, 0}, {3, 0}, {2.2, 1}, {1, 0}, {-1, 0}}));
  for (const ConvexPiece& piece : convex_pieces(model, {0})) {
    const std::size_t n = piece.corners.size();
    const auto at = [&](std::size_t i) {
      return model.start_vertices[static_cast<std::size_t>(piece.corners[i % n].value)];
    };
    for (std::size_t i = 0; i < n; ++i) {
      if (piece.is_inner[i] == piece.is_inner[(i + 1) % n]) continue;
      EXPECT_GT(std::abs(cross(at(i + 1) - at(i), at(i + 2) - at(i + 1))), 1e-3);
    }
  }
}

// Pieces are convex and fill the block, and every inner edge has its twin.
void expect_convex_and_full(const std::vector<Point>& outer, const std::vector<std::vector<Point>>& holes) {
  std::vector<BlockLoop> loops;
  double expected = area(outer);
  for (const std::vector<Point>& hole : holes) {
    loops.push_back(loop_of(hole));
    expected += area(hole);  // clockwise
  }
  const Model model = model_of(loop_of(outer), loops);
  double sum = 0;
  std::size_t inner = 0;
  const ConvexPieces pieces = convex_pieces(model, {0});
  for (const ConvexPiece& piece : pieces) {
    std::vector<Point> loop;
    for (VertexIndex v : piece.corners) loop.push_back(model.start_vertices[static_cast<std::size_t>(v.value)]);
    sum += area(loop);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point a = loop[i], b = loop[(i + 1) % loop.size()], c = loop[(i + 2) % loop.size()];
      EXPECT_GE(cross(b - a, c - b), -1e-12);
      inner += piece.is_inner[i] ? 1 : 0;
    }
  }
  EXPECT_NEAR(sum, expected, 1e-12);
  EXPECT_EQ(inner, 2 * (pieces.size() - 1 + holes.size()));
}

TEST(ConvexPieces, an_l_a_notch_and_a_comb_are_cut_at_their_reflex_corners) {
  expect_convex_and_full({{0, 0}, {5, 0}, {5, 1}, {1, 1}, {1, 4}, {0, 4}}, {});
  expect_convex_and_full({{0, 0}, {6, 0}, {6, 3}, {3, 1}, {0, 3}}, {});
  expect_convex_and_full(
      {{0, 0}, {7, 0}, {7, 3}, {6, 3}, {6, 1}, {4, 1}, {4, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, {});
}

TEST(ConvexPieces, a_corner_is_reflex_in_both_pieces_that_share_it) {
  const ConvexPieces pieces = pieces_of(loop_of({{0, 0}, {5, 0}, {5, 1}, {1, 1}, {1, 4}, {0, 4}}));
  ASSERT_EQ(pieces.size(), 2U);
  for (const ConvexPiece& piece : pieces)
    for (std::size_t i = 0; i < piece.corners.size(); ++i)
      EXPECT_EQ(piece.is_reflex[i], piece.corners[i] == VertexIndex{3}) << piece.corners[i].value;
}

TEST(ConvexPieces, holes_are_cut_around) {
  const std::vector<Point> square{{0, 0}, {6, 0}, {6, 6}, {0, 6}};
  const std::vector<Point> low{{1, 1}, {1, 2}, {2, 2}, {2, 1}};
  const std::vector<Point> triangle{{3, 3}, {4, 5}, {5, 3.2}};
  expect_convex_and_full(square, {low});
  expect_convex_and_full(square, {low, triangle});
  expect_convex_and_full(square, {triangle, {{1.2, 4}, {2.5, 5.5}, {2.6, 4.5}}, low});
  // A tunnel: a polygon of many corners.
  std::vector<Point> circle;
  for (int i = 0; i < 24; ++i)
    circle.push_back(Point{3, 3} + 2.0 * Point{std::cos(-i * 0.2617993878), std::sin(-i * 0.2617993878)});
  expect_convex_and_full(square, {circle});
  expect_convex_and_full({{0, 0}, {6, 0}, {6, 6}, {3, 4}, {0, 6}}, {{{1, 1}, {1, 2}, {5, 2}, {5, 1}}});
}

// Pieces beside them would not be convex: blocks would fall through rock.
TEST(ConvexPieces, holes_that_meet_each_other_or_the_outline_have_none) {
  const BlockLoop square = loop_of({{0, 0}, {6, 0}, {6, 6}, {0, 6}});
  const BlockLoop low = loop_of({{1, 1}, {1, 3}, {3, 3}, {3, 1}});
  EXPECT_TRUE(pieces_of(square, {low, loop_of({{3, 3}, {3, 5}, {5, 5}, {5, 3}})}).empty());
  EXPECT_TRUE(pieces_of(square, {loop_of({{0, 2}, {2, 4}, {2, 1}})}).empty());
}

}  // namespace keyblock::convex_pieces_test
