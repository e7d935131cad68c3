// Pairing by name, by number, by folder and by counts; files left alone.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/batch/batch_pairs.hpp"

#include <gtest/gtest.h>

namespace keyblock::study::batch_pairs_test {
namespace {

using Strings = std::vector<std::string>;

const FitCounts kDda{false, 1, 1, 0};
const FitCounts kManifold{true, 1, 1, 0};

BatchFile geometry(const std::string& path, const std::optional<FitCounts>& counts = kDda) {
  return {path, FileRole::geometry, "dda-geometry", counts};
}

BatchFile analysis(const std::string& path, const std::optional<FitCounts>& counts = kDda) {
  return {path, FileRole::analysis, "dda-analysis-berkeley", counts};
}

BatchFile unreadable(const std::string& path) {
  return {path, FileRole::unreadable, "", std::nullopt};
}

bool never(const BatchFile&, const BatchFile&) {
  return false;
}

/// Returns each job as "geometry + analysis: reason".
Strings jobs_of(const std::vector<BatchFile>& files, const FitsTogether& fits = never) {
  Strings texts;
  for (const BatchJob& job : pair_files(files, fits)) {
    std::string text;
    for (const std::string& file : job.files) text += (text.empty() ? "" : " + ") + file;
    texts.push_back(text + ": " + job.paired_by);
  }
  return texts;
}

}  // namespace

TEST(BatchPairs, files_of_one_name_in_one_folder_belong_together) {
  EXPECT_EQ(jobs_of({geometry("a/x.geo"), analysis("a/x.ana"), geometry("b/x.geo"), analysis("b/X.ANA")}),
            (Strings{"a/x.geo + a/x.ana: the same name", "b/x.geo + b/X.ANA: the same name"}));
}

TEST(BatchPairs, a_cover_never_goes_with_an_analysis_of_blocks) {
  EXPECT_EQ(jobs_of({geometry("a1", kManifold), analysis("c1")}).size(), 2U);
  EXPECT_EQ(jobs_of({geometry("x.cv", kManifold), analysis("x.ana", kDda), analysis("y.mf", kManifold)}),
            (Strings{"x.ana: an analysis alone",
                     "x.cv + y.mf: counts that fit nothing else: 1 block materials, 1 joint materials, 0 loading "
                     "points"}));
}

TEST(BatchPairs, the_same_name_in_another_folder_is_another_case) {
  EXPECT_EQ(jobs_of({geometry("a/x.geo"), analysis("b/x.ana")}),
            (Strings{"a/x.geo: a geometry alone", "b/x.ana: an analysis alone"}));
}

TEST(BatchPairs, a_drawing_and_its_blocks_share_the_analyses_of_their_name) {
  const auto jobs = pair_files({geometry("x.geo"), geometry("x.blk"), analysis("x.ana"), analysis("x.df")}, never);
  Strings names;
  for (const BatchJob& job : jobs) names.push_back(job.name);
  EXPECT_EQ(names, (Strings{"x.blk+x.ana", "x.blk+x.df", "x.geo+x.ana", "x.geo+x.df"}));
}

TEST(BatchPairs, names_that_differ_in_their_beginning_belong_together) {
  EXPECT_EQ(
      jobs_of({geometry("cv07", kManifold), geometry("cvUniaxialCompression07", kManifold), analysis("mf07", kManifold),
               geometry("blck3"), analysis("df3")}),
      (Strings{"blck3 + df3: the same name after its beginning (3)",
               "cv07 + mf07: the same name after its beginning (07)", "cvUniaxialCompression07: a geometry alone"}));
}

TEST(BatchPairs, numbers_in_names_pair_where_one_geometry_and_one_analysis_have_them) {
  EXPECT_EQ(jobs_of({geometry("slope 1"), geometry("slope 2"), analysis("input1.txt"), analysis("input2.txt")}),
            (Strings{"slope 1 + input1.txt: the same numbers in the names (1)",
                     "slope 2 + input2.txt: the same numbers in the names (2)"}));
  EXPECT_EQ(jobs_of({geometry("a1"), geometry("b1"), analysis("c1")}).size(), 3U);
}

TEST(BatchPairs, the_only_two_left_in_a_folder_belong_together) {
  EXPECT_EQ(jobs_of({geometry("f/model"), analysis("f/input"), geometry("f/x.geo"), analysis("f/x.ana")}),
            (Strings{"f/model + f/input: the only geometry and analysis left in the folder",
                     "f/x.geo + f/x.ana: the same name"}));
}

TEST(BatchPairs, counts_decide_where_they_leave_no_choice) {
  const FitCounts loaded{false, 1, 1, 2};
  const std::vector<BatchFile> files{geometry("alpha", kDda), geometry("beta", loaded), analysis("gamma", loaded),
                                     analysis("delta", kDda)};
  const Strings jobs = jobs_of(files);
  ASSERT_EQ(jobs.size(), 2U);
  EXPECT_TRUE(jobs[0].starts_with("alpha + delta: counts that fit nothing else")) << jobs[0];
  EXPECT_TRUE(
      jobs[1].starts_with("beta + gamma: counts that fit nothing else: 1 block materials, 1 joint materials, 2"));
  EXPECT_EQ(jobs_of({geometry("alpha"), geometry("beta"), analysis("gamma")}).size(), 3U);
}

TEST(BatchPairs, an_analysis_that_cannot_be_read_alone_is_tried_with_each_geometry) {
  const auto fits = [](const BatchFile& g, const BatchFile&) { return g.path == "beta"; };
  const Strings jobs = jobs_of({geometry("alpha"), geometry("beta"), analysis("gamma", std::nullopt)}, fits);
  ASSERT_EQ(jobs.size(), 2U);
  EXPECT_TRUE(jobs[1].starts_with("beta + gamma"));
}

TEST(BatchPairs, one_geometry_goes_with_every_analysis_of_its_folder) {
  EXPECT_EQ(jobs_of({geometry("a/slope.geo"), analysis("a/run1.ana"), analysis("a/run2.ana")}),
            (Strings{"a/slope.geo + a/run1.ana: counts that fit nothing else: 1 block materials, 1 joint materials, 0 "
                     "loading points",
                     "a/slope.geo + a/run2.ana: counts that fit nothing else: 1 block materials, 1 joint materials, 0 "
                     "loading points"}));
  EXPECT_EQ(jobs_of({geometry("slope.geo"), analysis("slope.ana"), analysis("dry.ana", std::nullopt)}),
            (Strings{"slope.geo + dry.ana: the only geometry in the folder", "slope.geo + slope.ana: the same name"}));
  const auto jobs = pair_files({geometry("x.geo"), analysis("a.ana"), analysis("b.ana")}, never);
  ASSERT_EQ(jobs.size(), 2U);
  EXPECT_EQ(jobs[0].name, "x.geo+a.ana");
  EXPECT_EQ(jobs[1].name, "x.geo+b.ana");
}

TEST(BatchPairs, an_unreadable_file_stands_in_for_the_part_that_its_name_lacks) {
  EXPECT_EQ(jobs_of({unreadable("x.geo"), analysis("x.ana"), geometry("y.geo"), unreadable("y.ana")}),
            (Strings{"x.geo + x.ana: the same name, though one file is unreadable",
                     "y.geo + y.ana: the same name, though one file is unreadable"}));
  EXPECT_EQ(jobs_of({unreadable("x.geo"), unreadable("x.ana")}), (Strings{"x.ana: unreadable", "x.geo: unreadable"}));
}

TEST(BatchPairs, whole_cases_and_side_files_are_jobs_of_their_own) {
  const auto jobs = pair_files({{"a.json", FileRole::whole_case, "keyblock-case", std::nullopt},
                                {"b.replay", FileRole::side_file, "berkeley-replay", std::nullopt},
                                {"c.md", FileRole::foreign, "", std::nullopt}},
                               never);
  ASSERT_EQ(jobs.size(), 3U);
  EXPECT_EQ(jobs[0].kind, JobKind::whole);
  EXPECT_EQ(jobs[1].kind, JobKind::listed);
  EXPECT_EQ(jobs[2].paired_by, "other file");
}

}  // namespace keyblock::study::batch_pairs_test
