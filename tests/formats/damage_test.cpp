// Files cut off anywhere or changed at random are read or refused with an InputError, and cause no other exception.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>

#include "formats/case.hpp"
#include "formats/case_file/joint_spec.hpp"
#include "formats/registry.hpp"
#include "formats/shi/dda_blocks.hpp"
#include "problem/checks/check.hpp"
#include "tests/formats/dxf_samples.hpp"
#include "tests/support/mutated.hpp"
#include "tests/support/two_triangles.hpp"

namespace keyblock::formats::damage_test {
namespace {

const std::string kFolder = std::string(KEYBLOCK_SOURCE_DIR) + "/tests/malformed/";
constexpr int kMutationsAFile = 3000;

std::string block_file() {
  Blocks blocks;
  blocks.blocks = {{0, {{{0, 0}, 0}, {{1, 0}, 0}, {{1, 1}, 2}, {{0, 1}, 0}}, {}},
                   {1, {{{1, 0}, 2}, {{2, 0}, 0}, {{2, 1}, 0}, {{1, 1}, 0}}, {}}};
  blocks.bolts = {{{{.5, .5}, {1.5, .5}}, 0, 1, 1e6, 2e3, 50}};
  blocks.fixed_points = {{{.5, .1}, 0, {}}};
  blocks.loading_points = {{{1.5, .9}, 1, {}}};
  return kDdaBlocks.write({{}, blocks, {}});
}

/// One sound file of each kind.
std::vector<std::string> sound_files() {
  std::vector<std::string> texts{
      block_file(),
      kDxfSample,
      "1 20 1 1 .006 .01 1e7\n0 2 2\n0 0 0 5 1 1\n0 7 7 5 8 8\n5 161 1e6 .25\n0 0 "
      "0 0 0 0 0 0 0\n30 0 0\n1.5\n",
      support::kTwoTrianglesFile,
      "1 1 1 7\n1 0 0\n0 0 0\n1 1 3\n9 9 9\n1 0 0\n1 1 0\n1 0 1\n1 0 0\n0 0 0\n0 0 0\n0 0 0\n"
      "0 0 1 0 1 1 5 6 7\n0 0 0 0\n0 .1 .1 1\n",
      "measpoint1=[\n1 .1 .1 5 6 0 0 0 0\n];\n",
      "a quake\n3\n.1 .2 .3\n",
      ".01 3\n.1\n.2\n.3\n",
      "1 5 1 1 .01 .1 50\n2 -3\n.1 0 -1 10 .2  0 0 0 0 0 0 0 0 0\n30 0 0\n1.5 0 0 0\n"};
  for (const char* name : {"00_control_xml.geo", "00_control_xml.ana", "00_control_orig.geo", "00_control_orig.ana"})
    texts.push_back(load(kFolder + name).text);
  return texts;
}

/// Reads and checks; any exception but InputError ends the test.
void read_and_check(const std::string& text) {
  try {
    check(pair({read({"f", text}, {1, 2}).content}));
  } catch (const InputError&) {
  }
}

}  // namespace

TEST(Damage, files_cut_off_at_any_byte_are_read_or_refused) {
  for (const std::string& text : sound_files())
    for (std::size_t size = 0; size < text.size(); ++size)
      ASSERT_NO_THROW(read_and_check(text.substr(0, size))) << size;
}

TEST(Damage, files_changed_at_random_are_read_or_refused) {
  std::mt19937 random(20010520);
  for (const std::string& text : sound_files())
    for (int i = 0; i < kMutationsAFile; ++i) {
      const std::string changed = support::mutated(text, random);
      ASSERT_NO_THROW(read_and_check(changed)) << changed;
    }
}

TEST(Damage, specifications_of_joint_sets_changed_at_random_are_read_or_refused) {
  const std::string sound =
      R"({"slope": {"height": 8, "angle": 70}, "tunnels": [{"shape": "d", "width": 3, "x": 5, "y": -2}],
          "sets": [{"dip": 30, "spacing": 1, "trace": 6, "scatter": 0.2, "distribution": "normal"}],
          "seed": 7, "fixed": [[0, 1, 2, 3]]})";
  ASSERT_NO_THROW(joint_scene_of(read_json({"f", sound})));
  std::mt19937 random(20010520);
  for (int i = 0; i < kMutationsAFile; ++i) {
    const std::string changed = support::mutated(sound, random);
    try {
      joint_scene_of(read_json({"f", changed}));
    } catch (const InputError&) {
    } catch (...) {
      FAIL() << changed;
    }
  }
}

TEST(Damage, every_reader_stands_every_file_of_every_kind) {
  for (const std::string& text : sound_files())
    for (const Format* format : all_formats()) {
      if (!format->read) continue;
      try {
        format->read({"f", text}, {});
      } catch (const InputError&) {
      }
    }
}

}  // namespace keyblock::formats::damage_test
