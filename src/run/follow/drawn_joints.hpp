// Records the joint of the drawing along which each edge of a block was cut.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unordered_map>
#include <vector>

#include "geometry/point.hpp"
#include "model/model.hpp"
#include "result/contact_frame.hpp"

namespace keyblock {

/// Joints of blocks cut from a drawing for the first scene, as long as the edge exists. Faces made by a stage and NMM
/// bodies have none.
class DrawnJoints {
 public:
  DrawnJoints() = default;

  /// Takes `lines`, the joint of the edge that arrives at each vertex of the first scene's model. If their number
  /// differs, they belong to another model, and no joint is known.
  DrawnJoints(const Model& first, const std::vector<int>& lines);

  bool are_known() const { return !edges_.empty(); }
  bool has(int line) const;

  /// Sets the joint of each contact from its edge. `model`: of the current scene.
  void name(ContactFrames& contacts, const Model& model) const;

 private:
  struct Edge {
    Point end;  ///< as drawn
    int line = -1;
  };

  std::unordered_map<int, std::vector<Edge>> edges_;  ///< per element, by number
};

}  // namespace keyblock
