// Has one function per format; each reports its fault at the numbers concerned.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/convert/berkeley_faults.hpp"

#include <algorithm>
#include <cctype>

#include "formats/berkeley/ddaml.hpp"
#include "formats/shi/dda_analysis.hpp"
#include "formats/shi/dda_geometry.hpp"

namespace keyblock::study {
namespace {

using formats::Reading;

void lose_first_material_line(Reading& reading) {
  std::vector<MaterialLine>& lines = reading.content.drawing->material_lines;
  if (lines.empty()) return;
  reading.warnings.push_back({"first_material_line_lost", lines.front().place, "the first material line is lost"});
  lines.erase(lines.begin());
}

/// Returns all numbers after the material lines, in the order of the file.
std::vector<double> numbers_of_marks(const Drawing& drawing) {
  std::vector<double> numbers;
  const auto add = [&](std::initializer_list<double> more) { numbers.insert(numbers.end(), more); };
  const auto add_segment = [&](const Segment& s) { add({s.start.x, s.start.y, s.end.x, s.end.y}); };
  for (const BoltLine& bolt : drawing.bolts) {
    add_segment(bolt.segment);
    add({bolt.stiffness, bolt.strength, bolt.pretension});
  }
  for (const FixedLine& line : drawing.fixed_lines) add_segment(line.segment);
  for (const auto* points : {&drawing.loading_points, &drawing.measured_points, &drawing.hole_points})
    for (const MarkedPoint& point : *points) add({point.position.x, point.position.y});
  return numbers;
}

void read_on_at_bolts(Reading& reading) {
  Drawing& drawing = *reading.content.drawing;
  if (drawing.bolts.empty()) return;
  const Place place = drawing.bolts.front().place;
  const bool is_of_seven = std::ranges::none_of(
      reading.warnings, [](const Warning& warning) { return warning.name.starts_with("bolts_with"); });
  if (!is_of_seven)
    throw InputError(place, "expected bolts of 7 numbers, which the Berkeley program can read, found others");
  const std::vector<double> numbers = numbers_of_marks(drawing);
  auto next = numbers.begin();
  const auto next_point = [&] {
    const double x = *next++;
    return Point{x, *next++};
  };
  for (FixedLine& line : drawing.fixed_lines) {
    line.segment.start = next_point();
    line.segment.end = next_point();
  }
  for (auto* points : {&drawing.loading_points, &drawing.measured_points, &drawing.hole_points})
    for (MarkedPoint& point : *points) point.position = next_point();
  drawing.bolts.clear();
  reading.warnings.push_back(
      {"bolts_not_read", place, "bolts are not read: fixed lines and points are made of the numbers from here on"});
}

/// An integer is read up to the first other character; the remainder of the number makes the following reads fail.
void require_whole_carry_over(const formats::FileReading& file) {
  const std::string& text = file.source.text;
  const auto is_space = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  const auto start = std::ranges::find_if_not(text, is_space);
  const auto end = std::find_if(start, text.end(), is_space);
  const std::string word(start, end);
  if (word != "0" && word != "1")
    throw InputError(
        file.reading->content.analysis->place,
        "expected a velocity carry-over spelled 0 or 1, without which the Berkeley program reads no counts "
        "of steps and materials; found \"" +
            word + "\"");
}

void take_velocity_from_gradient(Reading& reading) {
  for (BlockMaterial& material : reading.content.analysis->block_materials) {
    const Stress& gradient = material.stress_gradient;
    const Velocity velocity{gradient.xx, gradient.yy, gradient.xy};
    if (material.initial_velocity == velocity) continue;
    material.initial_velocity = velocity;
    reading.warnings.push_back({"velocity_from_gradient", material.place,
                                "the stress gradient is taken as initial velocity too, the velocity is not used"});
  }
}

void drop_boundaries(Reading& reading) {
  Drawing& drawing = *reading.content.drawing;
  if (drawing.boundary_count == 0) return;
  reading.warnings.push_back({"boundaries_dropped", drawing.joints.front().place, "lines of Boundlist are dropped"});
  drawing.joints.erase(drawing.joints.begin(),
                       drawing.joints.begin() + static_cast<std::ptrdiff_t>(drawing.boundary_count));
  drawing.boundary_count = 0;
}

void take_gradient_from_velocity(Reading& reading) {
  for (BlockMaterial& material : reading.content.analysis->block_materials) {
    const Velocity& velocity = material.initial_velocity;
    if (velocity != Velocity{}) {
      material.stress_gradient = {velocity.x, velocity.y, velocity.rotation};
      reading.warnings.push_back(
          {"gradient_from_velocity", material.place, "Ivelocity is taken as stress gradient too"});
    }
    if (material.initial_strain != std::array<double, 3>{})
      reading.warnings.push_back({"strain_without_effect", material.place, "Istrain has no effect"});
    material.initial_strain = {};
  }
}

}  // namespace

Reading as_berkeley_reads(const formats::FileReading& file) {
  Reading reading = *file.reading;
  const std::string_view format = file.choice->format->name;
  if (format == formats::kDdaGeometry.name) {
    lose_first_material_line(reading);
    read_on_at_bolts(reading);
  } else if (format == formats::kDdaAnalysisBerkeley.name) {
    require_whole_carry_over(file);
    take_velocity_from_gradient(reading);
  } else if (format == formats::kDdaml.name) {
    if (reading.content.drawing) drop_boundaries(reading);
    if (reading.content.analysis) take_gradient_from_velocity(reading);
  } else {
    reading.warnings.push_back(
        {"not_of_berkeley", {file.path}, "the Berkeley program does not read such a file; it stays as it is"});
  }
  return reading;
}

}  // namespace keyblock::study
