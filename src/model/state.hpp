// What changes during a run: time, positions, velocities and stresses.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/simplex.hpp"
#include "model/model.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// What an element carries. Moments are those of the current polygon about its centroid.
struct ElementState {
  Point centroid;
  Moments moments;
  Unknowns velocity;   ///< rate of the unknowns that the next attempt starts from (see velocity_from_coming_step)
  Unknowns last_step;  ///< the last accepted increment of the unknowns
  Stress stress;
  double rotation = 0;  ///< sum of the step rotations, rad
  Velocity carried{};   ///< of the centroid, where the element has no unknowns of its own
};

/// A cover that elements share: its unknowns are the displacement of its node.
struct NodeState {
  Point position;
  Point velocity;   ///< as `ElementState::velocity`
  Point last_step;  ///< as `ElementState::last_step`
};

/// A carried point now, and how far it has come.
struct PointState {
  Point position;
  Point displacement;
};

/// The ends of a bolt as they lie now, and the force it carries, tension positive.
struct BoltState {
  Point first;
  Point second;
  double force = 0;
  bool is_broken = false;
};

struct State {
  int step = 0;
  double time = 0;
  double dt = 0;  ///< of the last accepted step
  Table<VertexIndex, Point> vertices;
  Table<ElementIndex, ElementState> elements;
  std::vector<NodeState> nodes;  ///< of the covers that elements share
  std::vector<PointState> fixed_points;
  std::vector<PointState> loading_points;
  std::vector<PointState> measured_points;
  std::vector<BoltState> bolts;
};

/// Displacement operator of `element` at the point `x` of the plane.
DisplacementOperator basis_at(const Model& model, const State& state, ElementIndex element, Point x);

/// Centroid and moments of an element's polygon as its vertices lie now.
struct Placement {
  Point centroid;
  Moments moments;  ///< about the centroid
};
Placement place(const Model& model, const Table<VertexIndex, Point>& vertices, ElementIndex element,
                const Settings& settings);

/// Where everything lay before any load: displacements are counted from there.
struct StartPlaces {
  Table<VertexIndex, Point> vertices;
  Table<ElementIndex, Placement> elements;
};
StartPlaces places_of(const State& state);

/// The first element that is turned inside out, or has a number that is not finite; none where all can be.
std::optional<ElementIndex> impossible(const State& state);

/// Velocity of the unknowns at the end of the last accepted step; zero where its block material carries none (static).
Unknowns end_velocity(const ElementState& element, const State& state, const Settings& settings, int material);

}  // namespace keyblock
