// `keyblock version`: prints version and commit. Only this file knows the commit, so that no other is rebuilt for a new
// one.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/version.hpp"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "app/command.hpp"

namespace keyblock {
namespace {

std::string compiler_words() {
#if defined(__clang__)
  return fmt::format("clang++ {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#elif defined(__GNUC__)
  return fmt::format("g++ {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#else
  return "unknown compiler";
#endif
}

}  // namespace

std::string version_words() {
  const std::string commit = KEYBLOCK_COMMIT;
  return fmt::format("keyblock {}{}, {}", KEYBLOCK_VERSION, commit.empty() ? "" : ", commit " + commit,
                     compiler_words());
}

Action configure_version(CLI::App& options) {
  const auto as_json = std::make_shared<bool>(false);
  options.add_flag("--json", *as_json, "print as JSON");
  return [as_json] {
    const nlohmann::ordered_json json = {
        {"version", KEYBLOCK_VERSION}, {"commit", KEYBLOCK_COMMIT}, {"compiler", compiler_words()}};
    fmt::print("{}\n", *as_json ? json.dump() : version_words());
    return ExitCode::ok;
  };
}

}  // namespace keyblock
