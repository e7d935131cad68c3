// Ends the program with one clear sentence on a processor without the instructions that it was compiled for.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <string_view>

#ifdef KEYBLOCK_CHECKS_PROCESSOR
namespace {

// Runs before all other code of the program: constructors with lower numbers belong to the compiler. Code shared with
// other files must not be used here.
[[gnu::constructor(101)]] void require_processor() {
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2")) return;
  constexpr std::string_view kSentence =
      "keyblock: error: expected a processor with AVX2 and FMA (x86-64-v3, since about 2013), found one without; "
      "compile with -DKEYBLOCK_ARCH=x86-64\n";
  constexpr int kUsage = 2;
  const ssize_t written = write(STDERR_FILENO, kSentence.data(), kSentence.size());
  _exit(written < 0 ? 1 : kUsage);
}

}  // namespace
#endif
