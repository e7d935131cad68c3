// Which joint of the drawing each edge of the blocks was cut along.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unordered_map>
#include <vector>

#include "geometry/point.hpp"
#include "model/model.hpp"
#include "result/contact_frame.hpp"

namespace keyblock {

/// Known of blocks that were cut from a drawing for the first scene, as long as they have that edge still: not of faces
/// that a stage makes, nor of bodies on covers.
class DrawnJoints {
 public:
  DrawnJoints() = default;

  /// `lines`: of the edge that arrives at each vertex of the model of the first scene; of another number they are not
  /// of that model, and none is known.
  DrawnJoints(const Model& first, const std::vector<int>& lines);

  bool are_known() const { return !edges_.empty(); }
  bool has(int line) const;

  /// Gives each contact the joint of its edge. `model`: of the scene at hand.
  void name(ContactFrames& contacts, const Model& model) const;

 private:
  struct Edge {
    Point end;  ///< as drawn
    int line = -1;
  };

  std::unordered_map<int, std::vector<Edge>> edges_;  ///< of each element, by number
};

}  // namespace keyblock
