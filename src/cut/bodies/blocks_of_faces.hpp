// Faces of an arrangement of lines to blocks, and to the graph of bodies with their slits.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cut/bodies/cut_notes.hpp"
#include "cut/lines/faces.hpp"

namespace keyblock {

/// Blocks go into the result of the notes, in the order of their faces. Views what it is given.
class BlocksOfFaces {
 public:
  BlocksOfFaces(const Arrangement& arrangement, const std::vector<Face>& faces, const UsedLines& lines, CutNotes& notes,
                CutResult& result)
      : arrangement_(arrangement), faces_(faces), lines_(lines), notes_(notes), result_(result) {}

  void make();

  /// `kept`: of each block its number before the holes were removed.
  BodyGraph graph(const std::vector<int>& kept, const std::vector<Edge>& slits) const;

 private:
  int material(int line) const { return lines_.sources[line]->joint_material; }
  void add(const Face& face, int number_of_face);
  BlockLoop loop_of(const Chain& chain) const;
  bool is_straight(const ChainLink& before, const ChainLink& here, const ChainLink& after) const;

  const Arrangement& arrangement_;
  const std::vector<Face>& faces_;
  const UsedLines& lines_;
  CutNotes& notes_;
  CutResult& result_;
  std::vector<int> face_of_block_;  // before holes are removed
};

}  // namespace keyblock
