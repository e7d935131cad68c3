// Identifies an edge with that of the first scene that ends at the same place.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/follow/drawn_joints.hpp"

#include <algorithm>

namespace keyblock {

DrawnJoints::DrawnJoints(const Model& first, const std::vector<int>& lines) {
  if (lines.size() != first.vertices.size()) return;
  for (const ElementIndex e : indices(first.elements)) {
    std::vector<Edge>& edges = edges_[first.identities.of_element(e.value).number];
    for (const VertexIndex v : first.elements[e].vertices()) {
      const auto at = static_cast<std::size_t>(v.value);
      edges.push_back({first.start_vertices[at], lines[at]});
    }
  }
}

bool DrawnJoints::has(int line) const {
  return std::ranges::any_of(edges_, [&](const auto& element) {
    return std::ranges::any_of(element.second, [&](const Edge& edge) { return edge.line == line; });
  });
}

void DrawnJoints::name(ContactFrames& contacts, const Model& model) const {
  if (edges_.empty() || contacts.empty()) return;
  std::unordered_map<int, ElementIndex> now;
  for (const ElementIndex e : indices(model.elements)) now[model.identities.of_element(e.value).number] = e;
  for (ContactFrame& contact : contacts) {
    const auto known = edges_.find(contact.other);
    const auto element = now.find(contact.other);
    if (known == edges_.end() || element == now.end() || contact.edge < 0) continue;
    const auto edge = static_cast<std::size_t>(contact.edge);
    const std::size_t vertex = static_cast<std::size_t>(model.elements[element->second].first_vertex.value) + edge;
    if (edge < known->second.size() && known->second[edge].end == model.start_vertices[vertex])
      contact.joint_line = known->second[edge].line;
  }
}

}  // namespace keyblock
