// Keeps pairs of vertices that are near each other, or near an edge of the other, and tests them again in later steps
// instead of a new search.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "contact/find/candidates.hpp"
#include "legacy/contact/rules.hpp"
#include "model/state.hpp"

namespace keyblock {

struct VertexPair {
  VertexIndex lower;  ///< of the element with the lower number
  VertexIndex upper;
};

/// Two elements with near vertices, in a list of pairs.
struct NearElements {
  ElementPair elements;
  std::size_t end = 0;  ///< of their pairs in the list, which begin where those of the elements before end
};

/// Pairs of near vertices: elements in ascending order, then the vertices of `lower`, then those of `upper`.
struct NearList {
  std::vector<NearElements> elements;
  std::vector<VertexPair> vertices;

  std::span<const VertexPair> of(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : elements[i - 1].end;
    return std::span(vertices).subspan(begin, elements[i].end - begin);
  }
};

/// List of all pairs within reach of a contact, and of more around them: it stays complete until vertices have moved
/// through that margin. Contacts do not depend on the margin or on the age of the list.
class NearVertices {
 public:
  /// Returns the list, made anew if it may have become incomplete.
  const NearList& of(const Model& model, const State& state, const ContactRules& rules);

 private:
  bool is_complete(const State& state) const;
  void search(const Model& model, const State& state, double distance);

  NearList list_;
  Table<VertexIndex, Point> places_;  ///< of the vertices at the last search
  double margin_ = 0;                 ///< of the last search, beyond the reach of a contact
  int uses_ = 0;                      ///< since the last search
};

}  // namespace keyblock
