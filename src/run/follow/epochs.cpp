// Compares bodies with those of the step before by a hash of their numbers, loops and undeformed corners.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/follow/epochs.hpp"

#include <boost/container_hash/hash.hpp>
#include <limits>

namespace keyblock {
namespace {

/// Above 0, and within the numbers that an archive holds.
std::size_t hash_of_bodies(const Model& model) {
  std::size_t hash = model.elements.size();
  for (const ElementIndex e : indices(model.elements)) {
    const Element& element = model.elements[e];
    boost::hash_combine(hash, model.identities.of_element(e.value).number);
    for (const int size : element.loop_sizes) boost::hash_combine(hash, size);
    for (const VertexIndex v : element.vertices()) {
      const Point corner = model.start_vertices[static_cast<std::size_t>(v.value)];
      boost::hash_combine(hash, corner.x);
      boost::hash_combine(hash, corner.y);
    }
  }
  constexpr std::size_t kMost = std::numeric_limits<std::ptrdiff_t>::max();
  return 1 + hash % kMost;
}

}  // namespace

int Epochs::at(const Model& model) {
  const std::size_t now = hash_of_bodies(model);
  if (bodies_ != 0 && now != bodies_) ++epoch_;
  bodies_ = now;
  return epoch_;
}

void Epochs::describe(Archive& archive) {
  archive.value("epoch", epoch_);
  archive.value("bodies", bodies_);
}

}  // namespace keyblock
