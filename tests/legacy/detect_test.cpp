// Contacts at concave corners, the half of a parallel pair that acts, and the list kept when nothing is found.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/contact/detect.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "legacy/contact/line.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::detect_test {
namespace {

using support::legacy_scene;
using support::plain_analysis;
using support::rectangle;
using support::step_once;

Analysis fine_analysis() {
  Analysis analysis = plain_analysis(0.01, 10);
  analysis.allowed_displacement_ratio = 0.01;  // searched within 2.5 × 0.01 w0
  return analysis;
}

Detection detected(const std::vector<BlockPolygon>& blocks) {
  const ShiScene scene = legacy_scene({blocks, {}, {}, {}, {}, {}}, fine_analysis());
  return detect(scene.model, start(scene).state, scene.settings, scene.rules);
}

using Numbers = std::array<int, 3>;

std::vector<Numbers> triples_of(const Contacts& contacts) {
  std::vector<Numbers> triples;
  for (const Contact& c : contacts) triples.push_back({c.first.vertex.value, c.first.start.value, c.first.end.value});
  std::ranges::sort(triples);
  return triples;
}

/// Concave at its vertex number 3, (1, 1).
const BlockPolygon kAngle{0, {{{0, 0}, 0}, {{4, 0}, 0}, {{4, 1}, 0}, {{1, 1}, 0}, {{1, 4}, 0}, {{0, 4}, 0}}, {}};

}  // namespace

// Legacy-rules 2: a convex vertex in a concave one is a vertex-edge candidate with each of its two edges, never
// vertex-vertex. The square's other two lower and left corners have contact with the edges alone.
TEST(Detect, a_square_in_a_concave_corner_touches_both_edges_of_it) {
  const BlockPolygon square = rectangle({1, 1}, {2, 2});
  const Contacts concave_first = detected({kAngle, square}).contacts;
  EXPECT_EQ(triples_of(concave_first), (std::vector<Numbers>{{6, 3, 2}, {6, 4, 3}, {7, 3, 2}, {9, 4, 3}}));
  const Contacts concave_second = detected({square, kAngle}).contacts;
  EXPECT_EQ(triples_of(concave_second), (std::vector<Numbers>{{0, 7, 6}, {0, 8, 7}, {1, 7, 6}, {3, 8, 7}}));
  for (const Contacts& contacts : {concave_first, concave_second}) {
    for (const Contact& c : contacts) EXPECT_EQ(c.kind, ContactKind::vertex_edge);
  }
}

TEST(Detect, reference_lines_have_the_other_block_outside) {
  const ShiScene scene =
      legacy_scene({{kAngle, rectangle({1.001, 1.002}, {2, 2})}, {}, {}, {}, {}, {}}, fine_analysis());
  const State state = start(scene).state;
  const Contacts contacts = detect(scene.model, state, scene.settings, scene.rules).contacts;
  ASSERT_EQ(contacts.size(), 4U);
  for (const Contact& c : contacts) {
    const double gap = line_of(state, c.first).distance();
    EXPECT_GT(gap, 0.0009);
    EXPECT_LT(gap, 0.0021);
  }
}

// Legacy-rules 3: two corners with a parallel pair of edges. The corner acts whose vertex lies between the ends of the
// edge of its partner.
TEST(Detect, of_a_parallel_pair_the_vertex_that_lies_beside_the_others_edge_acts) {
  const BlockPolygon lower = rectangle({0, 0}, {1, 1});
  const Contacts to_the_right = detected({lower, rectangle({0.02, 1}, {1.02, 2})}).contacts;
  EXPECT_EQ(triples_of(to_the_right), (std::vector<Numbers>{{2, 5, 4}, {4, 3, 2}}));
  const Contacts to_the_left = detected({lower, rectangle({-0.02, 1}, {0.98, 2})}).contacts;
  EXPECT_EQ(triples_of(to_the_left), (std::vector<Numbers>{{3, 5, 4}, {5, 3, 2}}));
  for (const Contacts& contacts : {to_the_right, to_the_left}) {
    for (const Contact& c : contacts) {
      EXPECT_TRUE(c.parallel_pair);
      EXPECT_EQ(c.kind, ContactKind::vertex_edge);
      EXPECT_NE(c.first.vertex, c.second.vertex);
    }
  }
}

namespace {

/// A square thrown up from its base, 0.05 a step: within reach (0.0625) at the start of two steps, then in the air.
std::vector<int> contact_counts_of_a_throw(bool stale_list) {
  Analysis analysis = fine_analysis();
  analysis.gravity = 0;
  ShiScene scene =
      legacy_scene({{rectangle({-2, -1}, {3, 0}), rectangle({0, 0}, {1, 1})}, {}, {}, {}, {}, {}}, analysis);
  scene.settings.quirks.stale_contact_list = stale_list;
  Stepping stepping = start(scene);
  stepping.state.elements[ElementIndex{1}].velocity[1] = 5;
  std::vector<int> counts;
  for (int i = 0; i < 5; ++i) {
    const StepReport report = step_once(scene, stepping);
    counts.push_back(report.contacts);
    EXPECT_EQ(report.closed, 0) << "step " << report.step;
  }
  return counts;
}

}  // namespace

TEST(Detect, a_step_that_finds_no_contact_keeps_the_last_list_under_the_quirk) {
  EXPECT_EQ(contact_counts_of_a_throw(true), (std::vector<int>{2, 2, 2, 2, 2}));
  EXPECT_EQ(contact_counts_of_a_throw(false), (std::vector<int>{2, 2, 0, 0, 0}));
}

// The list of near vertices is kept while blocks move through one another, fast and slowly, and gives the contacts of a
// new search at every step.
TEST(Detect, a_kept_list_of_near_vertices_gives_the_contacts_of_a_new_search) {
  std::vector<BlockPolygon> blocks;
  for (int i = 0; i < 30; ++i)
    blocks.push_back(rectangle({1.0 * (i % 6), 1.0 * (i / 6)}, {1.0 * (i % 6) + 1, 1.0 * (i / 6) + 1}));
  const ShiScene scene = legacy_scene({blocks, {}, {}, {}, {}, {}}, fine_analysis());
  State state = start(scene).state;
  NearVertices near;
  std::mt19937 numbers(5);
  std::uniform_real_distribution<double> way(-1, 1);
  std::size_t contacts = 0;
  for (int step = 0; step < 60; ++step) {
    const Contacts kept = detect(scene.model, state, scene.settings, scene.rules, near).contacts;
    const Contacts fresh = detect(scene.model, state, scene.settings, scene.rules).contacts;
    ASSERT_EQ(kept.size(), fresh.size()) << "step " << step;
    for (std::size_t i = 0; i < kept.size(); ++i)
      EXPECT_TRUE(kept[i].first == fresh[i].first && kept[i].second == fresh[i].second) << step << " " << i;
    contacts += kept.size();
    for (ElementIndex e : indices(scene.model.elements)) {
      const Point move{(step < 30 ? 0.002 : 0.05) * way(numbers), (step < 30 ? 0.002 : 0.05) * way(numbers)};
      for (VertexIndex v : scene.model.elements[e].vertices()) state.vertices[v] = state.vertices[v] + move;
    }
  }
  EXPECT_GT(contacts, 60U * 30U);
}

}  // namespace keyblock::detect_test
