// Holds the quantities that change during a run: time, positions, velocities and stresses.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/simplex.hpp"
#include "model/model.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// State of an element. Moments are those of the current polygon about its centroid.
struct ElementState {
  Point centroid;
  Moments moments;
  Unknowns velocity;   ///< rate of the unknowns from which the next attempt starts (see velocity_from_coming_step)
  Unknowns last_step;  ///< the last accepted increment of the unknowns
  Stress stress;
  double rotation = 0;  ///< sum of the step rotations [rad]
  Velocity carried{};   ///< of the centroid, if the element has no unknowns of its own
};

/// State of a cover shared by elements: its unknowns are the displacement of its node.
struct NodeState {
  Point position;
  Point velocity;   ///< as `ElementState::velocity`
  Point last_step;  ///< as `ElementState::last_step`
};

/// Present position and displacement of a carried point.
struct PointState {
  Point position;
  Point displacement;
};

/// Present ends of a bolt, and its force, tension positive.
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

/// Returns the displacement operator of `element` at the point `x` of the plane.
DisplacementOperator basis_at(const Model& model, const State& state, ElementIndex element, Point x);

/// Centroid and moments of an element's polygon for its present vertices.
struct Placement {
  Point centroid;
  Moments moments;  ///< about the centroid
};
Placement place(const Model& model, const Table<VertexIndex, Point>& vertices, ElementIndex element,
                const Settings& settings);

/// Positions before any load, from which displacements are counted.
struct StartPlaces {
  Table<VertexIndex, Point> vertices;
  Table<ElementIndex, Placement> elements;
};
StartPlaces places_of(const State& state);

/// Returns the first element that is inverted or has a non-finite number, or nothing if all are possible.
std::optional<ElementIndex> impossible(const State& state);

/// Returns the velocity of the unknowns at the end of the last accepted step; zero if the block material carries none
/// (static).
Unknowns end_velocity(const ElementState& element, const State& state, const Settings& settings, int material);

}  // namespace keyblock
