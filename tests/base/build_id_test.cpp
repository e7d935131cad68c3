// The hash of the sources of this build.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/bytes/build_id.hpp"

#include <gtest/gtest.h>

namespace keyblock::build_id_test {

TEST(BuildId, is_a_hash_that_stands_in_the_program) {
  const std::string id = build_id();
  EXPECT_EQ(id.size(), 40U) << "SHA-1";
  EXPECT_EQ(id.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(id, build_id());
}

}  // namespace keyblock::build_id_test
