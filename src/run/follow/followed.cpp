// Checks the histories of a case, names them, and warns of those that say nothing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/follow/followed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "base/counted.hpp"
#include "base/printable.hpp"
#include "base/sentences/sentences.hpp"
#include "base/words/plain_number.hpp"
#include "geometry/box.hpp"
#include "geometry/segment.hpp"
#include "model/continuum.hpp"
#include "run/follow/resultant.hpp"

namespace keyblock {
namespace {

std::string word_of(const HistoryPlan& plan) {
  if (plan.point) return "point";
  if (plan.block) return "block";
  if (plan.contact) return "contact";
  if (plan.bolt) return "bolt";
  return plan.joint ? "joint" : "line";
}

/// A row must stay on one line, because the table grows line by line.
std::string row_cell(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return csv_cell(text);
}

std::optional<ElementIndex> element_numbered(const Model& model, int number) {
  for (const ElementIndex e : indices(model.elements))
    if (model.identities.of_element(e.value).number == number) return e;
  return std::nullopt;
}

/// Numbers of measured points by their initial place; the last one at a place counts. Points of histories come after
/// those of the files.
using PointsByPlace = std::map<std::pair<double, double>, int>;

PointsByPlace points_by_place(const Model& model) {
  PointsByPlace points;
  for (std::size_t i = 0; i < model.measured_points.size(); ++i) {
    const Point start = model.measured_points[i].start;
    points[{start.x, start.y}] = model.identities.of_measured_point(i);
  }
  return points;
}

int point_at(const PointsByPlace& points, const HistoryPlan& plan) {
  const auto found = points.find({plan.point->x, plan.point->y});
  if (found != points.end()) return found->second;
  throw InputError(plan.place, fmt::format("expected the point of a history within a block, found {}, {} in none",
                                           plain(plan.point->x, 6), plain(plan.point->y, 6)));
}

/// Later scenes count too, because stages may cut blocks.
void require_block(const Scene& first, int number, const HistoryPlan& plan) {
  int count = 0;
  for (const Scene* scene : scenes_of(first))
    for (std::size_t e = 0; e < scene->model.elements.size(); ++e)
      count = std::max(count, scene->model.identities.of_element(static_cast<int>(e)).number + 1);
  if (number < count) return;
  throw InputError(plan.place, fmt::format("expected the number of a block in a history, 1 to {}, found {}", count,
                                           static_cast<long long>(number) + 1));
}

void require_joint(const DrawnJoints& joints, int line, const HistoryPlan& plan) {
  if (joints.has(line)) return;
  throw InputError(
      plan.place,
      joints.are_known()
          ? fmt::format("expected the number of a joint of the drawing that made an edge of a block, found {}",
                        static_cast<long long>(line) + 1)
          : "expected blocks cut from a drawing, whose joints a history can follow, found none");
}

void require_line(const Scene& first, const Segment& line, const HistoryPlan& plan) {
  if (!first.model.continuum || body_across(line, first.model.continuum->manifold) < 0) return;
  throw InputError(plan.place,
                   "expected a line between bodies, whose contacts and bolts a resultant sums, found one through an "
                   "NMM body; its stress acts there");
}

/// Later scenes count too, because a stage may install the bolt.
void require_bolt(const Scene& first, int number, const HistoryPlan& plan) {
  std::size_t most = 0;
  for (const Scene* scene : scenes_of(first))
    for (std::size_t i = 0; i < scene->model.bolts.size(); ++i) {
      const int own = scene->model.identities.of_bolt(i);
      if (own == number) return;
      most = std::max(most, static_cast<std::size_t>(own) + 1);
    }
  throw InputError(plan.place, most == 0 ? std::string("expected a bolt in a scene with a history of one, found none")
                                         : fmt::format("expected the number of a bolt in a history, 1 to {}, found {}",
                                                       most, static_cast<long long>(number) + 1));
}

/// Returns the name of the bolt in the case; empty if it has none.
std::string name_of_bolt(const Scene& first, int number) {
  for (const Scene* scene : scenes_of(first))
    for (std::size_t i = 0; i < scene->model.bolts.size(); ++i)
      if (scene->model.identities.of_bolt(i) == number) return scene->model.bolts[i].name;
  return {};
}

Point start_of(const Model& model, VertexIndex v) {
  return model.start_vertices[static_cast<std::size_t>(v.value)];
}

double distance_between(const Model& model, ElementIndex one, ElementIndex other) {
  double least = std::numeric_limits<double>::infinity();
  const auto add = [&](ElementIndex of_points, ElementIndex of_edges) {
    for (const VertexIndex v : model.elements[of_points].vertices())
      for (const VertexIndex w : model.elements[of_edges].vertices()) {
        const Segment edge{start_of(model, w), start_of(model, model.vertices[w].next)};
        least = std::min(least, distance(edge, start_of(model, v)));
      }
  };
  add(one, other);
  add(other, one);
  return least;
}

double size_of(const Model& model, ElementIndex e) {
  Box box;
  for (const VertexIndex v : model.elements[e].vertices()) box.add(start_of(model, v));
  return length(box.size());
}

std::vector<HistoryPlan> with_names_of_bolts(std::vector<HistoryPlan> plans, const Scene& first) {
  for (HistoryPlan& plan : plans)
    if (plan.bolt && plan.name.empty()) plan.name = name_of_bolt(first, *plan.bolt);
  return plans;
}

/// Tables and outputs tell histories apart by their names. Throws InputError if two items have one.
void require_same_item(HistoryPlan first, HistoryPlan second, const std::string& name) {
  first.name.clear();
  second.name.clear();
  if (first == second) return;
  throw InputError(second.place,
                   fmt::format("expected a name of its own for each history, found \"{}\" for two: {} {} and {} {}",
                               name, word_of(first), name_of(first), word_of(second), name_of(second)));
}

std::string what_bore_nothing(const HistoryPlan& plan) {
  if (plan.contact)
    return fmt::format("no contact of blocks {} and {} is closed", plan.contact->first + 1, plan.contact->second + 1);
  if (plan.joint) return fmt::format("no contact along joint {} of the drawing is closed", *plan.joint + 1);
  return "no closed contact and no bolt crosses the line";
}

Facts facts_of(const HistoryPlan& plan) {
  Facts facts;
  if (plan.contact) facts.elements = {plan.contact->first + 1, plan.contact->second + 1};
  if (plan.joint) facts.numbers.emplace_back("joint", *plan.joint + 1);
  if (plan.line) facts.points = {{plan.line->start.x, plan.line->start.y}, {plan.line->end.x, plan.line->end.y}};
  return facts;
}

}  // namespace

std::string name_of(const HistoryPlan& plan) {
  if (!plan.name.empty()) return plan.name;
  if (plan.point) return fmt::format("{:g} {:g}", plan.point->x, plan.point->y);
  if (plan.block) return fmt::format("{}", *plan.block + 1);
  if (plan.contact) return fmt::format("{}-{}", plan.contact->first + 1, plan.contact->second + 1);
  if (plan.joint) return fmt::format("{}", *plan.joint + 1);
  if (plan.bolt) return fmt::format("{}", *plan.bolt + 1);
  const auto& [start, end] = *plan.line;
  return fmt::format("{:g} {:g} to {:g} {:g}", start.x, start.y, end.x, end.y);
}

std::vector<HistoryPlan> with_names_apart(std::vector<HistoryPlan> plans) {
  for (std::size_t i = 0; i < plans.size(); ++i) {
    if (!plans[i].name.empty()) continue;
    const auto is_taken_by = [&, name = name_of(plans[i])](HistoryPlan other) {
      const bool has_name = name_of(other) == name;
      other.name.clear();
      return has_name && other != plans[i];
    };
    if (std::any_of(plans.begin(), plans.begin() + static_cast<std::ptrdiff_t>(i), is_taken_by))
      plans[i].name = word_of(plans[i]) + " " + name_of(plans[i]);
  }
  return plans;
}

void require_choice(const OutputPlan& plan) {
  const auto has_contacts = [](const HistoryPlan& h) { return h.block || h.contact || h.joint; };
  if (plan.contacts == ContactTables::chosen && std::ranges::none_of(plan.histories, has_contacts))
    throw InputError(plan.place, "expected a history of a block, a contact or a joint for chosen contacts, found none");
}

Followed::Followed(const std::vector<HistoryPlan>& plans, const Scene& first, const DrawnJoints& joints,
                   const Units& units)
    : units_(units) {
  const PointsByPlace points = points_by_place(first.model);
  std::map<std::string, std::size_t> by_name;
  for (const HistoryPlan& plan : with_names_apart(with_names_of_bolts(plans, first))) {
    One one{plan, name_of(plan)};
    if (one.name == kBalanceName)
      throw InputError(plan.place, fmt::format("expected another name of a history, found \"{}\", which names the "
                                               "energy balance",
                                               one.name));
    const auto [same, is_new] = by_name.try_emplace(one.name, all_.size());
    if (!is_new) {
      require_same_item(all_[same->second].plan, plan, one.name);
      continue;
    }
    if (plan.point) one.point = point_at(points, plan);
    if (plan.block) require_block(first, *plan.block, plan);
    if (plan.contact) require_block(first, std::max(plan.contact->first, plan.contact->second), plan);
    if (plan.contact) look_at_pair(one, first.model);
    if (plan.joint) require_joint(joints, *plan.joint, plan);
    if (plan.line) require_line(first, *plan.line, plan);
    if (plan.bolt) require_bolt(first, *plan.bolt, plan);
    all_.push_back(std::move(one));
  }
}

std::string history_lines(const std::vector<FollowedValue>& values, int step, double time) {
  std::string lines;
  for (const FollowedValue& one : values)
    lines += fmt::format("{},{},{},{},{},{},{}\n", step, time, one.what, row_cell(one.name), one.quantity, one.value,
                         one.unit);
  return lines;
}

std::vector<FollowedValue> Followed::values(const Stepper& stepper, const DrawnJoints& joints) {
  ContactFrames contacts;
  if (std::ranges::any_of(all_, [](const One& one) { return !one.plan.point && !one.plan.bolt; }))
    contacts = stepper.contacts();
  joints.name(contacts, stepper.model());
  const ItemsByNumber numbered(stepper.model());
  std::vector<FollowedValue> all;
  for (One& one : all_) {
    HistoryValues now =
        values_of({one.plan, one.point, word_of(one.plan), one.name}, stepper, numbered, contacts, units_);
    one.has_rows = true;
    one.has_borne = one.has_borne || now.bears;
    if (now.least_gap) one.nearest = one.nearest < 0 ? *now.least_gap : std::min(one.nearest, *now.least_gap);
    std::ranges::move(now.values, std::back_inserter(all));
  }
  return all;
}

double Followed::bytes_of_row() const {
  constexpr double kBytesOfLine = 60;  // step, time, quantity, value and unit
  double bytes = 0;
  for (const One& one : all_) {
    const HistoryPlan& plan = one.plan;
    const double lines = plan.point ? 7 : plan.block ? 11 : plan.bolt ? 3 : 8;
    bytes += lines * (kBytesOfLine + static_cast<double>(one.name.size()));
  }
  return bytes;
}

void Followed::look_at_pair(One& one, const Model& model) {
  const std::optional<ElementIndex> first = element_numbered(model, one.plan.contact->first);
  const std::optional<ElementIndex> second = element_numbered(model, one.plan.contact->second);
  if (!first || !second) return;
  one.apart = distance_between(model, *first, *second);
  one.is_distant = one.apart > std::min(size_of(model, *first), size_of(model, *second));
}

Warnings Followed::of_distant_pairs() const {
  Warnings warnings;
  for (const One& one : all_) {
    if (!one.is_distant) continue;
    const BlockPair& pair = *one.plan.contact;
    warnings.push_back(
        warning_of({"history_of_distant_blocks",
                    {{{"apart", one.apart}}, {{"history", one.name}}, {pair.first + 1, pair.second + 1}}},
                   one.plan.place));
  }
  return warnings;
}

Warnings Followed::of_nothing() const {
  Warnings warnings;
  for (const One& one : all_) {
    const HistoryPlan& plan = one.plan;
    if (one.has_borne || !one.has_rows || plan.point || plan.block || plan.bolt) continue;
    Facts facts = facts_of(plan);
    facts.texts = {{"history", word_of(plan) + " " + one.name}, {"bore", what_bore_nothing(plan)}};
    if (one.nearest >= 0)
      facts.numbers.emplace_back("least_gap", one.nearest);
    else if (one.apart >= 0)
      facts.numbers.emplace_back("apart", one.apart);
    warnings.push_back(warning_of({"history_of_nothing", std::move(facts)}, plan.place));
  }
  return warnings;
}

void Followed::describe(Archive& archive) {
  archive.table("followed", all_, [&](One& one) {
    archive.value("nearest", one.nearest);
    archive.value("has_borne", one.has_borne);
    archive.value("has_rows", one.has_rows);
  });
}

bool Followed::follows(const ContactFrame& contact) const {
  return std::ranges::any_of(all_, [&](const One& one) {
    const HistoryPlan& plan = one.plan;
    return (plan.block && (contact.element == *plan.block || contact.other == *plan.block)) ||
           (plan.contact && is_between(contact, *plan.contact)) || (plan.joint && contact.joint_line == *plan.joint);
  });
}

}  // namespace keyblock
