// A case without a tip is refused before its first step, where a stop would be seen.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/fracture/intensity.hpp"

#include <gtest/gtest.h>

#include <string>

#include "base/context.hpp"

namespace keyblock::study::intensity_test {
namespace {

std::string refusal(const std::string& folder) {
  const Context stopped;
  stopped.stop();
  const Under under(stopped);
  const OpenCase open = opened(asked_case({{KEYBLOCK_SOURCE_DIR "/legacy_cases/" + folder}, {}, {}, {}}));
  try {
    intensity_at_end(intensity_plan(open, open.input));
  } catch (const InputError& error) {
    return error.sentence();
  } catch (const StopRequested&) {
    return "it began its first step";
  }
  return "it was not refused";
}

}  // namespace

TEST(Intensity, a_case_without_a_tip_is_refused_before_its_first_step) {
  EXPECT_EQ(refusal("sliding_block_on_covers/a30_p20"),
            "expected the end of a crack or joint inside a body, found none");
  EXPECT_EQ(refusal("stress_intensity/edge_crack_05"), "it began its first step");
}

}  // namespace keyblock::study::intensity_test
