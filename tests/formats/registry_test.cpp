// A file is recognised by its content, and an unknown one is refused by name.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/registry.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/formats/reading.hpp"

namespace keyblock::formats::registry_test {
namespace {

std::string recognised(const std::string& text) {
  return std::string(recognise({"f", text}).format->name);
}

}  // namespace

TEST(Registry, names_of_formats_are_unique_and_found) {
  std::set<std::string_view> all;
  for (const Format* format : all_formats()) {
    EXPECT_TRUE(all.insert(format->name).second) << format->name;
    EXPECT_EQ(find_format(format->name), format);
  }
  EXPECT_EQ(find_format("no-such-format"), nullptr);
}

TEST(Registry, every_sample_is_recognised_as_its_format_and_read) {
  for (const Format* format : all_formats()) {
    EXPECT_FALSE(format->evidence.empty()) << format->name;
    if (format->sample.empty() || !format->read) continue;
    const bool is_manifold = format->name == "nmm-analysis";
    const ReadHint hint{1, is_manifold ? 1 : 2, is_manifold ? GeometryKind::cover : GeometryKind::blocks};
    const Source source{"sample", std::string(format->sample)};
    const Choice choice = recognise(source, hint.geometry);
    EXPECT_EQ(choice.format->read, format->read) << format->name << ": " << choice.format->name;
    EXPECT_GE(choice.recognition.fit, Recognition::Fit::surplus) << format->name;
    EXPECT_NO_THROW(format->read(source, hint)) << format->name;
  }
}

TEST(Registry, evidence_says_the_numbers_that_decided) {
  const Choice choice = recognise({"f", "0.01 1 0 0 0 0 0 0 0 1 2 3 4 1"});
  EXPECT_EQ(choice.format->name, "dda-geometry");
  EXPECT_EQ(choice.recognition.evidence, "9-number head gives 14 numbers, the file has 14");
}

TEST(Registry, damaged_files_go_to_the_reader_they_resemble) {
  EXPECT_EQ(recognised("0.01 7 0 0 0"), "dda-geometry");
  EXPECT_EQ(recognised("1 50 1 1 0.01 0.001"), "dda-analysis-berkeley");
  EXPECT_EQ(recognised("0.7 50"), "dda-analysis-berkeley");
  EXPECT_EQ(recognised("2 0 16 0 0 0 1 1 4"), "dda-blocks");
  EXPECT_EQ(recognised("<DDA><Geometry>"), "ddaml");
}

TEST(Registry, other_files_are_refused_by_name) {
  EXPECT_EQ(error_of(""),
            "f: error: expected a case file or a DDA geometry, block or analysis file, found an empty file");
  EXPECT_EQ(error_of(" \r\n\t"),
            "f: error: expected a case file or a DDA geometry, block or analysis file, found nothing but white space");
  EXPECT_EQ(error_of("\xEF\xBB\xBF"),
            "f: error: expected a case file or a DDA geometry, block or analysis file, found an empty file");
  EXPECT_EQ(error_of("# only this"),
            "f: error: expected a case file or a DDA geometry, block or analysis file, found nothing but comments");
  EXPECT_EQ(error_of(std::string("0.01\n\0", 6)),
            "f:2:1: error: expected a case file or a DDA geometry, block or analysis file, found a binary file");
  EXPECT_EQ(error_of("\n<!DOCTYPE html><p>"),
            "f:2:1: error: expected a case file or a DDA geometry, block or analysis file, found an HTML page");
  EXPECT_EQ(error_of("hello"),
            "f:1:1: error: expected a case file or a DDA geometry, block or analysis file, found \"hello\"");
  for (const std::string& text : {std::string("\xFF\xFE{\0", 4), std::string("\xFE\xFF\0{", 4)})
    EXPECT_EQ(error_of(text),
              "f: error: expected a case file or a DDA geometry, block or analysis file, found text in UTF-16; save it "
              "as UTF-8");
  EXPECT_EQ(error_of("<other/>"), "f:1:2: error: expected the root element DDA of a DDAML file, found other");
}

TEST(Registry, relatives_that_are_not_read_yet_are_named) {
  EXPECT_EQ(recognised("#!0xDDA-v1.5\n1 2 3"), "dda-extended");
  EXPECT_NE(error_of("#!0xDDA-v1.5").find("recognised, not yet read"), std::string::npos);
  EXPECT_EQ(recognised("1 0.25 0.5 100"), "disk-dda");
  EXPECT_EQ(recognised("0.7 10 1 1 .01 .1 500  .1 0 -1 10 .2  0 0 0 0 0 0 0 0 0  30 0 0  1.5 0 0 0\npen=1"),
            "nmm-analysis");
}

TEST(Registry, a_deck_of_udec_is_named) {
  EXPECT_EQ(recognised("; a slope\nnew\nround 0.01\nBlock 0 0 0 10 10 10 10 0\nJSET 45,0 20,0 0,0 2,0\n"), "udec-deck");
  EXPECT_EQ(recognised("block size 0.5\nprop mat 1 d 2600\n"), "udec-deck");
  EXPECT_NE(error_of("block 0 0 0 10 10 10 10 0\ncrack 0 5 10 5\n").find("commands of UDEC"), std::string::npos);
  EXPECT_EQ(error_of("block\nround trip\n").find("UDEC"), std::string::npos) << "words that are there by chance";
  EXPECT_EQ(error_of("property of the owner\nblock letters\n").find("UDEC"), std::string::npos);
}

TEST(Registry, missing_files_and_folders_are_input_errors) {
  EXPECT_THROW(load("/no/such/file"), InputError);
  EXPECT_THROW(load("/"), InputError);
  EXPECT_THROW(load("/dev/zero"), InputError);
}

}  // namespace keyblock::formats::registry_test
