// One thread and several threads read the same whole file.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/bytes/file_bytes.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/error.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::file_bytes_test {

TEST(FileBytes, files_of_every_size_come_whole) {
  const std::string path = (std::filesystem::path(::testing::TempDir()) / "file_bytes").string();
  for (const std::size_t size : {0, 1, 4097, 30000001}) {
    std::string text(size, ' ');
    for (std::size_t i = 0; i < size; ++i) text[i] = static_cast<char>(i * 2654435761U >> 24U);
    support::write_text(path, text);
    EXPECT_TRUE(file_bytes(path) == text) << size;
  }
  EXPECT_THROW(file_bytes(path + "_none"), InputError);
}

}  // namespace keyblock::file_bytes_test
