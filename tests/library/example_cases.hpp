// Cases for tests of the public library.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <keyblock/keyblock.hpp>
#include <optional>
#include <string>

namespace keyblock::api_test {

namespace kb = keyblock::api;

inline const std::string kCases = std::string(KEYBLOCK_SOURCE_DIR) + "/legacy_cases/";

/// Returns the code of the error that `work` throws; nothing if it throws none.
template <class Work>
std::optional<kb::ErrorCode> code_of(const Work& work) {
  try {
    work();
  } catch (const kb::Error& error) {
    return error.code;
  }
  return std::nullopt;
}

/// A block on a plane of 30 degrees with a friction of 20 degrees.
inline kb::Case slide() {
  return kb::Case::read({kCases + "sliding_block/a30_p20"});
}

/// Reads a case file with this text; its name is that of the test.
inline kb::Case case_of(const std::string& text) {
  const std::string path = ::testing::TempDir() + "keyblock_api_" +
                           ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".json";
  std::ofstream(path) << text;
  return kb::Case::read({path});
}

inline std::string rectangle(double left, double bottom, double right, double top) {
  const auto corner = [](double x, double y) { return "[" + std::to_string(x) + ", " + std::to_string(y) + ", 1]"; };
  return R"({"material": 1, "outer": [)" + corner(left, bottom) + ", " + corner(right, bottom) + ", " +
         corner(right, top) + ", " + corner(left, top) + "]}";
}

/// Courses of bricks of 1 by 0.5, every other one offset by half a brick, on a floor that is fixed if `is_fixed`. The
/// floor is block 1.
inline kb::Case wall(int bricks, int courses, bool is_fixed = true) {
  std::string blocks = rectangle(-1, -1, bricks + 1, 0);
  for (int course = 0; course < courses; ++course)
    for (int i = 0; i < bricks; ++i) {
      const double left = i + (course % 2) * 0.5;
      blocks += ",\n" + rectangle(left, 0.5 * course, left + 1, 0.5 * course + 0.5);
    }
  const std::string fixed = is_fixed ? "[-0.5, -0.5, 1], [" + std::to_string(bricks) + ", -0.5, 1]" : "";
  return case_of(R"({"keyblock": 2, "units": {"length": "m", "mass": "kg", "time": "s"}, "blocks": {"blocks": [)" +
                 blocks + R"(], "fixed_points": [)" + fixed + R"(]},
    "analysis": {"step_count": 3, "time_step": "2 ms", "block_materials": [{"like": "sandstone"}],
                 "joint_materials": [{"friction_angle_deg": 30}]}})");
}

}  // namespace keyblock::api_test
