// Holds one reported instant of a run: the place and state of every element.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "geometry/point.hpp"
#include "problem/analysis.hpp"
#include "problem/rare.hpp"
#include "result/plastic_state.hpp"

namespace keyblock {

/// Element (a block) at an instant.
struct ElementFrame {
  std::vector<std::vector<Point>> loops;  ///< outer loop first (counter-clockwise), then holes (clockwise)
  int material = 0;                       ///< block material, index from 0
  Point centroid;
  Point displacement;   ///< of the centroid since the start
  double rotation = 0;  ///< rad, sum of the step rotations
  Velocity velocity;
  Stress stress;
  double area = 0;
  double mass = 0;               ///< density times the area at the start, per unit thickness
  double moment_of_inertia = 0;  ///< about the centroid, at the start
  int number = -1;               ///< of the element for the whole run, from 0; negative: its index in the frame
  int origin = -1;               ///< number of the element of the first scene that it is a piece of; negative: its own
  Rare<PlasticState> plastic = {};  ///< at the centroid; empty for rock that cannot yield
};

/// Point that moves with an element.
struct PointFrame {
  Point position;
  Point displacement;               ///< since the start
  int element = 0;                  ///< its number, from 0
  int number = -1;                  ///< of a measured point for the whole run, from 0; negative: its index in the frame
  Stress stress = {};               ///< of the element; on covers at the point
  Rare<PlasticState> plastic = {};  ///< as the stress; empty for rock that cannot yield
};

/// Returns true if the point existed at that instant; a point removed by a change of the scene has no position.
inline bool is_there(const PointFrame& point) {
  return !std::isnan(point.position.x);
}

/// Bolt between two elements.
struct BoltFrame {
  Point first;
  Point second;
  double force = 0;  ///< tension positive
  bool is_broken = false;
  int number = -1;        ///< of the bolt for the whole run, from 0; negative: its index in the frame
  std::string name = {};  ///< from a case file; empty: none
};

/// Stress intensity of a crack tip at the end of a step, and its direction of propagation.
struct TipState {
  int crack = 0;        ///< its number, from 0: those of the case file in their order, then joints that end inside
  bool at_end = false;  ///< the tip is the last point of the crack, else the first
  Point at;             ///< undeformed
  double length = 0;    ///< of the crack, all of its pieces
  double mode_1 = 0;    ///< K_I, F/L^1.5
  double mode_2 = 0;
  double energy_release = 0;  ///< J, F/L
  double equivalent = 0;      ///< K_eq of the criterion of growth, F/L^1.5
  double kink = 0;            ///< rad, from straight ahead to the left: direction of propagation
  double toughness = 0;       ///< K_Ic; 0: not given
  bool has_room = true;       ///< false: no domain around the tip is free of other lines, and there are no factors
  bool goes_on = false;
  bool is_shear = false;  ///< of a crack that started in shear

  bool operator==(const TipState&) const = default;
};

/// All elements and points at one time.
struct Frame {
  int step = 0;  ///< 0 is the state before the first step
  double time = 0;
  std::vector<ElementFrame> elements;
  std::vector<PointFrame> fixed_points;
  std::vector<PointFrame> loading_points;
  std::vector<PointFrame> measured_points;
  std::vector<BoltFrame> bolts;
  std::vector<std::vector<Point>> outlines = {};  ///< around bodies of many elements; empty if each element is a body
  std::vector<Point> reactions = {};              ///< force of each prescribed displacement on the bodies it supports
  std::optional<PlasticTotals> plastic = {};      ///< empty if no rock may yield
  std::vector<TipState> tips = {};                ///< of cracks of the case file, and of those that grow
  double load_factor = 1;  ///< by which growth multiplied all loads of the file, so that a tip is about to propagate
};

/// Returns the number of the element at an index of the frame for the whole run, and that of its origin.
int number_of(const Frame& frame, std::size_t index);
int origin_of(const Frame& frame, std::size_t index);

/// Returns the element of this number, or null if it is absent. It searches all if elements went or came.
const ElementFrame* element_of(const Frame& frame, int number);

/// Finds many elements by number. Keeps a reference to the frame.
class ElementsByNumber {
 public:
  explicit ElementsByNumber(const Frame& frame);
  const ElementFrame* find(int number) const;

 private:
  std::vector<const ElementFrame*> elements_;  ///< null if no element has that number
};

/// Returns the measured point of this number, or null if it is absent.
const PointFrame* measured_point_of(const Frame& frame, int number);

}  // namespace keyblock
