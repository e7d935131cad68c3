// Numbers in files for viewers: the same in every encoding, and a clear error if bytes are missing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/views/vtk_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "base/error.hpp"
#include "formats/views/vtk.hpp"
#include "formats/views/vtu_reading.hpp"

namespace keyblock::formats::vtk_file_test {
namespace {

constexpr VtkCoding kCodings[] = {VtkCoding::automatic, VtkCoding::raw, VtkCoding::zlib, VtkCoding::text};

/// Squares here and there, more than zlib packs at once, with stresses and displacements of many digits.
Frame squares(int count, FieldFrame& field) {
  std::mt19937 random(7);
  std::normal_distribution<double> some(0, 1e3);
  Frame frame;
  frame.time = 1.0 / 3;
  field = {0, frame.time, {}};
  field.is_of_blocks = true;
  for (int i = 0; i < count; ++i) {
    const Point at{some(random), some(random)}, moved{some(random), some(random)};
    ElementFrame& element = frame.elements.emplace_back();
    FieldElement& drawn = field.elements.emplace_back();
    element.number = i;
    element.loops.emplace_back();
    drawn.loops.emplace_back();
    for (const Point corner : {Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{0, 1}}) {
      element.loops[0].push_back(at + corner + moved);
      drawn.loops[0].push_back({at + corner, moved, {}});
    }
    element.displacement = moved;
    element.stress = {some(random), some(random), some(random), some(random)};
  }
  return frame;
}

std::string message_of(const std::string& text) {
  try {
    read_vtu({"a.vtu", text});
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST(VtkFile, a_frame_reads_back_the_same_whichever_way_it_is_written) {
  FieldFrame field;
  const Frame frame = squares(3000, field);
  for (const VtkCoding coding : kCodings) {
    const VtuFrame back = read_vtu({"a.vtu", vtu(with_derived(columns_of(frame, {}, field)), {}, coding)});
    ASSERT_EQ(back.field.elements.size(), frame.elements.size());
    EXPECT_EQ(back.field.time, frame.time);
    for (std::size_t i = 0; i < frame.elements.size(); ++i) {
      const FieldElement& element = back.field.elements[i];
      EXPECT_EQ(back.numbers[i], static_cast<int>(i));
      EXPECT_EQ(element.middle.displacement, frame.elements[i].displacement);
      EXPECT_EQ(element.middle.stress.xx, frame.elements[i].stress.xx);
      EXPECT_EQ(element.middle.stress.zz, frame.elements[i].stress.zz);
      ASSERT_EQ(element.loops[0].size(), 4U);
      for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(element.loops[0][c].displacement, frame.elements[i].displacement);
    }
  }
}

TEST(VtkFile, the_stage_of_a_frame_reads_back) {
  FieldFrame field;
  const Frame frame = squares(1, field);
  FrameColumns columns = with_derived(columns_of(frame, {}, field));
  const auto stage_of = [&] { return read_vtu({"a.vtu", vtu(columns, {}, VtkCoding::raw)}).stage; };
  EXPECT_EQ(stage_of().name, "");
  EXPECT_FALSE(stage_of().is_static);
  EXPECT_FALSE(stage_of().load_factor);
  columns.stage = {"top <heading> \u00e4", true, 0.25};
  EXPECT_EQ(stage_of().name, columns.stage.name);
  EXPECT_TRUE(stage_of().is_static);
  EXPECT_EQ(stage_of().load_factor, 0.25);
}

TEST(VtkFile, raw_bytes_are_fewer_than_text_and_packed_ones_fewer_still) {
  FieldFrame field;
  const Frame frame = squares(3000, field);
  const std::size_t raw = vtu(with_derived(columns_of(frame, {}, field)), {}, VtkCoding::raw).size();
  EXPECT_LT(raw, 3000 * 340U) << "bytes of a block";
  EXPECT_LT(raw, vtu(with_derived(columns_of(frame, {}, field)), {}, VtkCoding::text).size());
  const std::size_t automatic = vtu(with_derived(columns_of(frame, {}, field)), {}, VtkCoding::automatic).size();
  EXPECT_LT(vtu(with_derived(columns_of(frame, {}, field)), {}, VtkCoding::zlib).size(), automatic);
  EXPECT_LT(automatic, raw * 9 / 10);
}

TEST(VtkFile, small_frames_are_bytes_unless_chosen_otherwise) {
  FieldFrame field;
  const Frame frame = squares(100, field);
  EXPECT_EQ(vtu(with_derived(columns_of(frame, {}, field)), {}, VtkCoding::automatic),
            vtu(with_derived(columns_of(frame, {}, field)), {}, VtkCoding::raw));
}

TEST(VtkFile, a_file_cut_short_anywhere_is_an_error_at_its_place) {
  FieldFrame field;
  const Frame frame = squares(40, field);
  for (const VtkCoding coding : kCodings) {
    const std::string whole = vtu(with_derived(columns_of(frame, {}, field)), {}, coding);
    // The last array of all is one that no picture needs.
    for (std::size_t size = 0; size < whole.size() * 3 / 4; size += 61) {
      const std::string message = message_of(whole.substr(0, size));
      EXPECT_NE(message.find("a.vtu"), std::string::npos) << size;
      EXPECT_NE(message.find("expected"), std::string::npos) << message;
    }
  }
}

TEST(VtkFile, odd_bytes_are_refused) {
  FieldFrame field;
  const Frame frame = squares(40, field);
  std::string raw = vtu(with_derived(columns_of(frame, {}, field)), {}, VtkCoding::raw);
  const auto with = [&](std::string text, const std::string& old, const std::string& put) {
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos);
    return text.replace(at, old.size(), put);
  };
  EXPECT_NE(message_of(with(raw, "offset=\"0\"", "offset=\"x\"")).find("expected an offset of bytes"),
            std::string::npos);
  EXPECT_NE(message_of(with(raw, "offset=\"0\"", "offset=\"99999999999\"")).find("behind the XML"), std::string::npos);
  EXPECT_NE(message_of(with(raw, "\"Float64\" Name=\"Points\"", "\"String\" Name=\"Points\"")).find("found String"),
            std::string::npos);
  EXPECT_NE(message_of(with(raw, "encoding=\"raw\">_", "encoding=\"raw\"> ")).find("expected _"), std::string::npos);
  std::string packed = vtu(with_derived(columns_of(frame, {}, field)), {}, VtkCoding::zlib);
  const std::size_t bytes = packed.find(">_") + 2;
  for (std::size_t i = 0; i < 64; ++i) packed[bytes + 32 + i] = 'x';
  EXPECT_NE(message_of(packed).find("expected"), std::string::npos);
}

TEST(VtkFile, codings_have_names) {
  for (const std::string& name : vtk_coding_names()) EXPECT_NO_THROW(vtk_coding_of(name));
  EXPECT_THROW(vtk_coding_of("base64"), std::invalid_argument);
}

}  // namespace keyblock::formats::vtk_file_test
