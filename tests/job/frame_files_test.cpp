// A frame whose bodies are there is whole, so that readers may take it while the run goes on.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/folder/frame_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "job/folder/folder_lock.hpp"
#include "tests/support/program.hpp"

namespace keyblock::frame_files_test {

namespace fs = std::filesystem;

TEST(FrameFiles, the_file_of_the_bodies_is_written_last) {
  const fs::path out = support::fresh_folder("frame_order");
  Frame frame;
  frame.step = 3;
  fs::create_directories(frame_part(out, "joints", frame.step) / "in the way");
  FrameFiles files(out);
  EXPECT_ANY_THROW(files.write(formats::columns_of(frame, {ContactFrame{}}), {}));
  EXPECT_TRUE(fs::exists(frame_part(out, "contacts", frame.step)));
  EXPECT_FALSE(fs::exists(frame_file(out, frame.step)));
  fs::remove_all(frame_part(out, "joints", frame.step));
  FrameFiles whole(out);
  whole.write(formats::columns_of(frame, {ContactFrame{}}), {});
  EXPECT_TRUE(fs::exists(frame_file(out, frame.step)));
  EXPECT_LT(whole.list().find("00000003.vtu"), whole.list().find("contacts_00000003.vtp"))
      << "viewers list bodies first";
}

TEST(FolderLock, is_seen_by_others_and_their_look_does_not_hinder_a_run) {
  const fs::path out = support::fresh_folder("lock");
  EXPECT_FALSE(is_locked(out));
  {
    const FolderLock lock(out);
    EXPECT_TRUE(is_locked(out));
  }
  EXPECT_FALSE(is_locked(out));
  EXPECT_FALSE(is_locked(out / "none"));
}

}  // namespace keyblock::frame_files_test
