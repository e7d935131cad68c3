// `keyblock shell`: prints bash completion and the man page, made from the program's tables of options.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <memory>

#include "app/command.hpp"
#include "app/option_checks.hpp"
#include "app/shell/bash_completion.hpp"
#include "app/shell/man_page.hpp"

namespace keyblock {

Action configure_shell(CLI::App& options) {
  const auto what = std::make_shared<std::string>();
  options.add_option("WHAT", *what, "man: man page; bash: completion script for commands and options")
      ->required()
      ->check(one_word_of({"man", "bash"}));
  return [what, &options] {
    const CLI::App& program = *options.get_parent();
    fmt::print("{}", *what == "man" ? man_page(program) : bash_completion(program));
    return ExitCode::ok;
  };
}

}  // namespace keyblock
