// `keyblock convert` from the command line: messages name each kind of loss, and no file appears unrequested.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::convert_messages_test {
namespace {

using support::fresh_folder;
using support::run_keyblock;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string entity(const std::string& type, const std::string& layer, const std::string& more = "") {
  return "0\n" + type + "\n8\n" + layer + "\n" + more;
}

std::string line_on(const std::string& layer) {
  return entity("LINE", layer, "10\n0\n20\n0\n11\n1\n21\n0\n");
}

std::string drawing_of(const std::string& entities) {
  return "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
}

}  // namespace

TEST(ConvertMessages, every_kind_of_skipped_entity_and_every_unknown_layer_is_named) {
  const std::string folder = fresh_folder("convert_kinds");
  support::write_text(folder + "/a.dxf",
                      drawing_of(line_on("JOINT") + line_on("fault1") + line_on("fault2") + entity("TEXT", "0") +
                                 entity("TEXT", "0") + entity("HATCH", "0") + entity("DIMENSION", "0")));
  const auto run = run_keyblock({"convert", folder + "/a.dxf", "-o", folder + "/a.json"});
  EXPECT_EQ(run.exit_code, 0);
  for (const char* part :
       {"skipped: 2 × TEXT", "skipped: 1 × HATCH", "skipped: 1 × DIMENSION", "\"fault1\"", "\"fault2\""})
    EXPECT_TRUE(contains(run.messages, part)) << part << ": " << run.messages;
}

TEST(ConvertMessages, warnings_that_differ_in_numbers_alone_are_told_once) {
  const std::string folder = fresh_folder("convert_same");
  const std::string blocks = "1 0 8\n2 0 0\n1 1 4\n1 0 0\n1 4 0\n1 4 1\n1 0 1\n1 0 0\n0 2.06 4\n0 8 2\n0 2 0.5\n";
  support::write_text(folder + "/a.blk", blocks + "0 5 0.5 0\n0 6 0.5 0\n");
  const auto run = run_keyblock({"convert", folder + "/a.blk", "-o", folder + "/a.json"});
  EXPECT_TRUE(contains(run.messages, "is left out [point_outside_blocks] (2 times)")) << run.messages;
  EXPECT_TRUE(contains(run.messages, "\n  help: move the mark into a block; check the unit of the drawing\n"));
  EXPECT_EQ(std::ranges::count(run.messages, '\n'), 2) << run.messages;
}

TEST(ConvertMessages, an_output_whose_ending_says_no_format_is_refused_with_those_that_do) {
  const std::string folder = fresh_folder("convert_ending");
  support::write_text(folder + "/a.dxf", drawing_of(line_on("JOINT")));
  const auto run = run_keyblock({"convert", folder + "/a.dxf", "-o", folder + "/a.vtk"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_TRUE(contains(run.messages,
                       "an output that ends in .json, .xml, .dxf, .geo, .blk, .ana, .df, .cv, .mf, .vtu, "
                       ".csv, found \"" +
                           folder + "/a.vtk\""))
      << run.messages;
}

TEST(ConvertMessages, no_folder_is_made_unasked) {
  const std::string folder = fresh_folder("convert_folder");
  support::write_text(folder + "/a.dxf", drawing_of(line_on("JOINT")));
  const std::string missing = folder + "/missing";
  for (const auto& run : {run_keyblock({"convert", folder + "/a.dxf", "-o", missing + "/a.json"}),
                          run_keyblock({"cut", folder + "/a.dxf", "-o", missing + "/a.blk"}),
                          run_keyblock({"joints", "--rectangle", "width=2,height=2", "-o", missing + "/a.geo"})}) {
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_TRUE(contains(run.messages, "there is no folder " + missing)) << run.messages;
  }
  EXPECT_FALSE(std::filesystem::exists(missing));
}

}  // namespace keyblock::convert_messages_test
