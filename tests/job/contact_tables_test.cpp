// Tables of contacts that would grow too long have every n-th frame, and a note about it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "job/run_folder.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::contact_tables_test {
namespace {

/// Counts the lines of contacts.csv with its heading, after `written` frames of one contact each, if `expected` frames
/// were announced.
std::size_t lines_with(ContactTables which, int expected, int written, int& thinned) {
  const std::string out = support::fresh_folder("contact_tables") + "/out";
  RunFolder folder(out, Overwrite::no, Trace::no);
  folder.begin();
  folder.choose_contacts({which, 1, {}, expected});
  Frame frame;
  for (frame.step = 0; frame.step < written; ++frame.step) folder.add(frame, {}, {ContactFrame{}});
  thinned = folder.frame_tables().thinned_every();
  folder.write_checkpoint({});  // writes the rows that wait
  const std::string text = support::read_text(out + "/contacts.csv");
  return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

}  // namespace

TEST(ContactTables, up_to_the_limit_all_frames_are_there) {
  int thinned = 0;
  EXPECT_EQ(lines_with(ContactTables::automatic, static_cast<int>(kMostContactRows), 12, thinned), 13U);
  EXPECT_EQ(thinned, 1);
}

TEST(ContactTables, beyond_it_every_so_manieth_is) {
  int thinned = 0;
  EXPECT_EQ(lines_with(ContactTables::automatic, 3 * static_cast<int>(kMostContactRows) - 1, 12, thinned), 5U);
  EXPECT_EQ(thinned, 3) << "frames 0, 3, 6 and 9";
}

TEST(ContactTables, all_means_all) {
  int thinned = 0;
  EXPECT_EQ(lines_with(ContactTables::all, 3 * static_cast<int>(kMostContactRows), 12, thinned), 13U);
  EXPECT_EQ(thinned, 1);
}

}  // namespace keyblock::contact_tables_test
