// A checked job: counts and outcome in its row, faults reported and not thrown, paths as in the archive.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/batch/batch_check.hpp"

#include <gtest/gtest.h>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::study::batch_check_test {
namespace {

// A triangle fixed at a point, and one block material.
const std::string kLines = "0.001\n3 0\n0\n0\n1\n0\n0\n0\n0 0 2 0 1\n2 0 1 2 1\n1 2 0 0 1\n1 0.2 1 0.2\n";
const std::string kControls = "1\n10\n1\n1\n0.01\n0.1\n2 20 1e6 0.2\n0 0 0\n0 0 0\n0 0 0\n30 0 0\n";

class BatchCheck : public ::testing::Test {
 protected:
  BatchCheck() : root_(support::fresh_folder("batch_check")) {
    support::write_text(root_ / "a.geo", kLines);
    support::write_text(root_ / "a.ana", kControls);
  }

  report::CatalogueRow check(CheckDepth depth = CheckDepth::plan) const {
    return check_job(root_, {"a.geo", {"a.geo", "a.ana"}, JobKind::whole, "the same name"}, {}, depth, "legacy");
  }

  std::filesystem::path root_;
};

}  // namespace

TEST_F(BatchCheck, a_sound_job_has_its_counts_and_a_picture) {
  for (const CheckDepth depth : {CheckDepth::scene, CheckDepth::plan}) {
    const report::CatalogueRow row = check(depth);
    EXPECT_EQ(row.outcome, "ok") << row.message;
    EXPECT_EQ(row.blocks, 1);
    EXPECT_EQ(row.steps, 10);
    EXPECT_EQ(row.paired_by, "the same name");
    EXPECT_NE(row.thumbnail.find("<svg"), std::string::npos);
  }
}

TEST_F(BatchCheck, a_fault_is_told_under_the_path_of_the_archive_with_what_is_known) {
  support::write_text(root_ / "a.ana", "1\n10\n1\nx\n");
  const report::CatalogueRow row = check();
  EXPECT_EQ(row.outcome, "failed");
  EXPECT_TRUE(row.message.starts_with("a.ana:4:1: error: expected")) << row.message;
  EXPECT_EQ(row.blocks, 1) << "the drawing is sound";
}

TEST_F(BatchCheck, the_first_warning_is_the_message_of_a_job_that_goes) {
  support::write_text(root_ / "a.ana", kControls + "and a note\n");
  const report::CatalogueRow row = check();
  EXPECT_EQ(row.outcome, "warnings");
  EXPECT_EQ(row.warnings, 1);
  EXPECT_NE(row.message.find("[trailing_text]"), std::string::npos) << row.message;
}

TEST_F(BatchCheck, files_fit_together_where_they_can_be_read_so_and_count_the_same) {
  const BatchFile geometry{"a.geo", FileRole::geometry, "dda-geometry", std::nullopt};
  const BatchFile analysis{"a.ana", FileRole::analysis, "dda-analysis-berkeley", std::nullopt};
  EXPECT_TRUE(fit_together(root_, geometry, analysis));
  support::write_text(root_ / "a.geo", "x");
  EXPECT_FALSE(fit_together(root_, geometry, analysis));
}

}  // namespace keyblock::study::batch_check_test
