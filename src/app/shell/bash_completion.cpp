// Writes a script for bash from the tables of commands and options.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/shell/bash_completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/described_options.hpp"

namespace keyblock {
namespace {

std::string names_of(const std::vector<DescribedOption>& options) {
  std::string names;
  for (const DescribedOption& option : options)
    for (const std::string& name : option.names) names += (names.empty() ? "" : " ") + name;
  return names;
}

/// Returns "--log|--color": options before a command whose value is the next word.
std::string names_with_value(const std::vector<DescribedOption>& options) {
  std::vector<std::string> names;
  for (const DescribedOption& option : options)
    if (option.takes_value) names.insert(names.end(), option.names.begin(), option.names.end());
  return names.empty() ? "''" : fmt::format("{}", fmt::join(names, "|"));
}

/// Returns "run,--field) words=\"sxx syy\" ;;": values from a list of words.
std::string values_of(const std::string& command, const std::vector<DescribedOption>& options) {
  std::string cases;
  for (const DescribedOption& option : options) {
    if (option.words.empty()) continue;
    for (const std::string& name : option.names)
      cases += fmt::format("    {},{}) words=\"{}\" ;;\n", command, name, fmt::join(option.words, " "));
  }
  return cases;
}

/// Returns the words of arguments without a name: the kinds of `new`.
std::string words_of(const std::vector<DescribedOption>& options) {
  for (const DescribedOption& option : options)
    if (option.names.empty() && !option.words.empty()) return fmt::format("{}", fmt::join(option.words, " "));
  return {};
}

constexpr const char* kScript = R"(# bash completion of keyblock, written by `keyblock shell bash`
_keyblock() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} command="" word i
  local commands="{}" options="{}" words=""
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case "${{COMP_WORDS[i]}}" in {}) ((++i)); continue ;; esac
    for word in $commands; do
      if [[ $word == "${{COMP_WORDS[i]}}" ]]; then command=$word; break 2; fi
    done
  done
  case "$command,$previous" in
{}  esac
  if [[ -n $words ]]; then
    COMPREPLY=($(compgen -W "$words" -- "$current"))
    return
  fi
  case "$command" in
{}  esac
  if [[ $current == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$current"))
  elif [[ -z $command ]]; then
    COMPREPLY=($(compgen -W "$commands" -- "$current"))
  elif [[ -n $words ]]; then
    COMPREPLY=($(compgen -W "$words" -- "$current"))
  else
    COMPREPLY=($(compgen -f -- "$current"))
  fi
}}
complete -o filenames -F _keyblock keyblock
)";

}  // namespace

std::string bash_completion(const CLI::App& program) {
  std::string commands, values, cases;
  for (const CLI::App* command : program.get_subcommands({})) {
    const std::vector<DescribedOption> options = described_options(*command);
    const std::string& name = command->get_name();
    commands += (commands.empty() ? "" : " ") + name;
    values += values_of(name, options);
    cases += fmt::format("    {}) options+=\" {}\"; words=\"{}\" ;;\n", name, names_of(options), words_of(options));
  }
  const std::vector<DescribedOption> own = described_options(program);
  return fmt::format(kScript, commands, names_of(own), names_with_value(own), values, cases);
}

}  // namespace keyblock
