// The table of quantities.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/quantities.hpp"

#include <cmath>
#include <map>

namespace keyblock::study {
namespace {

using OfBlock = double (*)(const ElementFrame&);
using OfScene = double (*)(const Frame&);

const std::map<std::string, OfBlock>& block_quantities() {
  static const std::map<std::string, OfBlock> table{
      {"displacement", [](const ElementFrame& e) { return length(e.displacement); }},
      {"dx", [](const ElementFrame& e) { return e.displacement.x; }},
      {"dy", [](const ElementFrame& e) { return e.displacement.y; }},
      {"cx", [](const ElementFrame& e) { return e.centroid.x; }},
      {"cy", [](const ElementFrame& e) { return e.centroid.y; }},
      {"rotation", [](const ElementFrame& e) { return e.rotation; }},
      {"sxx", [](const ElementFrame& e) { return e.stress.xx; }},
      {"syy", [](const ElementFrame& e) { return e.stress.yy; }},
      {"sxy", [](const ElementFrame& e) { return e.stress.xy; }},
      {"area", [](const ElementFrame& e) { return e.area; }},
      {"speed", [](const ElementFrame& e) { return std::hypot(e.velocity.x, e.velocity.y); }},
      {"vx", [](const ElementFrame& e) { return e.velocity.x; }},
      {"vy", [](const ElementFrame& e) { return e.velocity.y; }},
      {"spin", [](const ElementFrame& e) { return e.velocity.rotation; }},
  };
  return table;
}

using OfBlockSince = double (*)(const ElementFrame& now, const ElementFrame& first);

const std::map<std::string, OfBlockSince>& block_quantities_since() {
  static const std::map<std::string, OfBlockSince> table{
      {"travel", [](const ElementFrame& now,
                    const ElementFrame& first) { return length(now.displacement - first.displacement); }},
  };
  return table;
}

double total_area(const Frame& frame) {
  double area = 0;
  for (const ElementFrame& e : frame.elements) area += e.area;
  return area;
}

const std::map<std::string, OfScene>& scene_quantities() {
  static const std::map<std::string, OfScene> table{
      {"total_area", total_area},
      {"block_count", [](const Frame& f) { return static_cast<double>(f.elements.size()); }},
      {"fixed_point_count", [](const Frame& f) { return static_cast<double>(f.fixed_points.size()); }},
  };
  return table;
}

}  // namespace

bool is_quantity(const std::string& name, Owner owner) {
  if (owner == Owner::scene) return scene_quantities().contains(name);
  return block_quantities().contains(name) || block_quantities_since().contains(name);
}

double quantity_of(const Frame& frame, const Frame& first, const std::string& name, std::optional<int> number) {
  if (!number) return scene_quantities().at(name)(frame);
  const auto block = static_cast<std::size_t>(*number - 1);
  const auto since = block_quantities_since().find(name);
  if (since != block_quantities_since().end()) return since->second(frame.elements[block], first.elements[block]);
  return block_quantities().at(name)(frame.elements[block]);
}

}  // namespace keyblock::study
