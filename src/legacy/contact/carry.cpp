// Transfers states by identical triples, sets contact ratio and length, and chooses the states of the first step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/contact/carry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "legacy/contact/line.hpp"

namespace keyblock {
namespace {

// Added (times w0) to a squared line length before a division by it, as in the Berkeley program (legacy-rules 5).
constexpr double kLengthGuard = 1e-9;

// Data that a new contact takes from old ones with the same triples; the last match wins (legacy-rules 4).
struct Memory {
  ContactState by_first = ContactState::open;
  ContactState by_second = ContactState::open;
  bool keeps_ratio = false;
};

// Place of a triple in the list of new contacts.
struct Slot {
  std::size_t contact;
  bool is_second;
};

// Finds triples by their vertices; those of one vertex keep the order of the contacts.
class Slots {
 public:
  Slots(const Contacts& contacts, std::size_t vertex_count) : begins_(vertex_count + 1, 0) {
    const auto each = [&](const auto& work) {
      for (std::size_t i = 0; i < contacts.size(); ++i) {
        work(contacts[i].first, Slot{i, false});
        if (contacts[i].has_second()) work(contacts[i].second, Slot{i, true});
      }
    };
    each([&](const Triple& triple, Slot) { ++begins_[at(triple) + 1]; });
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    named_.resize(begins_.back());
    std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
    each([&](const Triple& triple, Slot slot) { named_[next[at(triple)]++] = {triple, slot}; });
  }

  template <class Work>
  void for_each(const Triple& triple, const Work& work) const {
    for (std::size_t k = begins_[at(triple)]; k < begins_[at(triple) + 1]; ++k) {
      const Triple& other = named_[k].triple;
      if (other.start == triple.start && other.end == triple.end) work(named_[k].slot);
    }
  }

 private:
  struct Named {
    Triple triple;
    Slot slot;
  };
  static std::size_t at(const Triple& triple) { return static_cast<std::size_t>(triple.vertex.value); }

  std::vector<std::size_t> begins_;
  std::vector<Named> named_;
};

// Returns the state that an old contact passes on through one of its triples: 0 (open) if that triple was not active.
ContactState state_through_first(const Contact& old) {
  return old.state == ContactState::on_second_line ? ContactState::open : old.state;
}
ContactState state_through_second(const Contact& old) {
  return old.state == ContactState::on_second_line ? ContactState::on_second_line : ContactState::open;
}

// Translates an old state for a vertex-edge contact. Lines 1 and 3 of a vertex-vertex contact mean nothing there but
// their number, 1 (sliding). A vertex-vertex contact passes only `locked` to a first triple.
ContactState as_vertex_edge(ContactState state) {
  const bool on_line = state == ContactState::on_first_line || state == ContactState::on_second_line;
  return on_line ? ContactState::sliding : state;
}

void hand_on(const Contact& old, const Slot& slot, bool from_second, Contacts& contacts,
             std::vector<Memory>& memories) {
  Contact& contact = contacts[slot.contact];
  Memory& memory = memories[slot.contact];
  contact.distance = old.distance;
  contact.slip = old.slip;
  contact.ratio = old.ratio;
  contact.penalty = old.penalty;
  contact.bonded = old.bonded && old.state == ContactState::locked;
  if (!slot.is_second) memory.keeps_ratio = !from_second && old.state == ContactState::locked;
  const ContactState state = from_second ? state_through_second(old) : state_through_first(old);
  if (contact.kind == ContactKind::vertex_edge && old.kind == ContactKind::vertex_vertex)
    memory.by_first = ContactState::locked;
  else if (slot.is_second)
    memory.by_second = state;
  else
    memory.by_first = state;
}

void settle_state(Contact& contact, const Memory& memory) {
  const bool second = memory.by_second != ContactState::open;
  if (contact.kind == ContactKind::vertex_edge)
    contact.state = as_vertex_edge(second ? memory.by_second : memory.by_first);
  else if (second)
    contact.state = ContactState::on_second_line;
  else if (memory.by_first != ContactState::open)
    contact.state = ContactState::on_first_line;
}

double guarded_square(const Line& line, const ContactRules& rules) {
  return dot(line.along(), line.along()) + kLengthGuard * rules.scale;
}

double guarded_projection(Point p, const Line& line, const ContactRules& rules) {
  return dot(p - line.p2, line.along()) / guarded_square(line, rules);
}

// Returns the other end of the edge along the reference line. The Berkeley program takes the last vertex of the second
// triple if that of the contact before equals P1 (legacy-rules 5, Q).
VertexIndex shared_edge_end(const Contact& contact, VertexIndex previous_end, const BerkeleyQuirks& quirks) {
  if (!contact.parallel_pair) return contact.neighbour;
  const bool mistaken = quirks.contact_length_last_vertex && previous_end && previous_end == contact.first.vertex;
  return mistaken ? contact.second.end : contact.second.start;
}

// Returns half the length over which the edge ending in P1 and the line overlap.
double contact_length(const Line& line, Point other_end, const ContactRules& rules) {
  std::array<double, 4> s{guarded_projection(line.p1, line, rules), 0, 1, guarded_projection(other_end, line, rules)};
  std::ranges::sort(s);
  return (s[2] - s[1]) * std::sqrt(guarded_square(line, rules)) / 2;
}

void set_ratios_and_lengths(Contacts& contacts, const std::vector<Memory>& memories, const State& state,
                            const ContactRules& rules, const BerkeleyQuirks& quirks) {
  VertexIndex previous_end;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    Contact& contact = contacts[i];
    if (contact.kind == ContactKind::vertex_vertex) continue;
    const Line line = line_of(state, contact.first);
    if (!memories[i].keeps_ratio) contact.ratio = guarded_projection(line.p1, line, rules);
    const VertexIndex end = shared_edge_end(contact, previous_end, quirks);
    contact.length = end ? contact_length(line, state.vertices[end], rules) : 0;
    previous_end = end;
  }
}

}  // namespace

Contacts carry(Contacts contacts, const Contacts& previous, const State& state, const ContactRules& rules,
               const BerkeleyQuirks& quirks) {
  std::vector<Memory> memories(contacts.size());
  const Slots slots(contacts, state.vertices.size());
  for (const Contact& old : previous) {
    if (old.is_open()) continue;
    slots.for_each(old.first, [&](const Slot& slot) { hand_on(old, slot, false, contacts, memories); });
    if (old.has_second())
      slots.for_each(old.second, [&](const Slot& slot) { hand_on(old, slot, true, contacts, memories); });
  }
  for (std::size_t i = 0; i < contacts.size(); ++i) settle_state(contacts[i], memories[i]);
  set_ratios_and_lengths(contacts, memories, state, rules, quirks);
  return contacts;
}

Contacts start_closed(Contacts contacts, const State& state, const ContactRules& rules) {
  contacts = start_open(std::move(contacts));
  for (Contact& contact : contacts) {
    const double first = line_of(state, contact.first).distance();
    if (contact.kind == ContactKind::vertex_edge) {
      if (first <= rules.start_distance) contact.state = ContactState::locked;
      continue;
    }
    const double second = line_of(state, contact.second).distance();
    if (first > rules.start_distance || second > rules.start_distance) continue;
    contact.state = first < second ? ContactState::on_second_line : ContactState::on_first_line;
  }
  return contacts;
}

Contacts start_open(Contacts contacts) {
  for (Contact& contact : contacts) contact.bonded = contact.parallel_pair || static_cast<bool>(contact.neighbour);
  return contacts;
}

}  // namespace keyblock
