// Transfer from old contacts to new ones, row by row of the transfer table (legacy-rules 4 and 5).
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/contact/carry.hpp"

#include <gtest/gtest.h>

#include "tests/support/scenes.hpp"

namespace keyblock::carry_test {
namespace {

using support::legacy_scene;
using support::plain_analysis;
using support::rectangle;

// The base has vertices 0 … 3 (3 → 2 is its top, 5 long), the square on it 4 … 7.
constexpr Triple kCorner{{4}, {3}, {2}};
constexpr Triple kOther{{3}, {5}, {4}};
constexpr Triple kElsewhere{{5}, {3}, {2}};
constexpr Triple kNowhere{{6}, {1}, {0}};

struct Base {
  ShiScene scene = legacy_scene({{rectangle({-2, -1}, {3, 0}), rectangle({0, 0}, {1, 1})}, {}, {}, {}, {}, {}},
                                plain_analysis(1e-3, 1));
  State state = start(scene).state;
  BerkeleyQuirks quirks;

  Contacts carried(Contacts contacts, const Contacts& previous) const {
    return carry(std::move(contacts), previous, state, scene.rules, quirks);
  }
};

Contact vertex_edge(Triple first, ContactState state = ContactState::open) {
  Contact contact;
  contact.first = first;
  contact.state = state;
  return contact;
}

Contact vertex_vertex(Triple first, Triple second, ContactState state = ContactState::open) {
  Contact contact = vertex_edge(first, state);
  contact.kind = ContactKind::vertex_vertex;
  contact.second = second;
  return contact;
}

Contact parallel_pair(Triple first, Triple second, ContactState state = ContactState::open) {
  Contact contact = vertex_edge(first, state);
  contact.parallel_pair = true;
  contact.second = second;
  return contact;
}

// Legacy-rules 4: the state that the old contact hands on is 1, 2, or 0 through its first triple and 1 or 0 through its
// second. A vertex-edge contact takes (b), the state handed to its second triple, before (a), that to its first.
struct Row {
  const char* what;
  Contact old;
  Contact fresh;
  ContactState expected;
};

const Row kTable[] = {
    {"vertex-edge: sliding stays", vertex_edge(kCorner, ContactState::sliding), vertex_edge(kCorner),
     ContactState::sliding},
    {"vertex-edge: locked stays", vertex_edge(kCorner, ContactState::locked), vertex_edge(kCorner),
     ContactState::locked},
    {"another triple is another contact", vertex_edge(kElsewhere, ContactState::locked), vertex_edge(kCorner),
     ContactState::open},
    {"a parallel pair whose halves were exchanged", parallel_pair(kCorner, kOther, ContactState::sliding),
     parallel_pair(kOther, kCorner), ContactState::sliding},
    {"the second triple of a parallel pair hands on nothing", parallel_pair(kCorner, kOther, ContactState::locked),
     vertex_edge(kOther), ContactState::open},
    {"vertex-edge to first line", vertex_edge(kCorner, ContactState::locked), vertex_vertex(kCorner, kOther),
     ContactState::on_first_line},
    {"vertex-edge to second line", vertex_edge(kOther, ContactState::sliding), vertex_vertex(kCorner, kOther),
     ContactState::on_second_line},
    {"vertex-vertex: first line stays", vertex_vertex(kCorner, kNowhere, ContactState::on_first_line),
     vertex_vertex(kCorner, kOther), ContactState::on_first_line},
    {"vertex-vertex: second line stays", vertex_vertex(kNowhere, kOther, ContactState::on_second_line),
     vertex_vertex(kCorner, kOther), ContactState::on_second_line},
    {"vertex-vertex: lines exchanged", vertex_vertex(kOther, kCorner, ContactState::on_first_line),
     vertex_vertex(kCorner, kOther), ContactState::on_second_line},
    {"vertex-vertex: second line to first", vertex_vertex(kNowhere, kCorner, ContactState::on_second_line),
     vertex_vertex(kCorner, kOther), ContactState::on_first_line},
    {"the line that was not active hands on nothing", vertex_vertex(kCorner, kNowhere, ContactState::on_second_line),
     vertex_vertex(kCorner, kOther), ContactState::open},
    {"nor does the second where the first was active", vertex_vertex(kNowhere, kOther, ContactState::on_first_line),
     vertex_vertex(kCorner, kOther), ContactState::open},
    {"vertex-vertex to vertex-edge locks", vertex_vertex(kCorner, kOther, ContactState::on_first_line),
     vertex_edge(kCorner), ContactState::locked},
    {"whichever line was active", vertex_vertex(kCorner, kOther, ContactState::on_second_line), vertex_edge(kCorner),
     ContactState::locked},
    {"and whichever triple it was", vertex_vertex(kOther, kCorner, ContactState::on_first_line), vertex_edge(kCorner),
     ContactState::locked},
    {"an open vertex-vertex contact locks nothing", vertex_vertex(kCorner, kOther), vertex_edge(kCorner),
     ContactState::open},
};

}  // namespace

TEST(Carry, a_new_contact_takes_the_state_that_the_table_gives) {
  for (const Row& row : kTable) EXPECT_EQ(Base().carried({row.fresh}, {row.old})[0].state, row.expected) << row.what;
}

TEST(Carry, the_last_match_wins) {
  Contact sliding = vertex_edge(kCorner, ContactState::sliding);
  sliding.distance = -1;
  Contact locked = vertex_edge(kCorner, ContactState::locked);
  locked.distance = -2;
  const Base base;
  const Contact last_locked = base.carried({vertex_edge(kCorner)}, {sliding, locked})[0];
  EXPECT_EQ(last_locked.state, ContactState::locked);
  EXPECT_EQ(last_locked.distance, -2);
  const Contact last_sliding = base.carried({vertex_edge(kCorner)}, {locked, sliding})[0];
  EXPECT_EQ(last_sliding.state, ContactState::sliding);
  EXPECT_EQ(last_sliding.distance, -1);
}

TEST(Carry, an_open_contact_hands_on_nothing) {
  Contact old = vertex_edge(kCorner);
  old.distance = -1;
  old.slip = 2;
  old.ratio = 0.123;
  old.bonded = true;
  const Contact fresh = Base().carried({vertex_edge(kCorner)}, {old})[0];
  EXPECT_TRUE(fresh.is_open());
  EXPECT_FALSE(fresh.bonded);
  EXPECT_EQ(fresh.distance, 0);
  EXPECT_EQ(fresh.slip, 0);
  EXPECT_NEAR(fresh.ratio, 0.4, 1e-9) << "projected anew: 2 of 5";
}

TEST(Carry, distance_slip_and_penalty_go_with_the_state) {
  Contact old = vertex_edge(kCorner, ContactState::sliding);
  old.distance = -1;
  old.slip = 2;
  old.penalty = 3;
  const Contact fresh = Base().carried({vertex_edge(kCorner)}, {old})[0];
  EXPECT_EQ(fresh.distance, -1);
  EXPECT_EQ(fresh.slip, 2);
  EXPECT_EQ(fresh.penalty, 3);
}

// Legacy-rules 5: the ratio is kept from first triple to first triple of a locked contact only.
TEST(Carry, a_locked_contact_whose_triples_were_exchanged_is_projected_anew) {
  Contact old = parallel_pair(kOther, kCorner, ContactState::locked);
  old.ratio = 0.123;
  const Contact exchanged = Base().carried({parallel_pair(kCorner, kOther)}, {old})[0];
  EXPECT_EQ(exchanged.state, ContactState::locked);
  EXPECT_NEAR(exchanged.ratio, 0.4, 1e-9);
  const Contact same = Base().carried({parallel_pair(kOther, kCorner)}, {old})[0];
  EXPECT_EQ(same.ratio, 0.123);
}

// Two corners of one side of the square, both of parallel pairs: the other end of the second contact is vertex 4, half
// of 1 overlaps. The Berkeley program takes vertex 6 instead, because the contact before ended in 5: nothing overlaps.
TEST(Carry, contact_length_mistakes_the_shared_edge_after_a_repeated_vertex_under_the_quirk) {
  const Contacts fresh{parallel_pair(kCorner, {{2}, {5}, {4}}), parallel_pair(kElsewhere, {{3}, {4}, {6}})};
  Base base;
  const Contacts with = base.carried(fresh, {});
  EXPECT_NEAR(with[0].length, 0.5, 1e-9);
  EXPECT_NEAR(with[1].length, 0, 1e-9);
  base.quirks.contact_length_last_vertex = false;
  const Contacts without = base.carried(fresh, {});
  EXPECT_NEAR(without[0].length, 0.5, 1e-9);
  EXPECT_NEAR(without[1].length, 0.5, 1e-9);
}

TEST(Carry, without_an_edge_along_the_line_there_is_no_length) {
  EXPECT_EQ(Base().carried({vertex_edge(kCorner)}, {})[0].length, 0);
  Contact with_neighbour = vertex_edge(kCorner);
  with_neighbour.neighbour = {5};
  EXPECT_NEAR(Base().carried({with_neighbour}, {})[0].length, 0.5, 1e-9);
}

// Legacy-rules 6: open if either distance is beyond s0 d0, else on the line with the greater one.
TEST(Carry, a_vertex_vertex_contact_starts_on_the_line_it_is_less_deep_in_unless_it_is_away_from_one) {
  Base base;
  const Contact corner = vertex_vertex({{4}, {3}, {2}}, {{4}, {2}, {1}});  // top and right side of the base
  const double near = 0.5 * base.scene.rules.start_distance;
  const auto started = [&](double above, double beside) {
    base.state.vertices[VertexIndex{4}] = {3 + beside, above};
    return start_closed({corner}, base.state, base.scene.rules)[0].state;
  };
  EXPECT_EQ(started(near / 2, -near), ContactState::on_first_line);
  EXPECT_EQ(started(-near, near / 2), ContactState::on_second_line);
  EXPECT_EQ(started(near, 4 * near), ContactState::open);
  EXPECT_EQ(started(4 * near, near), ContactState::open);
}

}  // namespace keyblock::carry_test
