// The contact stiffness adapted from step to step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/step/penalty.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock::penalty_test {

// Legacy-rules 11.3: kn := max(kn w6/g3, kn/3), ten times that and a redo beyond 2.5 g3.
TEST(Penalty, grows_with_penetration_and_falls_slowly) {
  Settings settings;
  settings.penalty_control = PenaltyControl::adaptive;
  settings.allowed_displacement_ratio = 0.01;
  EXPECT_NEAR(adapt(100, {0, 2 * 4e-4}, 1, settings).penalty, 200, 1e-6);
  EXPECT_FALSE(adapt(100, {0, 2 * 4e-4}, 1, settings).redo);
  EXPECT_TRUE(adapt(100, {0, 3 * 4e-4}, 1, settings).redo);
  EXPECT_NEAR(adapt(100, {0, 3 * 4e-4}, 1, settings).penalty, 3000, 1e-5);
  EXPECT_NEAR(adapt(100, {0, 0}, 1, settings).penalty, 100.0 / 3, 1e-12);
  settings.penalty_control = PenaltyControl::constant;
  EXPECT_EQ(adapt(100, {0, 1}, 1, settings).penalty, 100);
}

TEST(Penalty, misfit_is_that_of_the_closed_contacts) {
  Contacts contacts(3);
  contacts[0].distance = -5;  // open: does not count
  contacts[1].state = ContactState::locked;
  contacts[1].distance = -2;
  contacts[2].state = ContactState::on_second_line;
  contacts[2].distance = 3;
  EXPECT_EQ(misfit(contacts).penetration, 2);
  EXPECT_EQ(misfit(contacts).opening, 3);
}

// A square of side 2 in one of side 4: √2 is the size of the smaller.
TEST(Penalty, penetration_counts_against_the_smaller_of_two_blocks) {
  Model model;
  State state;
  for (const double half : {1.0, 2.0}) {
    Element element;
    element.first_vertex = VertexIndex{static_cast<int>(model.vertices.size())};
    for (const Point corner : {Point{-half, -half}, Point{half, -half}, Point{half, half}, Point{-half, half}}) {
      Vertex vertex;
      vertex.element = ElementIndex{static_cast<int>(model.elements.size())};
      model.vertices.push_back(vertex);
      state.vertices.push_back(corner);
    }
    element.end_vertex = VertexIndex{static_cast<int>(model.vertices.size())};
    model.elements.push_back(element);
    state.elements.push_back({});
  }
  Contacts contacts(1);
  contacts[0].first = {VertexIndex{0}, VertexIndex{5}, VertexIndex{4}};
  contacts[0].distance = -0.1;
  EXPECT_EQ(penetration_share(contacts, model, state), 0);  // open
  contacts[0].state = ContactState::locked;
  EXPECT_DOUBLE_EQ(penetration_share(contacts, model, state), 0.1 / std::sqrt(2));
}

}  // namespace keyblock::penalty_test
