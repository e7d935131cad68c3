// The grid finds exactly the candidates that testing all against all finds.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/find/candidates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/box_tree.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::candidates_test {
namespace {

using support::legacy_scene;
using support::plain_analysis;
using support::rectangle;

struct Scattered {
  Blocks blocks;
  std::vector<std::pair<Point, Point>> boxes;
};

Scattered scattered(int count, double greatest_size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 30);
  std::uniform_real_distribution<double> size(0.1, greatest_size);
  Scattered scene;
  for (int i = 0; i < count; ++i) {
    const Point low{place(random), place(random)};
    const Point high = low + Point{size(random), size(random)};
    scene.blocks.blocks.push_back(rectangle(low, high));
    scene.boxes.push_back({low, high});
  }
  return scene;
}

std::vector<ElementPair> all_against_all(const Scattered& scene, double distance) {
  std::vector<ElementPair> pairs;
  const int count = static_cast<int>(scene.boxes.size());
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      const auto& [low_a, high_a] = scene.boxes[static_cast<std::size_t>(a)];
      const auto& [low_b, high_b] = scene.boxes[static_cast<std::size_t>(b)];
      if (low_a.x - distance <= high_b.x && low_b.x <= high_a.x + distance && low_a.y - distance <= high_b.y &&
          low_b.y <= high_a.y + distance)
        pairs.push_back({{a}, {b}});
    }
  }
  return pairs;
}

}  // namespace

TEST(Candidates, sizes_over_three_decades_are_found_as_all_against_all_finds_them) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> place(0, 100);
  std::uniform_real_distribution<double> decades(-3, 1.6);
  Scattered scattering;
  for (int i = 0; i < 600; ++i) {
    const Point low{place(random), place(random)};
    const Point high = low + Point{std::pow(10, decades(random)), std::pow(10, decades(random))};
    scattering.blocks.blocks.push_back(rectangle(low, high));
    scattering.boxes.push_back({low, high});
  }
  const ShiScene scene = legacy_scene(scattering.blocks, plain_analysis(1e-3, 1));
  std::vector<Box> boxes;
  for (const auto& [low, high] : scattering.boxes) boxes.push_back({low, high});
  for (double distance : {0.0, 0.01, 1.0}) {
    std::vector<ElementPair> by_tree;
    for (const auto& [a, b] : touching_by_tree(boxes, distance)) by_tree.push_back({{a}, {b}});
    std::ranges::sort(by_tree);
    EXPECT_EQ(by_tree, all_against_all(scattering, distance)) << distance;
  }
  for (double distance : {0.0, 0.01, 1.0})
    EXPECT_EQ(close_pairs(scene.model, start(scene).state, distance), all_against_all(scattering, distance))
        << distance;
}

TEST(Candidates, grid_and_all_against_all_find_the_same_pairs) {
  for (double size : {1.0, 3.0, 40.0}) {  // the last: elements that cover the whole grid
    const Scattered scattering = scattered(300, size, 5);
    const ShiScene scene = legacy_scene(scattering.blocks, plain_analysis(1e-3, 1));
    for (double distance : {0.0, 0.3, 5.0})
      EXPECT_EQ(close_pairs(scene.model, start(scene).state, distance), all_against_all(scattering, distance))
          << "size " << size << " distance " << distance;
  }
}

// Up to eight are tested each with each, more by a grid.
TEST(Candidates, few_are_found_as_many_are) {
  for (const int count : {2, 8, 9, 20}) {
    const Scattered scattering = scattered(count, 15, 3);
    const ShiScene scene = legacy_scene(scattering.blocks, plain_analysis(1e-3, 1));
    const std::vector<ElementPair> expected = all_against_all(scattering, 0.5);
    EXPECT_EQ(close_pairs(scene.model, start(scene).state, 0.5), expected) << count;
    EXPECT_FALSE(count > 2 && expected.empty());
  }
}

TEST(Candidates, one_element_has_no_pair) {
  const ShiScene scene = legacy_scene({{rectangle({0, 0}, {1, 1})}, {}, {}, {}, {}, {}}, plain_analysis(1e-3, 1));
  EXPECT_TRUE(close_pairs(scene.model, start(scene).state, 1).empty());
}

}  // namespace keyblock::candidates_test
