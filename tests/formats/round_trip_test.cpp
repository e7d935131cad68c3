// The contents of every format come back from their text unchanged: some hundreds per format, drawn at random.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "formats/registry.hpp"
#include "tests/support/random_contents.hpp"

namespace keyblock::support::round_trip_test {
namespace {

constexpr int kContentsAFormat = 300;  // the program format_round_trips of tests/validate draws 10,000

}  // namespace

TEST(RoundTrip, contents_drawn_at_random_come_back_unchanged) {
  for (const ContentKind& kind : content_kinds())
    for (int seed = 0; seed < kContentsAFormat; ++seed) {
      Dice dice(static_cast<std::uint64_t>(seed));
      ASSERT_EQ(round_trip_fault(kind, kind.draw(dice)), "") << kind.format->name << ", seed " << seed;
    }
}

TEST(RoundTrip, every_format_that_is_written_is_drawn) {
  for (const formats::Format* format : formats::all_formats()) {
    bool is_drawn = false;
    for (const ContentKind& kind : content_kinds()) is_drawn = is_drawn || kind.format == format;
    EXPECT_EQ(is_drawn, format->write && format->read) << format->name;
  }
}

TEST(RoundTrip, a_number_that_changes_on_the_way_is_found) {
  ContentKind kind = content_kinds().front();
  Dice dice(1);
  formats::Content content = kind.draw(dice);
  content.drawing->bolts.push_back({{{0, 0}, {1, 0}}, 1, 2, 3, 7, {}});  // a type, which native files do not hold
  EXPECT_NE(round_trip_fault(kind, content), "");
}

}  // namespace keyblock::support::round_trip_test
