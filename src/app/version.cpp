// `keyblock version`: prints version, commit and compiler.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/version.hpp"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "app/command.hpp"
#include "base/bytes/source_facts.hpp"

namespace keyblock {
std::string version_words() {
  return fmt::format("keyblock {}, commit {}, {}", KEYBLOCK_VERSION, source_commit(), compiler_words());
}

Action configure_version(CLI::App& options) {
  const auto as_json = std::make_shared<bool>(false);
  options.add_flag("--json", *as_json, "print as JSON");
  return [as_json] {
    const nlohmann::ordered_json json = {
        {"version", KEYBLOCK_VERSION}, {"commit", source_commit()}, {"compiler", compiler_words()}};
    fmt::print("{}\n", *as_json ? json.dump() : version_words());
    return ExitCode::ok;
  };
}

}  // namespace keyblock
