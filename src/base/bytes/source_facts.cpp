// The commit comes from a source file that the build makes by cmake/source_commit.cmake.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/bytes/source_facts.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

namespace keyblock {

extern const char* const kSourceCommit;

std::string source_commit() {
  const std::string commit = kSourceCommit;
  return commit.empty() ? "unknown" : commit;
}

std::string compiler_words() {
#if defined(__clang__)
  return fmt::format("clang++ {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#elif defined(__GNUC__)
  return fmt::format("g++ {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#else
  return "unknown compiler";
#endif
}

std::vector<std::string> words_of_command() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin < text.size(); begin = text.find('\0', begin) + 1)
    words.emplace_back(text.c_str() + begin);
  return words;
}

}  // namespace keyblock
