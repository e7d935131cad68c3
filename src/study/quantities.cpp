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
  return owner == Owner::block ? block_quantities().contains(name) : scene_quantities().contains(name);
}

double quantity_of(const Frame& frame, const std::string& name, std::optional<int> number) {
  if (!number) return scene_quantities().at(name)(frame);
  return block_quantities().at(name)(frame.elements[static_cast<std::size_t>(*number - 1)]);
}

}  // namespace keyblock::study
