// Turns the VTK files of a frame into bodies, fields and tables in time.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/page/result_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "base/bytes/file_bytes.hpp"
#include "base/error.hpp"
#include "formats/registry.hpp"
#include "formats/views/vtk_piece.hpp"
#include "formats/views/vtu_reading.hpp"
#include "job/folder/frame_files.hpp"
#include "problem/units/measure.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;
using report::PageColumn;
using report::PageField;
using report::PageRows;
using report::PageRowsOf;

constexpr std::size_t kMostPageContacts = 1'200'000;  // in files: closed ones take about 10 MB on the page
constexpr int kVelocityBits = 7;  // those of blocks at rest are noise, and take as much room as others
constexpr std::uint32_t kNoBody = 0xffffffff;

constexpr std::array<std::string_view, 10> kWanted{"velocity",
                                                   "fixed_points",
                                                   "plastic_strain_xx",
                                                   "plastic_strain_yy",
                                                   "plastic_strain_xy",
                                                   "plastic_strain_zz",
                                                   "equivalent_plastic_strain",
                                                   "yield_state",
                                                   "has_yielded",
                                                   "body"};

using Values = std::map<std::string, const formats::VtuValues*, std::less<>>;

Values by_name(const formats::VtuFrame& frame) {
  Values values;
  for (const formats::VtuValues& found : frame.values) values[found.name] = &found;
  return values;
}

const formats::VtuValues* find(const Values& values, std::string_view name) {
  const auto found = values.find(name);
  return found == values.end() ? nullptr : found->second;
}

/// Bodies of more than one element move by covers.
std::vector<bool> are_on_covers(const FieldFrame& field) {
  std::unordered_map<int, int> elements;
  for (const FieldElement& element : field.elements) ++elements[element.body];
  std::vector<bool> found;
  for (const FieldElement& element : field.elements) found.push_back(!field.is_of_blocks && elements[element.body] > 1);
  return found;
}

report::PageShape shape_of(const formats::VtuFrame& frame, const Values& values) {
  report::PageShape shape;
  const std::vector<bool> on_covers = are_on_covers(frame.field);
  const formats::VtuValues* fixed = find(values, "fixed_points");
  for (std::size_t e = 0; e < frame.field.elements.size(); ++e) {
    const FieldElement& element = frame.field.elements[e];
    const auto number = static_cast<std::uint32_t>(frame.numbers[e] + 1);
    shape.key.push_back(number);
    shape.number.push_back(number);
    shape.material.push_back(static_cast<std::uint32_t>(element.material));
    const bool is_fixed = fixed != nullptr && fixed->values[e] > 0;
    shape.kind.push_back((on_covers[e] ? report::kElementOnCovers : 0) + (is_fixed ? report::kFixedBody : 0));
    for (const std::vector<FieldCorner>& loop : element.loops) {
      shape.loop_body.push_back(static_cast<std::uint32_t>(e));
      shape.loop_size.push_back(static_cast<std::uint32_t>(loop.size()));
      for (const FieldCorner& corner : loop) shape.places.push_back(corner.position);
    }
  }
  return shape;
}

template <class Visit>
void visit_corners_of(const FieldFrame& field, const Visit& visit) {
  for (const FieldElement& element : field.elements)
    for (const std::vector<FieldCorner>& loop : element.loops)
      for (const FieldCorner& corner : loop) visit(corner);
}

void add(std::vector<double>& numbers, const Stress& s) {
  numbers.insert(numbers.end(), {s.xx, s.yy, s.xy, s.zz});
}

// Principal stresses that differ little come from differences of these: 0.003 % of the largest component.
constexpr int kStressBits = 14;
const std::vector<std::string> kTensor{"xx", "yy", "xy", "zz"};

/// Fields of the bodies and of the corners of a frame.
class FieldsOf {
 public:
  FieldsOf(const formats::VtuFrame& frame, const Values& values) : frame_(frame), values_(values) {}

