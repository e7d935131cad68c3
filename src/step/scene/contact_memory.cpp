// Sorts contacts once and finds them by vertex, either by contact name or by facing edges.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene/contact_memory.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace keyblock {
namespace {

// Keeps the last of equal entries. `entries` are sorted, equal ones in their original order.
template <class Entry, class Equal>
void keep_last(std::vector<Entry>& entries, const Equal& equal) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (i + 1 < entries.size() && equal(entries[i], entries[i + 1])) continue;
    if (kept != i) entries[kept] = std::move(entries[i]);
    ++kept;
  }
  entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(kept), entries.end());
}

// Sorts by contact, equal ones in their original order. Contacts are large, so that their places are sorted first.
std::vector<ClosedContact> sorted(const std::vector<ClosedContact>& contacts) {
  std::vector<std::uint32_t> places(contacts.size());
  std::iota(places.begin(), places.end(), 0U);
  std::ranges::stable_sort(places, {}, [&](std::uint32_t i) { return contacts[i].touch.name(); });
  std::vector<ClosedContact> all;
  all.reserve(contacts.size());
  for (const std::uint32_t i : places) all.push_back(contacts[i]);
  return all;
}

// Returns the first entry of each vertex in a sorted list, and the end after the last one.
template <class Entry, class VertexOf>
std::vector<std::uint32_t> first_by_vertex(const std::vector<Entry>& entries, const VertexOf& vertex_of) {
  std::vector<std::uint32_t> first;
  if (entries.empty()) return first;
  first.assign(static_cast<std::size_t>(vertex_of(entries.back()).value) + 2, 0);
  for (const Entry& entry : entries) ++first[static_cast<std::size_t>(vertex_of(entry).value) + 1];
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  return first;
}

// Returns the range of entries of one vertex.
std::pair<std::uint32_t, std::uint32_t> places(const std::vector<std::uint32_t>& first, VertexIndex vertex) {
  const auto v = static_cast<std::size_t>(vertex.value);
  return v + 1 < first.size() ? std::pair{first[v], first[v + 1]} : std::pair{0U, 0U};
}

}  // namespace

ClosedContacts::ClosedContacts(std::vector<ClosedContact> contacts) {
  by_touch_ = sorted(contacts);
  keep_last(by_touch_, [](const ClosedContact& a, const ClosedContact& b) { return a.touch == b.touch; });
  by_touch_.shrink_to_fit();
  for (std::uint32_t i = 0; i < by_touch_.size(); ++i)
    if (by_touch_[i].touch.facing.lower) by_facing_.push_back(i);
  const auto facing = [&](std::uint32_t i) { return by_touch_[i].touch.facing; };
  std::ranges::stable_sort(by_facing_, {}, facing);
  keep_last(by_facing_, [&](std::uint32_t a, std::uint32_t b) { return facing(a) == facing(b); });
  by_facing_.shrink_to_fit();
  first_of_vertex_ = first_by_vertex(by_touch_, [](const ClosedContact& c) { return c.touch.vertex; });
  first_of_facing_ = first_by_vertex(by_facing_, [&](std::uint32_t i) { return facing(i).lower; });
}

const ContactMemory* ClosedContacts::of(const Touch& touch) const {
  for (auto [i, end] = places(first_of_vertex_, touch.vertex); i < end; ++i)
    if (by_touch_[i].touch == touch) return &by_touch_[i].memory;
  for (const VertexIndex v : {touch.vertex, touch.start, touch.end})
    for (const ClosedContact& contact : at(v))
      if (is_guided(contact.touch, touch) || is_guided(touch, contact.touch)) return &contact.memory;
  if (!touch.facing.lower) return nullptr;
  for (auto [i, end] = places(first_of_facing_, touch.facing.lower); i < end; ++i)
    if (by_touch_[by_facing_[i]].touch.facing == touch.facing) return &by_touch_[by_facing_[i]].memory;
  return nullptr;
}

std::span<const ClosedContact> ClosedContacts::at(VertexIndex vertex) const {
  const auto [first, end] = places(first_of_vertex_, vertex);
  return std::span(by_touch_).subspan(first, end - first);
}

ConstraintMemory constraint_start(const std::vector<Bolt>& bolts, std::size_t points) {
  ConstraintMemory memory;
  for (const Bolt& bolt : bolts) {
    memory.bolt_forces.push_back(bolt.is_spring() ? bolt.pretension : bolt.constant_force());
    memory.broken.push_back(!bolt.is_spring() && bolt.pretension >= bolt.strength);
  }
  memory.point_forces = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(points));
  return memory;
}

}  // namespace keyblock
