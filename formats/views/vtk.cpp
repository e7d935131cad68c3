// Writes VTK's XML by hand; the arrays follow one another in the order the viewer's panel shows them.
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

/// One value a cell, or three with `width` 3.
template <class Value>
void append_cells(std::string& text, const Frame& frame, std::string_view type, std::string_view name, int width,
                  Value value) {
  text += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n", type, name,
                      width);
  for (std::size_t i = 0; i < frame.elements.size(); ++i) text += value(i, frame.elements[i]) + "\n";
  text += "</DataArray>\n";
}

std::string vector_text(double x, double y) {
  return fmt::format("{} {} 0", format_real(x), format_real(y));
}

void append_points(std::string& text, const std::vector<Chain>& chains) {
  text += "<Points>\n<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for (const Chain& chain : chains)
    for (const Corner& corner : chain) text += vector_text(corner.at.x, corner.at.y) + "\n";
  text += "</DataArray>\n</Points>\n";
}

void append_polygons(std::string& text, const std::vector<Chain>& chains) {
  std::string connectivity;
  std::string offsets;
  std::string types;
  std::size_t next = 0;
  for (const Chain& chain : chains) {
    for (std::size_t i = 0; i < chain.size(); ++i) connectivity += fmt::format("{} ", next++);
    connectivity += '\n';
    offsets += fmt::format("{}\n", next);
    types += "7\n";
  }
  text += "<Cells>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n" + connectivity;
  text += "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n" + offsets;
  text += "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n" + types;
  text += "</DataArray>\n</Cells>\n";
}

std::string axis_text(const Stress& stress) {
  const double angle = principal_angle(stress);
  return fmt::format("{:.9f} {:.9f} 0", std::cos(angle), std::sin(angle));
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
std::string plastic_text(const PlasticArray& array, const Of& of) {
  return format_real(array.value(of.plastic.value_or(PlasticState{}), invariants_of(of.stress)));
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

void append_elastic_cells(std::string& text, const Frame& frame, const Units& units, Materials materials) {
  for (const ElasticArray& array : kElasticArrays)
    append_cells(text, frame, "Float64", heading(kBlockArrays, array.name, units), 1,
                 [&](std::size_t, const ElementFrame& e) {
                   return format_real(array.value(e.stress, materials[static_cast<std::size_t>(e.material)]));
                 });
}

void append_plastic_cells(std::string& text, const Frame& frame, const Units& units) {
  using E = const ElementFrame&;
  for (const PlasticArray& array : kPlasticArrays)
    append_cells(text, frame, "Float64", heading(kBlockArrays, array.name, units), 1,
                 [&](std::size_t, E e) { return plastic_text(array, e); });
  append_cells(text, frame, "Int32", heading(kBlockArrays, "yield_state", units), 1, [](std::size_t, E e) {
    return fmt::format("{}", static_cast<int>(e.plastic.value_or(PlasticState{}).region));
  });
  append_cells(text, frame, "Int32", heading(kBlockArrays, "has_yielded", units), 1,
               [](std::size_t, E e) { return fmt::format("{:d}", e.plastic.value_or(PlasticState{}).has_yielded); });
}

void append_cell_data(std::string& text, const Frame& frame, const FieldFrame& field, const Units& units,
                      Materials materials) {
  using E = const ElementFrame&;
  const auto real = [&](std::string_view name, auto member) {
    append_cells(text, frame, "Float64", heading(kBlockArrays, name, units), 1,
                 [&](std::size_t, E e) { return format_real(member(e)); });
  };
  text += "<CellData>\n";
  append_cells(text, frame, "Int32", heading(kBlockArrays, "block", units), 1,
               [&](std::size_t i, E) { return fmt::format("{}", number_of(frame, i) + 1); });
  // Only where something was cut off: what never changes is told once.
  if (std::ranges::any_of(frame.elements, [](E e) { return e.origin >= 0 && e.origin != e.number; }))
    append_cells(text, frame, "Int32", heading(kBlockArrays, "origin", units), 1,
                 [&](std::size_t i, E) { return fmt::format("{}", origin_of(frame, i) + 1); });
  if (!field.elements.empty() && !field.is_of_blocks)
    append_cells(text, frame, "Int32", heading(kBlockArrays, "body", units), 1,
                 [&](std::size_t i, E) { return fmt::format("{}", field.elements[i].body + 1); });
  append_cells(text, frame, "Int32", heading(kBlockArrays, "material", units), 1,
               [](std::size_t, E e) { return fmt::format("{}", e.material + 1); });
  real("stress_xx", [](E e) { return e.stress.xx; });
  real("stress_yy", [](E e) { return e.stress.yy; });
  real("stress_xy", [](E e) { return e.stress.xy; });
  real("stress_zz", [](E e) { return e.stress.zz; });
  real("principal_stress_greatest", [](E e) { return principal(e.stress).second; });
  real("principal_stress_least", [](E e) { return principal(e.stress).first; });
  append_cells(text, frame, "Float64", heading(kBlockArrays, "principal_axis", units), 3,
               [](std::size_t, E e) { return axis_text(e.stress); });
  append_cells(text, frame, "Float64", heading(kBlockArrays, "displacement", units), 3,
               [](std::size_t, E e) { return vector_text(e.displacement.x, e.displacement.y); });
  append_cells(text, frame, "Float64", heading(kBlockArrays, "velocity", units), 3,
               [](std::size_t, E e) { return vector_text(e.velocity.x, e.velocity.y); });
  real("rotation", [](E e) { return e.rotation; });
  real("rotation_rate", [](E e) { return e.velocity.rotation; });
  real("area", [](E e) { return e.area; });
  append_cells(text, frame, "Int32", heading(kBlockArrays, "fixed_points", units), 1,
               [&](std::size_t i, E) { return fmt::format("{}", fixed_points_of(frame, i)); });
  if (!materials.empty()) append_elastic_cells(text, frame, units, materials);
  if (frame.plastic) append_plastic_cells(text, frame, units);
  text += "</CellData>\n";
}

std::string head(double time, std::size_t points, std::size_t cells) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n"
      "<UnstructuredGrid>\n<FieldData>\n"
      "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n"
      "</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
      format_real(time), points, cells);
}

