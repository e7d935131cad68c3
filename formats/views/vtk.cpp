// The arrays follow one another in the order the viewer's panel shows them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/views/vtk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "formats/views/vtk_rows.hpp"
#include "material/stress_invariants.hpp"
#include "result/extremes.hpp"

namespace keyblock::formats {
namespace {

/// A corner of an element, numbered through its loops.
struct Corner {
  Point at;
  std::size_t number = 0;
};

using Chain = std::vector<Corner>;

/// Walks from the chain to the nearest vertex of the hole, round it, and back.
Chain bridged(const Chain& chain, const Chain& hole) {
  std::size_t leave = 0;
  std::size_t enter = 0;
  for (std::size_t i = 0; i < chain.size(); ++i)
    for (std::size_t j = 0; j < hole.size(); ++j)
      if (distance(chain[i].at, hole[j].at) < distance(chain[leave].at, hole[enter].at)) leave = i, enter = j;
  const auto at = [](std::size_t index) { return static_cast<std::ptrdiff_t>(index); };
  Chain joined(chain.begin(), chain.begin() + at(leave) + 1);
  joined.insert(joined.end(), hole.begin() + at(enter), hole.end());
  joined.insert(joined.end(), hole.begin(), hole.begin() + at(enter) + 1);
  joined.insert(joined.end(), chain.begin() + at(leave), chain.end());
  return joined;
}

Chain one_chain(const std::vector<std::vector<Point>>& loops) {
  Chain chain;
  std::size_t number = 0;
  for (const std::vector<Point>& loop : loops) {
    Chain numbered;
    for (const Point p : loop) numbered.push_back({p, number++});
    if (chain.empty())
      chain = std::move(numbered);
    else if (!numbered.empty())
      chain = bridged(chain, numbered);
  }
  return chain;
}

/// The corners of all elements, one after the other.
std::vector<Point> places_of(const std::vector<Chain>& chains) {
  std::vector<Point> places;
  for (const Chain& chain : chains)
    for (const Corner& corner : chain) places.push_back(corner.at);
  return places;
}

void add_polygons(VtkFile& file, const std::vector<Chain>& chains) {
  std::vector<std::int32_t> connectivity, offsets;
  for (const Chain& chain : chains) {
    for (std::size_t i = 0; i < chain.size(); ++i)
      connectivity.push_back(static_cast<std::int32_t>(connectivity.size()));
    offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
  }
  constexpr std::uint8_t kPolygon = 7;
  file.begin("Cells");
  file.add("connectivity", connectivity);
  file.add("offsets", offsets);
  file.add("types", std::vector<std::uint8_t>(chains.size(), kPolygon));
  file.end();
}

Point axis_of(const Stress& stress) {
  const double angle = principal_angle(stress);
  return {std::cos(angle), std::sin(angle)};
}

int fixed_points_of(const Frame& frame, std::size_t element) {
  const int number = number_of(frame, element);
  return static_cast<int>(std::ranges::count(frame.fixed_points, number, &PointFrame::element));
}

/// What is shown of rock where some may yield; of that which cannot, no plastic strain.
struct PlasticArray {
  std::string_view name;
  double (*value)(const PlasticState&, const StressInvariants&);
};

constexpr std::array<PlasticArray, 8> kPlasticArrays{{
    {"plastic_strain_xx", [](const PlasticState& s, const StressInvariants&) { return s.xx; }},
    {"plastic_strain_yy", [](const PlasticState& s, const StressInvariants&) { return s.yy; }},
    {"plastic_strain_xy", [](const PlasticState& s, const StressInvariants&) { return s.xy; }},
    {"plastic_strain_zz", [](const PlasticState& s, const StressInvariants&) { return s.zz; }},
    {"equivalent_plastic_strain", [](const PlasticState& s, const StressInvariants&) { return s.equivalent; }},
    {"mean_stress", [](const PlasticState&, const StressInvariants& i) { return i.mean; }},
    {"von_mises_stress", [](const PlasticState&, const StressInvariants& i) { return i.von_mises; }},
    {"lode_angle", [](const PlasticState&, const StressInvariants& i) { return i.lode_deg; }},
}};

template <class Of>
double plastic_value(const PlasticArray& array, const Of& of) {
  return array.value(of.plastic.value_or(PlasticState{}), invariants_of(of.stress));
}

/// The component of elastic strain, from the normal stress along it, the two others', and the shear stress.
struct ElasticArray {
  std::string_view name;
  double (*value)(const Stress&, const BlockMaterial&);
};

double normal_strain(double along, double across, const BlockMaterial& rock) {
  return (along - rock.poissons_ratio * across) / rock.youngs_modulus;
}

constexpr std::array<ElasticArray, 4> kElasticArrays{{
    {"elastic_strain_xx", [](const Stress& s, const BlockMaterial& m) { return normal_strain(s.xx, s.yy + s.zz, m); }},
    {"elastic_strain_yy", [](const Stress& s, const BlockMaterial& m) { return normal_strain(s.yy, s.zz + s.xx, m); }},
    {"elastic_strain_xy",
     [](const Stress& s, const BlockMaterial& m) { return (1 + m.poissons_ratio) * s.xy / m.youngs_modulus; }},
    {"elastic_strain_zz", [](const Stress& s, const BlockMaterial& m) { return normal_strain(s.zz, s.xx + s.yy, m); }},
}};

using Materials = std::span<const BlockMaterial>;

// Of cells and of corners alike: rows that have a stress. What follows from it has seven digits.

template <class Rows>
void add_stresses(VtkRows<Rows>& rows) {
  using std::size_t;
  rows.template add<double>("stress_xx", [](const auto& r, size_t) { return r.stress.xx; });
  rows.template add<double>("stress_yy", [](const auto& r, size_t) { return r.stress.yy; });
  rows.template add<double>("stress_xy", [](const auto& r, size_t) { return r.stress.xy; });
  rows.template add<double>("stress_zz", [](const auto& r, size_t) { return r.stress.zz; });
  const auto add = [&](std::string_view name, const auto& of) {
    rows.template add<float>(name, [&](const auto& r, size_t) { return of(principal(r.stress)); });
  };
  add("principal_stress_greatest", [](const auto& principals) { return principals.second; });
  add("principal_stress_least", [](const auto& principals) { return principals.first; });
  rows.template add_vectors<float>("principal_axis", [](const auto& r) { return std::array{axis_of(r.stress)}; });
}

/// `material`: number of that of the row at a place.
template <class Rows, class Material>
void add_elastic_strains(VtkRows<Rows>& rows, Materials materials, const Material& material) {
  for (const ElasticArray& array : kElasticArrays)
    rows.template add<float>(array.name, [&](const auto& r, std::size_t i) {
      return array.value(r.stress, materials[static_cast<std::size_t>(material(i))]);
    });
}

template <class Rows>
void add_plastic_strains(VtkRows<Rows>& rows) {
  for (const PlasticArray& array : kPlasticArrays)
    rows.template add<double>(array.name, [&](const auto& r, std::size_t) { return plastic_value(array, r); });
}

void add_cell_data(VtkFile& file, const Frame& frame, const FieldFrame& field, const Units& units,
                   Materials materials) {
  using E = const ElementFrame&;
  VtkRows cells(file, frame.elements, kBlockArrays, units);
  file.begin("CellData");
  cells.add<std::int32_t>("block", [&](E, std::size_t i) { return number_of(frame, i) + 1; });
  // Only where something was cut off: what never changes is told once.
  if (std::ranges::any_of(frame.elements, [](E e) { return e.origin >= 0 && e.origin != e.number; }))
    cells.add<std::int32_t>("origin", [&](E, std::size_t i) { return origin_of(frame, i) + 1; });
  if (!field.elements.empty() && !field.is_of_blocks)
    cells.add<std::int32_t>("body", [&](E, std::size_t i) { return field.elements[i].body + 1; });
  cells.add<std::int32_t>("material", [](E e, std::size_t) { return e.material + 1; });
  add_stresses(cells);
  cells.add_vectors<double>("displacement", [](E e) { return std::array{e.displacement}; });
  cells.add_vectors<float>("velocity", [](E e) { return std::array{Point{e.velocity.x, e.velocity.y}}; });
  cells.add<double>("rotation", [](E e, std::size_t) { return e.rotation; });
  cells.add<float>("rotation_rate", [](E e, std::size_t) { return e.velocity.rotation; });
  cells.add<float>("area", [](E e, std::size_t) { return e.area; });
  cells.add<std::int32_t>("fixed_points", [&](E, std::size_t i) { return fixed_points_of(frame, i); });
  if (!materials.empty())
    add_elastic_strains(cells, materials, [&](std::size_t i) { return frame.elements[i].material; });
  if (frame.plastic) {
    add_plastic_strains(cells);
    cells.add<std::int32_t>(
        "yield_state", [](E e, std::size_t) { return static_cast<int>(e.plastic.value_or(PlasticState{}).region); });
    cells.add<std::int32_t>("has_yielded",
                            [](E e, std::size_t) { return e.plastic.value_or(PlasticState{}).has_yielded; });
  }
  file.end();
}

/// Displacement and stress of corners.
void add_field(VtkFile& file, const FieldFrame& field, const std::vector<Chain>& chains, const Units& units,
               Materials materials) {
  std::vector<FieldCorner> corners;
  std::vector<int> materials_of_corners;
  for (std::size_t e = 0; e < chains.size(); ++e) {
    std::vector<const FieldCorner*> numbered;
    for (const auto& loop : field.elements[e].loops)
      for (const FieldCorner& corner : loop) numbered.push_back(&corner);
    for (const Corner& corner : chains[e]) corners.push_back(*numbered[corner.number]);
    materials_of_corners.resize(corners.size(), field.elements[e].material);
  }
  VtkRows points(file, corners, kCornerArrays, units);
  file.begin("PointData");
  points.add_vectors<double>("displacement", [](const FieldCorner& c) { return std::array{c.displacement}; });
  if (!field.is_of_blocks) {
    add_stresses(points);
    if (!materials.empty())
      add_elastic_strains(points, materials, [&](std::size_t i) { return materials_of_corners[i]; });
    if (field.plastic) add_plastic_strains(points);
  }
  file.end();
}

std::string attribute(std::string_view text) {
  std::string safe;
  for (char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '"')
      safe += "&quot;";
    else
      safe += c;
  }
  return safe;
}

}  // namespace

std::string vtu(const Frame& frame, const FieldFrame& field, const Units& units,
                std::span<const BlockMaterial> materials, VtkCoding coding) {
  std::vector<Chain> chains;
  std::size_t point_count = 0;
  for (const ElementFrame& element : frame.elements) {
    chains.push_back(one_chain(element.loops));
    point_count += chains.back().size();
  }
  VtkFile file("UnstructuredGrid", frame.time,
               fmt::format("NumberOfPoints=\"{}\" NumberOfCells=\"{}\"", point_count, chains.size()), coding);
  file.add_points(places_of(chains));
  add_polygons(file, chains);
  if (!field.elements.empty()) add_field(file, field, chains, units, materials);
  add_cell_data(file, frame, field, units, materials);
  return std::move(file).text();
}

std::string pvd(const std::vector<PvdEntry>& entries) {
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  for (const auto& [time, part, file] : entries)
    text += fmt::format("<DataSet timestep=\"{:.17g}\" part=\"{}\" file=\"{}\"/>\n", time, part, attribute(file));
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace keyblock::formats
