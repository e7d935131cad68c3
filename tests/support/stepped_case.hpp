// Prepares the text of a case for a test that steps it. Tests run side by side, each with a file of its own.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "formats/case.hpp"
#include "run/prepare.hpp"
#include "run/steppers.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::support {

/// Returns a file that no other test has.
inline std::string own_file() {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  return testing::TempDir() + test.test_suite_name() + "_" + test.name() + ".json";
}

/// Returns the stepper of the first step under the profile standard. Throws InputError.
inline std::unique_ptr<Stepper> stepper_of(const std::string& text) {
  const std::string file = own_file();
  write_text(file, text);
  return stepper_for(prepare(formats::load_case({file}).problem, "standard", {}).scene);
}

/// Returns the error with which the case is refused; empty if it is taken.
inline std::string fault_of(const std::string& text) {
  try {
    stepper_of(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace keyblock::support