/// Displacement and stress of corners, one a line.
void append_field(std::string& text, const FieldFrame& field, const std::vector<Chain>& chains, const Units& units,
                  Materials materials) {
  std::vector<const FieldCorner*> corners;
  std::vector<int> materials_of_corners;
  for (std::size_t e = 0; e < chains.size(); ++e) {
    std::vector<const FieldCorner*> numbered;
    for (const auto& loop : field.elements[e].loops)
      for (const FieldCorner& corner : loop) numbered.push_back(&corner);
    for (const Corner& corner : chains[e]) corners.push_back(numbered[corner.number]);
    materials_of_corners.resize(corners.size(), field.elements[e].material);
  }
  const auto append = [&](std::string_view name, int width, auto value) {
    text += fmt::format("<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n",
                        heading(kCornerArrays, name, units), width);
    for (const FieldCorner* corner : corners) text += value(*corner) + "\n";
    text += "</DataArray>\n";
  };
  using C = const FieldCorner&;
  text += "<PointData>\n";
  append("displacement", 3, [](C c) { return vector_text(c.displacement.x, c.displacement.y); });
  if (field.is_of_blocks) {
    text += "</PointData>\n";
    return;
  }
  append("stress_xx", 1, [](C c) { return format_real(c.stress.xx); });
  append("stress_yy", 1, [](C c) { return format_real(c.stress.yy); });
  append("stress_xy", 1, [](C c) { return format_real(c.stress.xy); });
  append("stress_zz", 1, [](C c) { return format_real(c.stress.zz); });
  append("principal_stress_greatest", 1, [](C c) { return format_real(principal(c.stress).second); });
  append("principal_stress_least", 1, [](C c) { return format_real(principal(c.stress).first); });
  append("principal_axis", 3, [](C c) { return axis_text(c.stress); });
  for (std::size_t i = 0; i < kElasticArrays.size() && !materials.empty(); ++i) {
    auto material = materials_of_corners.begin();
    append(kElasticArrays[i].name, 1, [&](C c) {
      return format_real(kElasticArrays[i].value(c.stress, materials[static_cast<std::size_t>(*material++)]));
    });
  }
  if (field.plastic)
    for (const PlasticArray& array : kPlasticArrays) append(array.name, 1, [&](C c) { return plastic_text(array, c); });
  text += "</PointData>\n";
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
                std::span<const BlockMaterial> materials) {
  std::vector<Chain> chains;
  std::size_t point_count = 0;
  for (const ElementFrame& element : frame.elements) {
    chains.push_back(one_chain(element.loops));
    point_count += chains.back().size();
  }
  std::string text = head(frame.time, point_count, chains.size());
  append_points(text, chains);
  append_polygons(text, chains);
  if (!field.elements.empty()) append_field(text, field, chains, units, materials);
  append_cell_data(text, frame, field, units, materials);
  return text + "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

std::string pvd(const std::vector<PvdEntry>& entries) {
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  for (const auto& [time, part, file] : entries)
    text += fmt::format("<DataSet timestep=\"{:.17g}\" part=\"{}\" file=\"{}\"/>\n", time, part, attribute(file));
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace keyblock::formats
