// Holds one contact under Shi's rules: a vertex of one element against a reference line of another, and its last state.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "base/index.hpp"

namespace keyblock {

/// Vertex (P1) and the line from `start` (P2) to `end` (P3) that it may touch. The line runs against the order of its
/// loop, so that positive distance is outside.
struct Triple {
  VertexIndex vertex;
  VertexIndex start;
  VertexIndex end;

  bool operator==(const Triple&) const = default;
};

enum class ContactKind {
  vertex_edge,    ///< one reference line, `first`
  vertex_vertex,  ///< two reference lines; normal spring only
};

/// State of a contact: open, sliding or locked on its only line (vertex_edge), or on one of two lines (vertex_vertex).
enum class ContactState { open, sliding, locked, on_first_line, on_second_line };

struct Contact {
  ContactKind kind = ContactKind::vertex_edge;
  Triple first;
  Triple second;               ///< vertex_vertex; also the other half of a parallel pair of edges
  bool parallel_pair = false;  ///< vertex_edge made from two vertices with a nearly parallel pair of edges
  VertexIndex neighbour;       ///< vertex_edge: other end of an edge that lies along the line, if one does

  ContactState state = ContactState::open;
  ContactState state_before = ContactState::open;  ///< before the last judgement
  double distance = 0;                             ///< from the active line after the last solve, positive outside
  double slip = 0;                                 ///< along the line since the ratio was set
  double ratio = 0;                                ///< 0 … 1: place of the vertex on the line, from `start`
  double length = 0;                               ///< contact length for cohesion and tension
  double penalty = 0;                              ///< normal stiffness in use at the last judgement
  bool bonded = false;                             ///< cohesion and tension act
  double spring = 0;                               ///< in the last solve: `distance` from the line with the spring
  double friction = 0;  ///< in the last solve: force against sliding, with the sign of `slip`

  bool is_open() const { return state == ContactState::open; }
  bool has_second() const { return kind == ContactKind::vertex_vertex || parallel_pair; }
  const Triple& active() const { return state == ContactState::on_second_line ? second : first; }
};

using Contacts = std::vector<Contact>;

}  // namespace keyblock
