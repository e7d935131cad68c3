// Files are written whole or not at all, only over files that may be overwritten, and never over an input.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/files.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <functional>

#include "base/error.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::files_test {
namespace {

namespace fs = std::filesystem;
using support::fresh_folder;
using support::read_text;
using support::write_text;

/// The text of a UsageError; empty if there is none.
std::string complaint(const std::function<void()>& about) {
  try {
    about();
  } catch (const UsageError& error) {
    return error.what();
  }
  return {};
}

std::size_t files_in(const std::string& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

unsigned permissions(const std::string& file) {
  return static_cast<unsigned>(fs::status(file).permissions());
}

/// Files of a folder: a geometry, an analysis beside it, and names that are free.
struct Files {
  std::string folder = fresh_folder("files");
  std::string input = folder + "/in.geo", other = folder + "/in.ana", free = folder + "/out.csv";

  Files() {
    write_text(input, "geometry");
    write_text(other, "analysis");
  }
};

using Writer = std::function<void(const fs::path&, const std::string&, Overwrite)>;
const std::vector<Writer> kWriters{
    [](const fs::path& file, const std::string& text, Overwrite overwrite) { write_file(file, text, overwrite); },
    write_durably, write_output};

}  // namespace

TEST(Files, a_file_is_written_whole_and_leaves_no_draft) {
  std::string bytes("binary\0\r\n\xff", 10);
  bytes.append(100'000, 'x');
  for (const Writer& write : kWriters) {
    const Files files;
    write(files.free, bytes, Overwrite::no);
    EXPECT_EQ(read_text(files.free), bytes);
    write(files.free, "", Overwrite::yes);
    EXPECT_EQ(read_text(files.free), "");
    EXPECT_EQ(files_in(files.folder), 3U);
  }
}

TEST(Files, what_is_there_is_overwritten_on_demand_alone) {
  for (const Writer& write : kWriters) {
    const Files files;
    EXPECT_NE(complaint([&] { write(files.input, "new", Overwrite::no); }), "");
    EXPECT_EQ(read_text(files.input), "geometry");
    EXPECT_EQ(files_in(files.folder), 2U) << "no draft is left";
    write(files.input, "new", Overwrite::yes);
    EXPECT_EQ(read_text(files.input), "new");
  }
}

TEST(Files, a_file_that_is_replaced_keeps_its_permissions) {
  for (const Writer& write : kWriters) {
    const Files files;
    fs::permissions(files.input, fs::perms(0640));
    write(files.input, "new", Overwrite::yes);
    EXPECT_EQ(permissions(files.input), 0640U);
  }
}

TEST(Files, a_folder_that_is_gone_is_told) {
  for (const Writer& write : kWriters) {
    const std::string file = fresh_folder("files") + "/none/out.csv";
    for (const Overwrite overwrite : {Overwrite::no, Overwrite::yes}) {
      EXPECT_THROW(write(file, "text", overwrite), OutputError);
    }
  }
  EXPECT_THROW(flush_to_disk(fresh_folder("files") + "/none"), OutputError);
}

// A link is replaced; if the user named it as an output, the file behind it is.
TEST(Files, links_are_replaced_or_followed) {
  for (const bool is_output : {false, true}) {
    const Files files;
    const std::string link = files.folder + "/link.csv";
    fs::create_symlink("in.geo", link);
    is_output ? write_output(link, "new", Overwrite::yes) : write_file(link, "new");
    EXPECT_EQ(fs::is_symlink(fs::symlink_status(link)), is_output);
    EXPECT_EQ(read_text(link), "new");
    EXPECT_EQ(read_text(files.input), is_output ? "new" : "geometry");
    EXPECT_EQ(files_in(files.folder), 3U);
  }
}

TEST(Files, only_drafts_of_this_program_are_removed) {
  const Files files;
  write_text(files.folder + "/.keyblock_draft_12_0", "half");
  write_text(files.folder + "/keyblock_draft_12_0", "a file of the user");
  remove_drafts(files.folder);
  EXPECT_FALSE(fs::exists(files.folder + "/.keyblock_draft_12_0"));
  EXPECT_EQ(files_in(files.folder), 3U);
  EXPECT_NO_THROW(remove_drafts(files.folder + "/none"));
}

TEST(Files, a_name_is_taken_by_a_file_a_folder_or_a_link_to_nothing) {
  const Files files;
  fs::create_symlink("nowhere", files.folder + "/link");
  for (const std::string& taken : {files.input, files.folder, files.folder + "/link"}) {
    EXPECT_EQ(complaint([&] { require_free(taken, Overwrite::no); }),
              taken + " exists; give another name, or --force to overwrite it");
    EXPECT_NO_THROW(require_free(taken, Overwrite::yes));
  }
  EXPECT_NO_THROW(require_free(files.free, Overwrite::no));
  EXPECT_EQ(overwrite_if(true), Overwrite::yes);
  EXPECT_EQ(overwrite_if(false), Overwrite::no);
}

TEST(Files, an_output_is_no_input_under_another_name) {
  const Files files;
  fs::create_symlink("in.geo", files.folder + "/link.geo");
  fs::create_hard_link(files.input, files.folder + "/hard.geo");
  for (const std::string name : {"/in.geo", "/./in.geo", "/link.geo", "/hard.geo"}) {
    const std::string output = files.folder + name;
    EXPECT_EQ(complaint([&] { require_writable({output}, {files.input}, Overwrite::yes); }),
              output + " is an input; give another name");
  }
  EXPECT_NO_THROW(require_writable({files.other}, {files.input}, Overwrite::yes));
}

// All files of a case folder count as inputs, except those that commands write there.
TEST(Files, files_of_a_case_folder_are_inputs_except_pictures_and_settings) {
  const Files files;
  EXPECT_NE(complaint([&] { require_writable({files.other}, {files.folder}, Overwrite::yes); }), "");
  for (const std::string name : {"/a.svg", "/a.settings", "/a.html"}) {
    write_text(files.folder + name, "old");
    EXPECT_NO_THROW(require_writable({files.folder + name}, {files.folder}, Overwrite::yes));
    EXPECT_NE(complaint([&] { require_writable({files.folder + name}, {files.folder}, Overwrite::no); }), "");
  }
}

TEST(Files, no_two_outputs_have_one_place) {
  const Files files;
  fs::create_directory_symlink(".", files.folder + "/again");
  const std::string twice = files.folder + "/again/out.csv";
  EXPECT_EQ(complaint([&] {
              require_writable({files.free, twice}, {}, Overwrite::yes);
            }),
            twice + " is named for two outputs; give one another name");
  EXPECT_NO_THROW(require_writable({files.free, {}, {}, files.folder + "/out2.csv"}, {}, Overwrite::no));
}

TEST(Files, outputs_need_a_folder_and_replace_files_alone) {
  const Files files;
  EXPECT_EQ(complaint([&] { require_writable({files.folder + "/none/out.csv"}, {}, Overwrite::yes); }),
            "there is no folder " + files.folder + "/none for out.csv");
  EXPECT_EQ(complaint([&] { require_writable({files.folder}, {}, Overwrite::yes); }),
            files.folder + " is no regular file");
  fs::create_symlink("nowhere", files.folder + "/link");
  EXPECT_EQ(complaint([&] { require_writable({files.folder + "/link"}, {}, Overwrite::yes); }),
            files.folder + "/link is a link to nothing");
}

TEST(Files, results_do_not_go_where_an_input_lies) {
  const Files files;
  fs::create_directory(files.folder + "/below");
  EXPECT_EQ(complaint([&] { require_not_below(files.input, files.folder); }),
            files.input + " lies in the folder for the results; give another folder");
  EXPECT_NE(complaint([&] { require_not_below(files.input, files.folder + "/below/.."); }), "");
  EXPECT_NO_THROW(require_not_below(files.input, files.folder + "/below"));
  EXPECT_NO_THROW(require_not_below(files.input, files.folder + "/not_yet"));
}

}  // namespace keyblock::files_test