  std::vector<report::PageValues> all() && {
    add_velocity();
    add_stresses();
    add_plastic();
    return std::move(found_);
  }

 private:
  void add_velocity() {
    if (const formats::VtuValues* velocity = find(values_, "velocity")) {
      report::PageValues field{
          {"velocity", "Velocity", velocity->unit, PageRowsOf::body, {"x", "y"}, {}, kVelocityBits}, {}};
      for (std::size_t i = 0; i < velocity->values.size(); i += 3)
        field.numbers.insert(field.numbers.end(), {velocity->values[i], velocity->values[i + 1]});
      found_.push_back(std::move(field));
    }
  }

  void add_stresses() {
    const std::string unit = frame_.units == Units{} ? "" : unit_of(measures::kStress, frame_.units);
    report::PageValues of_bodies{{"stress", "Stress", unit, PageRowsOf::body, kTensor, {}, kStressBits}, {}};
    for (const FieldElement& element : frame_.field.elements) add(of_bodies.numbers, element.middle.stress);
    found_.push_back(std::move(of_bodies));
    if (!frame_.has_corner_stress) return;
    report::PageValues of_corners{
        {"corner_stress", "Stress at corners", unit, PageRowsOf::vertex, kTensor, {}, kStressBits}, {}};
    visit_corners_of(frame_.field, [&](const FieldCorner& corner) { add(of_corners.numbers, corner.stress); });
    found_.push_back(std::move(of_corners));
  }

  void add_plastic() {
    add_number("equivalent_plastic_strain", "Equivalent plastic strain");
    if (!find(values_, "yield_state")) return;
    report::PageValues strain{{"plastic_strain", "Plastic strain", "", PageRowsOf::body, kTensor}, {}};
    for (std::size_t e = 0; e < frame_.numbers.size(); ++e)
      for (const std::string& component : kTensor) {
        const formats::VtuValues* values = find(values_, "plastic_strain_" + component);
        strain.numbers.push_back(values == nullptr ? 0 : values->values[e]);
      }
    found_.push_back(std::move(strain));
    add_number("yield_state", "Yield state",
               {"elastic", "yields", "yields on an edge", "yields at the apex", "tension"});
    add_number("has_yielded", "Has yielded", {"no", "yes"});
    if (!frame_.has_corner_stress) return;
    report::PageValues corners{
        {"corner_plastic_strain", "Equivalent plastic strain at corners", "", PageRowsOf::vertex}, {}};
    visit_corners_of(frame_.field, [&](const FieldCorner& corner) {
      corners.numbers.push_back(corner.plastic.value_or(PlasticState{}).equivalent);
    });
    found_.push_back(std::move(corners));
  }

  void add_number(std::string_view name, const std::string& label, std::vector<std::string> states = {}) {
    if (const formats::VtuValues* values = find(values_, name))
      found_.push_back(
          {{std::string(name), label, values->unit, PageRowsOf::body, {}, std::move(states)}, values->values});
  }

  const formats::VtuFrame& frame_;
  const Values& values_;
  std::vector<report::PageValues> found_;
};

/// Rows of a part, and the numbers of each array that is wanted.
class PartReader {
 public:
  PartReader(const fs::path& file, std::string_view name, std::string_view section) : section_(section) {
    rows_.name = name;
    if (!fs::exists(file)) return;
    source_ = formats::load(file.string());
    piece_.emplace(source_, "PolyData");
  }

  std::vector<double> numbers(std::string_view array, std::string_view section = {}) const {
    if (!piece_) return {};
    const auto found = piece_->find(section.empty() ? section_ : section, array);
    return found ? found->numbers() : std::vector<double>();
  }

  /// Keeps two of every three numbers of a vector.
  std::vector<double> vectors(std::string_view array, std::string_view section = {}) const {
    const std::vector<double> all = numbers(array, section);
    std::vector<double> kept;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (i % 3 != 2) kept.push_back(all[i]);
    return kept;
  }

