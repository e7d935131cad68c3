// Comments are counted by the rules of each format, and named at the first.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/convert/dropped_comments.hpp"

#include <gtest/gtest.h>

#include "formats/berkeley/ddaml.hpp"
#include "formats/case_file/keyblock_case.hpp"
#include "formats/dxf/dxf.hpp"
#include "formats/shi/dda_geometry.hpp"

namespace keyblock::study::dropped_comments_test {
namespace {

std::string told(const formats::Format& format, const std::string& text) {
  formats::FileReading file;
  file.path = "f";
  file.source = {"f", text};
  file.choice = formats::Choice{&format, {}};
  const auto warning = dropped_comments(file);
  return warning ? to_string(*warning) : "";
}

}  // namespace

TEST(DroppedComments, are_counted_as_each_format_has_them) {
  EXPECT_EQ(told(formats::kDdaGeometry, "0.01 # a # b\n4 4 // c\n5\n% d"),
            "f:1:6: note: 3 comments are not carried over [comments_dropped]");
  EXPECT_EQ(told(formats::kDdaml, "<DDA><!-- a\n-->\n<!----></DDA>"),
            "f:1:6: note: 2 comments are not carried over [comments_dropped]");
  EXPECT_EQ(told(formats::kKeyblockCase, "{\"a//b\": \"\\\"/*\", /* // c */\n\"d\": 1} // e"),
            "f:1:18: note: 2 comments are not carried over [comments_dropped]");
  EXPECT_EQ(told(formats::kKeyblockCase, "{}//"), "f:1:3: note: 1 comment is not carried over [comments_dropped]");
  EXPECT_EQ(told(formats::kDdaGeometry, "0.01 4 1/2"), "");
  EXPECT_EQ(told(formats::kDxf, "  0\nSECTION # 1\n"), "");
}

}  // namespace keyblock::study::dropped_comments_test
