// The data of a page are read back: numbers to the stated rounding, epochs where bodies change, and no text that ends
// its element.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page/page_writer.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "report/page/page_bytes.hpp"
#include "tests/support/page_reading.hpp"

namespace keyblock::page_writer_test {
namespace {

using report::PageFrame;
using report::PageRowsOf;
using report::PageShape;
using report::PageWriter;
using support::ReadPage;
using support::ReadShape;

/// A square of side 4 with a hole of side 1, and a triangle to the right of it.
PageShape two_bodies() {
  PageShape shape;
  shape.key = shape.number = {7, 9};
  shape.material = {0, 2};
  shape.kind = {report::kFixedBody, report::kElementOnCovers};
  shape.loop_body = {0, 0, 1};
  shape.loop_size = {4, 4, 3};
  shape.places = {{1000, 0}, {1004, 0}, {1004, 4}, {1000, 4}, {1001, 1}, {1001, 2},
                  {1002, 2}, {1002, 1}, {1005, 0}, {1008, 0}, {1005, 3}};
  return shape;
}

/// Frame in which all points move by u + G x, x from the centre (1000, 0).
PageFrame moved(int step, double by) {
  PageFrame frame;
  frame.step = step;
  frame.time = 0.1 * step;
  frame.shape = two_bodies();
  for (const Point p : frame.shape.places)
    frame.moves.push_back({by * (1 + 0.5 * (p.x - 1000)), by * (-2 + 0.25 * p.y)});
  frame.values.push_back({{"stress", "stress", "Pa", PageRowsOf::body, {"xx", "yy", "xy", "zz"}},
                          {-1e6 * step, 2, 3, 4, 1e-40, -7.123456789, 1e300, 12345.678}});
  frame.values.push_back({{"state", "state", "", PageRowsOf::body, {}, {"elastic", "yields"}}, {0, 1.0 * (step % 2)}});
  return frame;
}

ReadPage page_of(std::vector<PageFrame> frames, nlohmann::ordered_json head = nlohmann::ordered_json::object()) {
  PageWriter writer;
  for (PageFrame& frame : frames) writer.add(std::move(frame));
  return ReadPage(std::move(writer).finish(std::move(head)));
}

TEST(PageWriter, numbers_are_rounded_to_the_bits_that_the_head_states) {
  for (const int bits : {10, 14, 23})
    for (const double value : {1.0, -3.14159265358979, 1e-20, 6.02e23, -0.999999}) {
      const std::uint32_t word = report::rounded_bits(value, bits);
      EXPECT_EQ(word & ((1U << (23 - bits)) - 1), 0U);
      EXPECT_NEAR(std::bit_cast<float>(word), value, std::ldexp(std::abs(value), -bits - 1) * 1.0001 + 0)
          << value << " to " << bits;
    }
  EXPECT_EQ(report::rounded_bits(1e-31, 10), 0U);
  EXPECT_TRUE(std::isnan(std::bit_cast<float>(report::rounded_bits(NAN, 10))));
  EXPECT_TRUE(std::isfinite(std::bit_cast<float>(report::rounded_bits(1e300, 10))));
}

TEST(PageWriter, bodies_and_their_motions_are_read_back) {
  const ReadPage page = page_of({moved(0, 0), moved(1, 1e-6), moved(2, 0.3)});
  const ReadShape shape = page.shape(0);
  EXPECT_EQ(shape.key, (std::vector<std::uint32_t>{7, 9}));
  EXPECT_EQ(shape.material, (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(shape.kind, (std::vector<std::uint32_t>{256, 1}));
  EXPECT_EQ(shape.loop_size, (std::vector<std::uint32_t>{4, 4, 3}));
  const double origin = page.head().at("origin").at(0);
  EXPECT_EQ(origin, 1004);
  // Centroid of the square without its hole: (16 * 2 - 1 * 1.5) / 15 from its corner.
  EXPECT_NEAR(origin + shape.centroid[0], 1000 + 30.5 / 15, 1e-6);
  EXPECT_NEAR(origin + shape.centroid[2], 1006, 1e-6);
  EXPECT_NEAR(shape.place[2 * 9], 2, 1e-6) << "the second corner of the triangle, from its centroid";
  const double by = 0.3, x = 6, y = 1;
  for (const double share : {1e-6 / 0.3, 1.0}) {
    const std::size_t frame = share == 1 ? 2 : 1;
    const double scale = share * by;
    EXPECT_NEAR(page.value("motion", 0, frame, 1), scale * (1 + 0.5 * x), scale * 4 * 4e-5);
    EXPECT_NEAR(page.value("motion", 1, frame, 1), scale * (-2 + 0.25 * y), scale * 2 * 4e-5);
    EXPECT_NEAR(page.value("motion", 2, frame, 1), scale * 0.5, scale * 0.5 * 4e-5);
    EXPECT_NEAR(page.value("motion", 3, frame, 1), 0, scale * 1e-6);
    EXPECT_NEAR(page.value("motion", 5, frame, 0), scale * 0.25, scale * 0.25 * 4e-5);
  }
  EXPECT_THROW(page.value("vertex_motion", 0, 0, 0), std::out_of_range) << "the bodies move affinely";
}

TEST(PageWriter, corners_that_move_on_their_own_get_their_displacement) {
  PageFrame bent = moved(1, 0.1);
  bent.moves[2] = bent.moves[2] + Point{0.01, -0.02};
  const Point there = bent.moves[2];
  const ReadPage page = page_of({moved(0, 0), bent});
  EXPECT_NEAR(page.value("vertex_motion", 0, 1, 2), there.x, 4e-5 * std::abs(there.x));
  EXPECT_NEAR(page.value("vertex_motion", 1, 1, 2), there.y, 4e-5 * std::abs(there.y));
}

TEST(PageWriter, fields_of_many_frames_are_read_back_across_chunks) {
  std::vector<PageFrame> frames;
  for (int step = 0; step < 60; ++step) frames.push_back(moved(step, 0.01 * step));
  const ReadPage page = page_of(std::move(frames));
  for (const std::size_t frame : {0, 24, 25, 59}) {
    EXPECT_NEAR(page.value("stress", 0, frame, 0), -1e6 * static_cast<double>(frame), 5e2 * static_cast<double>(frame));
    EXPECT_NEAR(page.value("stress", 1, frame, 1), -7.123456789, 7.2 * 5e-4);
    EXPECT_EQ(page.value("state", 0, frame, 1), frame % 2);
  }
  EXPECT_EQ(page.value("stress", 0, 3, 1), 0) << "too small for a float";
  for (const auto& chunk : page.head().at("chunks"))
    EXPECT_LT(chunk.at("to").get<int>() - chunk.at("from").get<int>(), 25);
  EXPECT_EQ(page.head().at("epochs").size(), 1U);
}

TEST(PageWriter, a_body_that_changes_begins_an_epoch_though_all_counts_stay) {
  PageFrame cut = moved(2, 0.1), later = moved(3, 0.1);
  cut.shape.places[9].x = later.shape.places[9].x = 1007;
  const ReadPage page = page_of({moved(0, 0), moved(1, 0.1), cut, later});
  ASSERT_EQ(page.head().at("epochs").size(), 2U);
  const std::vector<int> epochs{0, 0, 1, 1};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(page.head().at("frames").at(i).at("epoch"), epochs[i]);
  for (const auto& chunk : page.head().at("chunks"))
    for (int f = chunk.at("from"); f <= chunk.at("to"); ++f)
      EXPECT_EQ(chunk.at("epoch"), epochs[static_cast<std::size_t>(f)]);
  EXPECT_NE(page.shape(0).place, page.shape(1).place);
}

TEST(PageWriter, a_page_goes_on_with_frames_of_its_last_epoch_or_of_new_ones) {
  const PageFrame first = moved(0, 0);
  PageWriter same(report::origin_of(first.shape), first.shape);
  same.add(moved(5, 0.3));
  const report::PageUpdate update = std::move(same).update();
  std::size_t size = 0;
  for (const auto& own : update.head.at("sizes")) size += own.get<std::size_t>();
  EXPECT_EQ(update.head.at("frames").at(0).at("step"), 5);
  EXPECT_EQ(update.head.at("frames").at(0).at("epoch"), -1) << "the page has these bodies";
  EXPECT_TRUE(update.head.at("epochs").empty());
  EXPECT_EQ(update.head.at("chunks").size(), update.head.at("sizes").size());
  EXPECT_EQ(update.bytes.size(), size);
  EXPECT_EQ(update.head.at("sizes").at("c0"), 6 * 2 * 4) << "motion of two bodies";
  PageFrame cut = moved(6, 0.1);
  cut.shape.places[9].x = 1007;
  PageWriter changed(report::origin_of(first.shape), first.shape);
  changed.add(cut);
  const nlohmann::ordered_json other = std::move(changed).update().head;
  EXPECT_EQ(other.at("frames").at(0).at("epoch"), 0);
  EXPECT_TRUE(other.at("sizes").contains(other.at("epochs").at(0).at("geometry")));
}

TEST(PageWriter, tables_in_time_keep_the_frames_that_have_them) {
  std::vector<PageFrame> frames{moved(0, 0), moved(1, 0.1), moved(2, 0.2)};
  for (const std::size_t f : {0, 2}) {
    report::PageRows rows{"contacts", f + 1, {{"place", "m", 2, false, true}, {"state", "", 1, true, false, {"open"}}}};
    for (std::size_t i = 0; i <= f; ++i) {
      rows.columns[0].numbers.insert(rows.columns[0].numbers.end(), {1001.5, 1.0 * static_cast<double>(i)});
      rows.columns[1].numbers.push_back(static_cast<double>(i));
    }
    frames[f].parts.push_back(rows);
  }
  const ReadPage page = page_of(std::move(frames));
  const auto first = page.rows("contacts", 0), last = page.rows("contacts", 2);
  EXPECT_EQ(first.at("state"), (std::vector<double>{0}));
  EXPECT_EQ(last.at("state"), (std::vector<double>{0, 1, 2}));
  EXPECT_NEAR(last.at("place").at(4), 1001.5 - 1004, 1e-4) << "from the origin";
  EXPECT_TRUE(page.rows("contacts", 1).at("state").empty());
}

TEST(PageWriter, no_name_ends_the_element_of_the_head) {
  const std::string name = "</script><script>alert(1)</script><!--\xff";
  const ReadPage page = page_of({moved(0, 0)}, {{"title", name}});
  EXPECT_EQ(page.text().find("alert(1)</script>"), std::string::npos);
  const std::string title = page.head().at("title");
  EXPECT_TRUE(title.starts_with("</script><script>alert(1)</script><!--")) << title;
}

}  // namespace
}  // namespace keyblock::page_writer_test