  /// Adds a column of the rows in `taken`. Throws InputError if the file has too few numbers.
  void add(PageColumn column, const std::vector<double>& numbers, const std::vector<std::size_t>& taken) {
    rows_.count = taken.size();
    for (const std::size_t row : taken) {
      if ((row + 1) * column.parts > numbers.size())
        throw InputError({source_.name}, fmt::format("expected {} numbers for each row of {}, found too few",
                                                     column.parts, column.name));
      for (std::size_t k = 0; k < column.parts; ++k) column.numbers.push_back(numbers[row * column.parts + k]);
    }
    rows_.columns.push_back(std::move(column));
  }

  std::string unit(std::string_view array) const { return piece_ ? piece_->unit(section_, array) : std::string(); }
  PageRows rows() && { return std::move(rows_); }

 private:
  std::string_view section_;
  formats::Source source_;
  std::optional<formats::VtkPiece> piece_;
  PageRows rows_;
};

std::vector<std::size_t> all_rows(std::size_t count) {
  std::vector<std::size_t> rows(count);
  for (std::size_t i = 0; i < count; ++i) rows[i] = i;
  return rows;
}

/// Replaces numbers of blocks by their rows.
std::vector<double> as_rows(std::vector<double> numbers, const std::unordered_map<std::uint32_t, std::size_t>& rows) {
  for (double& number : numbers) {
    const auto found = rows.find(static_cast<std::uint32_t>(number));
    number = static_cast<double>(found == rows.end() ? kNoBody : found->second);
  }
  return numbers;
}

PageRows contacts_of(const fs::path& file, const report::PageShape& shape, const Units& units) {
  PartReader part(file, "contacts", "PointData");
  const std::vector<double> states = part.numbers("state");
  std::vector<std::size_t> closed;
  for (std::size_t i = 0; i < states.size(); ++i)
    if (states[i] != 0) closed.push_back(i);
  std::unordered_map<std::uint32_t, std::size_t> rows;
  for (std::size_t i = 0; i < shape.number.size(); ++i) rows[shape.number[i]] = i;
  const bool has_units = units != Units{};
  const std::string length = has_units ? unit_of(measures::kLength, units) : "";
  const std::string force = has_units ? unit_of(measures::kForce, units) : "";
  const auto less_one = [](std::vector<double> numbers) {
    for (double& number : numbers) number -= 1;
    return numbers;
  };
  part.add({"place", length, 2, false, true}, part.vectors("Points", "Points"), closed);
  part.add({"normal", "", 2}, part.vectors("normal"), closed);
  part.add({"normal_force", force}, part.numbers("normal_force"), closed);
  part.add({"shear_force", force}, part.numbers("shear_force"), closed);
  part.add({"gap", length}, part.numbers("gap"), closed);
  part.add({"slip", length}, part.numbers("slip"), closed);
  part.add({"state", "", 1, true, false, {"open", "sticks", "slides"}}, states, closed);
  part.add({"block", "", 1, true}, as_rows(part.numbers("block"), rows), closed);
  part.add({"other", "", 1, true}, as_rows(part.numbers("other"), rows), closed);
  part.add({"joint", "", 1, true}, less_one(part.numbers("joint_material")), closed);
  part.add({"joint_line", "", 1, true}, part.numbers("joint"), closed);
  return std::move(part).rows();
}

/// Adds both ends of lines.
void add_ends(PartReader& part, const std::string& length, const std::vector<std::size_t>& all) {
  const std::vector<double> ends = part.vectors("Points", "Points");
  std::vector<double> from, to;
  for (std::size_t i = 0; i + 3 < ends.size(); i += 4) {
    from.insert(from.end(), {ends[i], ends[i + 1]});
    to.insert(to.end(), {ends[i + 2], ends[i + 3]});
  }
  part.add({"from", length, 2, false, true}, from, all);
  part.add({"to", length, 2, false, true}, to, all);
}

