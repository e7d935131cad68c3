// Files of known formats without a reader: recognised by their beginnings and refused by name; similar files are left
// to others.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/berkeley/recognised_only.hpp"

#include <gtest/gtest.h>

#include "formats/text/split.hpp"
#include "tests/formats/reading.hpp"

namespace keyblock::formats::recognised_only_test {
namespace {

using Fit = Recognition::Fit;

Fit disk_fit(const std::string& text) {
  const Source source{"f", text};
  return kDiskDda.recognise_numbers(tokenise(source)).fit;
}

}  // namespace

TEST(RecognisedOnly, the_extended_file_begins_with_its_mark) {
  EXPECT_EQ(kDdaExtended.recognise({"f", "#!0xDDA-v1.5\n"}).fit, Fit::exact);
  EXPECT_EQ(kDdaExtended.recognise({"f", "\xEF\xBB\xBF#!0xDDA"}).fit, Fit::exact) << "behind a byte order mark";
  EXPECT_EQ(kDdaExtended.recognise({"f", "# 0xDDA-v1.5\n"}).fit, Fit::none);
}

TEST(RecognisedOnly, a_disk_file_begins_with_a_kind_and_two_weights) {
  EXPECT_EQ(disk_fit("2 0.25 0.5"), Fit::exact);
  EXPECT_EQ(disk_fit("3 0.25 0.5"), Fit::none);
  EXPECT_EQ(disk_fit("1 0.25 1"), Fit::none) << "an analysis has a whole number of steps and of materials";
  EXPECT_EQ(disk_fit("1 0.25"), Fit::none);
}

TEST(RecognisedOnly, both_are_refused_by_name) {
  for (const Format* format : {&kDdaExtended, &kDiskDda}) EXPECT_EQ(format->read, nullptr);
  EXPECT_NE(error_of("#!0xDDA-v1.5 1 2 3").find(kDdaExtended.title), std::string::npos);
  EXPECT_NE(error_of("1 0.25 0.5 100").find(kDiskDda.title), std::string::npos);
}

}  // namespace keyblock::formats::recognised_only_test
