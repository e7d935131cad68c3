// A slope is stable or unstable at the same strength by statics, by the search for its factor of safety and in time.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "formats/case.hpp"
#include "run/prepare.hpp"
#include "run/run.hpp"
#include "study/strength/factor_of_safety.hpp"

namespace keyblock::study::verdicts_agree_test {
namespace {

Problem scene(const std::string& name) {
  return formats::load_case({KEYBLOCK_SOURCE_DIR "/tests/run/scenes/" + name + ".json"}).problem;
}

/// Largest displacement of a block from the drawing after 0.6 s, over the width of a block of the mean area.
double way_in_time(const Problem& problem, double divided_by) {
  const Prepared prepared =
      prepare(problem, "standard", {{"slivers", "glue"}, {"joint_strength_factor", fmt::to_string(1 / divided_by)}});
  std::vector<Frame> frames;
  Observer observer;
  observer.on_frame = [&](const Frame& frame) { frames.push_back(frame); };
  EXPECT_EQ(run(prepared.scene, 1000, observer).end, RunEnd::finished);
  double area = 0;
  double way = 0;
  for (const ElementFrame& element : frames.back().elements) {
    area += element.area / static_cast<double>(frames.back().elements.size());
    way = std::max(way, length(element.displacement));
  }
  return way / std::sqrt(area);
}

}  // namespace

// Random slopes (22 and 44 blocks, two joint sets). At 1.25 the search must decide. It once followed a block of each
// for 100,000 linear solves, which slid under constant forces.
TEST(VerdictsAgree, a_slope_stands_and_moves_in_time_where_the_search_says) {
  for (const char* name : {"slope_of_23_blocks", "slope_of_44_blocks"}) {
    SCOPED_TRACE(name);
    const Problem problem = scene(name);
    SearchOptions options;
    options.within = 0.004;
    const FactorOfSafety found =
        factor_of_safety({configured_under("standard", {}, problem, {{"slivers", "glue"}}), Reduced::joints}, options);
    ASSERT_EQ(found.end, SearchEnd::bracketed);
    EXPECT_LT(way_in_time(problem, 0.99 * *found.bracket.stands), 1e-3) << "stable at " << *found.bracket.stands;
    EXPECT_GT(way_in_time(problem, 1.01 * *found.bracket.falls), 3e-3) << "unstable at " << *found.bracket.falls;
  }
}

}  // namespace keyblock::study::verdicts_agree_test
