// Parses words into polygons; finds elements and edges by the place of their centroid or middle.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "api/strength_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "geometry/polygon.hpp"
#include "model/continuum.hpp"

namespace keyblock {
namespace {

constexpr std::array<const char*, 3> kReduced{"joints", "rock", "both"};

[[noreturn]] void refuse(const std::string& word) {
  throw std::invalid_argument(
      fmt::format("--exempt: expected material:N, joint_material:N, box:x1,y1,x2,y2 or polygon:x1,y1,x2,y2,x3,y3,…, "
                  "found \"{}\"",
                  word));
}

std::optional<double> number_of(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::vector<double> numbers_of(std::string_view list, const std::string& word) {
  std::vector<double> numbers;
  while (true) {
    const std::size_t comma = list.find(',');
    const std::optional<double> value = number_of(list.substr(0, comma));
    if (!value) refuse(word);
    numbers.push_back(*value);
    if (comma == std::string_view::npos) return numbers;
    list.remove_prefix(comma + 1);
  }
}

int material_of(const std::vector<double>& numbers, const std::string& word) {
  if (numbers.size() != 1 || numbers[0] < 1 || numbers[0] > 1e6 || numbers[0] != std::floor(numbers[0])) refuse(word);
  return static_cast<int>(numbers[0]) - 1;
}

std::vector<Point> box_of(const std::vector<double>& n, const std::string& word) {
  if (n.size() != 4 || n[0] == n[2] || n[1] == n[3]) refuse(word);
  return {{n[0], n[1]}, {n[2], n[1]}, {n[2], n[3]}, {n[0], n[3]}};
}

std::vector<Point> polygon_of(const std::vector<double>& n, const std::string& word) {
  if (n.size() < 6 || n.size() % 2 != 0) refuse(word);
  std::vector<Point> outline;
  for (std::size_t i = 0; i < n.size(); i += 2) outline.push_back({n[i], n[i + 1]});
  return outline;
}

bool holds(const Exempt& exempt, Point p) {
  return std::ranges::any_of(exempt.regions,
                             [&](const ExemptRegion& region) { return side(region.outline, p) != Side::outside; });
}

template <class T>
void copy_behind(PerMaterial<T>& choice, int count) {
  const std::map<int, T> own = choice.own;
  for (const auto& [material, value] : own)
    if (material < count) choice.own[material + count] = value;
}

// Elements of NMM bodies are the last ones of a model; the continuum has its own list of them.
void exempt_elements(Continuum& continuum, const std::vector<bool>& is_exempt, int materials) {
  std::vector<int> numbers;
  for (std::size_t e = 0; e < continuum.manifold.elements.size(); ++e) {
    const int own = continuum.material_number(static_cast<int>(e));
    const std::size_t in_model = is_exempt.size() - continuum.manifold.elements.size() + e;
    numbers.push_back(is_exempt[in_model] ? own + materials : own);
  }
  continuum.element_materials = std::move(numbers);
  for (int i = 0; i < materials && !continuum.laws.empty(); ++i)
    continuum.laws[static_cast<std::size_t>(i + materials)] = continuum.laws[static_cast<std::size_t>(i)];
}

Point centroid_of(const Model& model, const Element& element) {
  const auto begin = model.start_vertices.begin() + element.first_vertex.value;
  return centroid(std::vector<Point>(begin, begin + element.loop_sizes.front()));
}

}  // namespace

std::string name_of(Reduced what) {
  return kReduced.at(static_cast<std::size_t>(what));
}

Reduced reduced_of(const std::string& name) {
  const auto* const found = std::ranges::find(kReduced, name);
  if (found == kReduced.end())
    throw std::invalid_argument(fmt::format("expected joints, rock or both, found \"{}\"", name));
  return static_cast<Reduced>(found - kReduced.begin());
}

ReductionAsked completed(ReductionAsked given, const std::optional<ReductionAsked>& of_case) {
  const ReductionAsked usual{Reduced::joints, {}, {}, ReductionAsked::kWithin, {}};
  for (const ReductionAsked& other : {of_case.value_or(ReductionAsked()), usual}) {
    if (!given.what) given.what = other.what;
    if (!given.from) given.from = other.from;
    if (!given.to) given.to = other.to;
    if (!given.within) given.within = other.within;
    if (given.exempt.empty()) given.exempt = other.exempt;
  }
  return given;
}

Exempt exempt_of(const std::vector<std::string>& words) {
  Exempt exempt;
  for (const std::string& word : words) {
    const std::size_t colon = word.find(':');
    if (colon == std::string::npos) refuse(word);
    const std::string kind = word.substr(0, colon);
    const std::vector<double> numbers = numbers_of(std::string_view(word).substr(colon + 1), word);
    if (kind == "material")
      exempt.block_materials.insert(material_of(numbers, word));
    else if (kind == "joint_material")
      exempt.joint_materials.insert(material_of(numbers, word));
    else if (kind == "box")
      exempt.regions.push_back({word, box_of(numbers, word)});
    else if (kind == "polygon")
      exempt.regions.push_back({word, polygon_of(numbers, word)});
    else
      refuse(word);
    exempt.words.push_back(word);
  }
  return exempt;
}

void require_exempt(const Exempt& exempt, const Problem& problem) {
  if (!problem.analysis) return;
  const auto require = [&](const std::set<int>& numbers, std::size_t count, const char* kind) {
    if (!numbers.empty() && *numbers.rbegin() >= static_cast<int>(count))
      throw InputError(problem.analysis->place,
                       fmt::format("expected an exempt {} from 1 to {}, found {}", kind, count, *numbers.rbegin() + 1));
  };
  require(exempt.block_materials, problem.analysis->block_materials.size(), "block material");
  require(exempt.joint_materials, problem.analysis->joint_materials.size(), "joint material");
  if (!exempt.regions.empty() && !problem.stages.empty())
    throw InputError(problem.analysis->place,
                     "expected a case without stages for exempt regions, found stages; exempt a material instead");
}

ExemptCount exempt_regions(Prepared& prepared, const Exempt& exempt, int block_materials, int joint_materials) {
  Model& model = prepared.scene.model;
  ExemptCount count;
  std::vector<bool> is_exempt;
  for (Element& element : model.elements) {
    is_exempt.push_back(holds(exempt, centroid_of(model, element)));
    if (!is_exempt.back()) continue;
    element.material += block_materials;
    ++count.elements;
  }
  for (const VertexIndex v : indices(model.vertices)) {
    const Point end = model.start_vertices[static_cast<std::size_t>(v.value)];
    const Point begin = model.start_vertices[static_cast<std::size_t>(model.vertices[v].previous.value)];
    if (model.vertices[v].is_inner || !holds(exempt, 0.5 * (begin + end))) continue;
    model.vertices[v].joint_material += joint_materials;
    ++count.edges;
  }
  if (model.continuum) {
    Continuum continuum = *model.continuum;
    exempt_elements(continuum, is_exempt, block_materials);
    model.continuum = std::make_shared<const Continuum>(std::move(continuum));
  }
  Settings& settings = prepared.scene.settings;
  copy_behind(settings.mass_damping, block_materials);
  copy_behind(settings.stiffness_damping, block_materials);
  copy_behind(settings.basis, block_materials);
  copy_behind(settings.standard.elastic_law, block_materials);
  copy_behind(settings.standard.enforcement, joint_materials);
  prepared.scene.groundwork.reset();
  return count;
}

}  // namespace keyblock