PageRows bolts_of(const fs::path& file, const Units& units) {
  PartReader part(file, "bolts", "CellData");
  const std::vector<double> numbers = part.numbers("bolt");
  const std::vector<std::size_t> all = all_rows(numbers.size());
  const bool has_units = units != Units{};
  part.add({"bolt", "", 1, true}, numbers, all);
  add_ends(part, has_units ? unit_of(measures::kLength, units) : "", all);
  part.add({"force", has_units ? unit_of(measures::kForce, units) : ""}, part.numbers("force"), all);
  part.add({"broken", "", 1, true, false, {"intact", "broken"}}, part.numbers("is_broken"), all);
  return std::move(part).rows();
}

PageRows cracks_of(const fs::path& file, const Units& units) {
  PartReader part(file, "cracks", "CellData");
  const std::vector<double> numbers = part.numbers("crack");
  const std::vector<std::size_t> all = all_rows(numbers.size());
  const std::string length = units == Units{} ? "" : unit_of(measures::kLength, units);
  part.add({"crack", "", 1, true}, numbers, all);
  add_ends(part, length, all);
  part.add({"displacement", length, 4}, part.vectors("displacement", "PointData"), all);
  part.add({"side", "", 1, true, false, {"right", "left"}}, part.numbers("side"), all);
  part.add({"is_shear", "", 1, true, false, {"tension", "shear"}}, part.numbers("is_shear"), all);
  return std::move(part).rows();
}

/// Returns the number of contacts that the head of a file names; 0 without a file.
std::size_t contacts_in(const fs::path& file) {
  constexpr std::size_t kHead = 1000;
  constexpr std::string_view kCount = "NumberOfPoints=\"";
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return 0;
  const std::string head = file_head(file.string(), kHead);
  const std::size_t at = head.find(kCount);
  std::size_t count = 0;
  if (at != std::string::npos) std::from_chars(head.data() + at + kCount.size(), head.data() + head.size(), count);
  return count;
}

bool has_part(const fs::path& folder, std::string_view part, int step) {
  return fs::exists(frame_part(folder, part, step));
}

}  // namespace

std::vector<ResultFrame> result_frames(const fs::path& folder) {
  std::vector<ResultFrame> frames;
  std::size_t rows = 0;
  for (const auto& [step, file] : frames_in(folder)) {
    frames.push_back({step, file});
    rows += contacts_in(frame_part(folder, "contacts", step));
  }
  if (frames.empty())
    throw InputError({folder.string()},
                     fmt::format("expected the folder of a run, with {}/*.vtu, found none", kFrameFolder));
  const std::size_t every = 1 + rows / kMostPageContacts;
  for (std::size_t i = 0; rows > 0 && i < frames.size(); ++i)
    frames[i].has_contacts = i % every == 0 || i + 1 == frames.size();
  return frames;
}

ReadFrame read_result_frame(const fs::path& folder, const ResultFrame& from) {
  const formats::Source source = formats::load(from.file.string());
  const formats::VtuFrame read = formats::read_vtu(source, kWanted);
  const Values values = by_name(read);
  ReadFrame result;
  report::PageFrame& frame = result.frame;
  result.units = read.units;
  frame.step = from.step;
  frame.time = read.field.time;
  frame.stage = read.stage.name;
  frame.is_static = read.stage.is_static;
  frame.load_factor = read.stage.load_factor;
  frame.shape = shape_of(read, values);
  visit_corners_of(read.field, [&](const FieldCorner& corner) { frame.moves.push_back(corner.displacement); });
  frame.values = FieldsOf(read, values).all();
  if (from.has_contacts)
    frame.parts.push_back(contacts_of(frame_part(folder, "contacts", from.step), frame.shape, read.units));
  if (has_part(folder, "bolts", from.step))
    frame.parts.push_back(bolts_of(frame_part(folder, "bolts", from.step), read.units));
  if (has_part(folder, "cracks", from.step))
    frame.parts.push_back(cracks_of(frame_part(folder, "cracks", from.step), read.units));
  return result;
}

}  // namespace keyblock
