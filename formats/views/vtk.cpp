// The arrays follow one another in the order the viewer's panel shows them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/views/vtk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "formats/tables/run_tables.hpp"
#include "formats/text/numbers.hpp"
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
std::vector<double> places_of(const std::vector<Chain>& chains) {
  std::vector<double> places;
  for (const Chain& chain : chains)
    for (const Corner& corner : chain) places.insert(places.end(), {corner.at.x, corner.at.y, 0});
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

/// A number of each row. `value` takes the row and its place in the list.
template <class T, class Rows, class Value>
std::vector<T> column(const Rows& rows, const Value& value) {
  std::vector<T> numbers;
  numbers.reserve(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) numbers.push_back(static_cast<T>(value(rows[i], i)));
  return numbers;
}

/// A vector of each row, (x, y, 0).
template <class T, class Rows, class Value>
std::vector<T> vectors(const Rows& rows, const Value& value) {
  std::vector<T> numbers;
  numbers.reserve(3 * rows.size());
  for (const auto& row : rows) {
    const Point v = value(row);
    numbers.insert(numbers.end(), {static_cast<T>(v.x), static_cast<T>(v.y), T{0}});
  }
  return numbers;
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

/// Arrays of the cells, or of the points: rows that have a stress.
template <class Rows>
class StressArrays {
 public:
  StressArrays(VtkFile& file, const Rows& rows, const Units& units, const RunTable& arrays)
      : file_(file), rows_(rows), units_(units), arrays_(arrays) {}

  template <class Value>
  void whole(std::string_view name, const Value& value) {
    file_.add(heading(arrays_, name, units_), column<std::int32_t>(rows_, value));
  }
  template <class Value>
  void real(std::string_view name, const Value& value) {
    file_.add(heading(arrays_, name, units_), column<double>(rows_, value));
  }
  /// Of what follows from other arrays, or is only looked at: seven digits.
  template <class Value>
  void short_real(std::string_view name, const Value& value) {
    file_.add(heading(arrays_, name, units_), column<float>(rows_, value));
  }
  template <class T, class Value>
  void vector(std::string_view name, const Value& value) {
    file_.add(heading(arrays_, name, units_), vectors<T>(rows_, value), 3);
  }

  void stresses() {
    real("stress_xx", [](const auto& r, std::size_t) { return r.stress.xx; });
    real("stress_yy", [](const auto& r, std::size_t) { return r.stress.yy; });
    real("stress_xy", [](const auto& r, std::size_t) { return r.stress.xy; });
    real("stress_zz", [](const auto& r, std::size_t) { return r.stress.zz; });
    short_real("principal_stress_greatest", [](const auto& r, std::size_t) { return principal(r.stress).second; });
    short_real("principal_stress_least", [](const auto& r, std::size_t) { return principal(r.stress).first; });
    vector<float>("principal_axis", [](const auto& r) { return axis_of(r.stress); });
  }
  /// `material`: of the row at a place.
  template <class Material>
  void elastic_strains(Materials materials, const Material& material) {
    for (const ElasticArray& array : kElasticArrays)
      short_real(array.name, [&](const auto& r, std::size_t i) {
        return array.value(r.stress, materials[static_cast<std::size_t>(material(i))]);
      });
  }
  void plastic_strains() {
    for (const PlasticArray& array : kPlasticArrays)
      real(array.name, [&](const auto& r, std::size_t) { return plastic_value(array, r); });
  }

 private:
  VtkFile& file_;
  const Rows& rows_;
  const Units& units_;
  const RunTable& arrays_;
};

void add_cell_data(VtkFile& file, const Frame& frame, const FieldFrame& field, const Units& units,
                   Materials materials) {
  using E = const ElementFrame&;
  StressArrays cells(file, frame.elements, units, kBlockArrays);
  file.begin("CellData");
  cells.whole("block", [&](E, std::size_t i) { return number_of(frame, i) + 1; });
  // Only where something was cut off: what never changes is told once.
  if (std::ranges::any_of(frame.elements, [](E e) { return e.origin >= 0 && e.origin != e.number; }))
    cells.whole("origin", [&](E, std::size_t i) { return origin_of(frame, i) + 1; });
  if (!field.elements.empty() && !field.is_of_blocks)
    cells.whole("body", [&](E, std::size_t i) { return field.elements[i].body + 1; });
  cells.whole("material", [](E e, std::size_t) { return e.material + 1; });
  cells.stresses();
  cells.vector<double>("displacement", [](E e) { return e.displacement; });
  cells.vector<float>("velocity", [](E e) { return Point{e.velocity.x, e.velocity.y}; });
  cells.real("rotation", [](E e, std::size_t) { return e.rotation; });
  cells.short_real("rotation_rate", [](E e, std::size_t) { return e.velocity.rotation; });
  cells.short_real("area", [](E e, std::size_t) { return e.area; });
  cells.whole("fixed_points", [&](E, std::size_t i) { return fixed_points_of(frame, i); });
  if (!materials.empty()) cells.elastic_strains(materials, [&](std::size_t i) { return frame.elements[i].material; });
  if (frame.plastic) {
    cells.plastic_strains();
    cells.whole("yield_state",
                [](E e, std::size_t) { return static_cast<int>(e.plastic.value_or(PlasticState{}).region); });
    cells.whole("has_yielded", [](E e, std::size_t) { return e.plastic.value_or(PlasticState{}).has_yielded; });
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
  StressArrays points(file, corners, units, kCornerArrays);
  file.begin("PointData");
  points.vector<double>("displacement", [](const FieldCorner& c) { return c.displacement; });
  if (!field.is_of_blocks) {
    points.stresses();
    if (!materials.empty()) points.elastic_strains(materials, [&](std::size_t i) { return materials_of_corners[i]; });
    if (field.plastic) points.plastic_strains();
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
  file.begin("Points");
  file.add("Points", places_of(chains), 3);
  file.end();
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
