// Turns the faces of an arrangement of lines into blocks, and into the graph of bodies with their slits.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cut/bodies/body_graph.hpp"
#include "cut/bodies/cut_notes.hpp"
#include "cut/lines/faces.hpp"

namespace keyblock {

/// Appends one block per face to `result.blocks`, in the order of the faces. Keeps references to its arguments.
class BlocksOfFaces {
 public:
  BlocksOfFaces(const Arrangement& arrangement, const std::vector<Face>& faces, const UsedLines& lines, CutNotes& notes,
                CutResult& result)
      : arrangement_(arrangement), faces_(faces), lines_(lines), notes_(notes), result_(result) {}

  void make();

  /// Returns the outlines of the bodies and their slits. `kept`: number of each block before the holes were removed.
  BodyGraph graph(const std::vector<int>& kept, const std::vector<Edge>& slits) const;

  /// Returns the joint of the edge that arrives at each corner, index from 0; outer loop before holes. `block` counts
  /// the blocks before the holes were removed.
  const std::vector<int>& lines_of_block(int block) const { return lines_of_block_[static_cast<std::size_t>(block)]; }

 private:
  int material(int line) const { return lines_.sources[line]->joint_material; }
  void add(const Face& face, int number_of_face);
  BlockLoop loop_of(const Chain& chain, std::vector<int>& lines) const;
  bool is_straight(const ChainLink& before, const ChainLink& here, const ChainLink& after) const;

  const Arrangement& arrangement_;
  const std::vector<Face>& faces_;
  const UsedLines& lines_;
  CutNotes& notes_;
  CutResult& result_;
  std::vector<int> face_of_block_;                // per block, before holes are removed
  std::vector<std::vector<int>> lines_of_block_;  // per block, before holes are removed
};

}  // namespace keyblock
