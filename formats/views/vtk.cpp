// Chains blocks with holes into the closed polygons that VTK requires, and lays out the file.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/views/vtk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <pugixml.hpp>
#include <string_view>

#include "base/printable.hpp"
#include "formats/views/vtk_arrays.hpp"

namespace keyblock::formats {
namespace {

/// Row indices of corners.
using Chain = std::vector<std::size_t>;

std::vector<Point> places_of(const FramePart& corners) {
  std::vector<Point> places;
  if (corners.rows == 0) return places;
  const std::span<const double> numbers = corners.at("place").reals();
  places.reserve(corners.rows);
  for (std::size_t i = 0; i < numbers.size(); i += 2) places.push_back({numbers[i], numbers[i + 1]});
  return places;
}

/// Inserts a hole into the chain: from the nearest vertex of the chain to the hole, round it, and back.
Chain bridged(const Chain& chain, const Chain& hole, const std::vector<Point>& places) {
  std::size_t leave = 0;
  std::size_t enter = 0;
  const auto apart = [&](std::size_t i, std::size_t j) { return distance(places[chain[i]], places[hole[j]]); };
  for (std::size_t i = 0; i < chain.size(); ++i)
    for (std::size_t j = 0; j < hole.size(); ++j)
      if (apart(i, j) < apart(leave, enter)) leave = i, enter = j;
  const auto at = [](std::size_t index) { return static_cast<std::ptrdiff_t>(index); };
  Chain joined(chain.begin(), chain.begin() + at(leave) + 1);
  joined.insert(joined.end(), hole.begin() + at(enter), hole.end());
  joined.insert(joined.end(), hole.begin(), hole.begin() + at(enter) + 1);
  joined.insert(joined.end(), chain.begin() + at(leave), chain.end());
  return joined;
}

/// Corners of all polygons, in order.
struct Polygons {
  Chain corners;
  std::vector<std::int32_t> offsets;  ///< end of each polygon
};

Polygons polygons_of(const FrameColumns& frame, const std::vector<Point>& places) {
  const std::size_t blocks = frame.part("blocks").rows;
  std::vector<Chain> chains(blocks);
  const FramePart& loops = frame.part("loops");
  std::size_t first = 0;
  for (std::size_t i = 0; i < loops.rows; ++i) {
    Chain& chain = chains[static_cast<std::size_t>(loops.at("row").integers()[i])];
    Chain loop(static_cast<std::size_t>(loops.at("corners").integers()[i]));
    std::iota(loop.begin(), loop.end(), first);
    first += loop.size();
    if (chain.empty())
      chain = std::move(loop);
    else if (!loop.empty())
      chain = bridged(chain, loop, places);
  }
  Polygons polygons;
  polygons.corners.reserve(places.size());
  for (const Chain& chain : chains) {
    polygons.corners.insert(polygons.corners.end(), chain.begin(), chain.end());
    polygons.offsets.push_back(static_cast<std::int32_t>(polygons.corners.size()));
  }
  return polygons;
}

void add_polygons(VtkFile& file, const Polygons& polygons) {
  std::vector<std::int32_t> connectivity(polygons.corners.size());
  std::iota(connectivity.begin(), connectivity.end(), 0);
  constexpr std::uint8_t kPolygon = 7;
  file.begin("Cells");
  file.add("connectivity", connectivity);
  file.add("offsets", polygons.offsets);
  file.add("types", std::vector<std::uint8_t>(polygons.offsets.size(), kPolygon));
  file.end();
}

std::string fields_of(const FrameColumns& frame) {
  const FrameStage& stage = frame.stage;
  std::string fields = vtk_field("TimeValue", frame.time);
  if (!stage.name.empty()) fields += vtk_field("Stage", stage.name);
  if (stage.is_static) fields += vtk_field("IsStatic", 1);
  if (stage.load_factor) fields += vtk_field("LoadFactor", *stage.load_factor);
  return fields;
}

}  // namespace

std::string vtu(const FrameColumns& frame, const Units& units, VtkCoding coding) {
  const FramePart& blocks = frame.part("blocks");
  const FramePart& corners = frame.part("corners");
  const std::vector<Point> places = places_of(corners);
  const Polygons polygons = polygons_of(frame, places);
  VtkFile file("UnstructuredGrid", fields_of(frame),
               fmt::format("NumberOfPoints=\"{}\" NumberOfCells=\"{}\"", polygons.corners.size(), blocks.rows),
               polygons.corners.size(), coding);
  std::vector<Point> walked;
  walked.reserve(polygons.corners.size());
  for (const std::size_t corner : polygons.corners) walked.push_back(places[corner]);
  file.add_points(walked);
  add_polygons(file, polygons);
  if (corners.find("displacement")) {
    file.begin("PointData");
    add_arrays(file, corners, kCornerArrays, units, ArraysOf::rows, polygons.corners);
    file.end();
  }
  file.begin("CellData");
  add_arrays(file, blocks, kBlockArrays, units, ArraysOf::rows);
  file.end();
  return std::move(file).text();
}

std::string pvd(const std::vector<PvdEntry>& entries) {
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  for (const auto& [time, part, file, name] : entries) {
    const std::string named = name.empty() ? "" : fmt::format(" name=\"{}\"", escape_xml(name));
    text += fmt::format("<DataSet timestep=\"{}\" part=\"{}\"{} file=\"{}\"/>\n", time, part, named, escape_xml(file));
  }
  return text + "</Collection>\n</VTKFile>\n";
}

std::vector<PvdEntry> read_pvd(const std::string& text) {
  pugi::xml_document document;
  document.load_buffer(text.data(), text.size());  // what a cut file still has is read
  std::vector<PvdEntry> entries;
  for (const pugi::xpath_node& found : document.select_nodes("//DataSet")) {
    const pugi::xml_node entry = found.node();
    const int part = entry.attribute("part").as_int(-1);
    if (part < 0 || !entry.attribute("timestep") || !entry.attribute("file")) continue;
    entries.push_back({entry.attribute("timestep").as_double(), part, entry.attribute("file").value(),
                       entry.attribute("name").value()});
  }
  return entries;
}

}  // namespace keyblock::formats
