// Writes the man page from the tables of commands and options, so that it agrees with --help.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/shell/man_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/described_options.hpp"

namespace keyblock {
namespace {

// A backslash begins a request of roff; so does a point or an apostrophe at the start of a line.
std::string escaped(std::string_view text) {
  std::string safe;
  bool begins_line = true;
  for (const char c : text) {
    if (begins_line && (c == '.' || c == '\'')) safe += "\\&";
    if (c == '\\')
      safe += "\\e";
    else if (c == '-')
      safe += "\\-";
    else
      safe += c;
    begins_line = c == '\n';
  }
  return safe;
}

std::string entry(const CLI::Option& of_program) {
  const DescribedOption option = described(of_program);
  const std::string name = option.names.empty() ? option.placeholder : fmt::format("{}", fmt::join(option.names, ", "));
  const std::string value = option.names.empty() || !option.takes_value ? ""
                            : option.words.empty() ? fmt::format(" \\fI{}\\fR", escaped(option.value))
                                                   : " " + escaped(option.value);
  return fmt::format(".TP\n\\fB{}\\fR{}\n{}\n", escaped(name), value, escaped(sentence_of(of_program)));
}

std::string options_of(const CLI::App& app) {
  std::string text;
  for (const CLI::Option* option : app.get_options())
    if (!option->get_group().empty()) text += entry(*option);  // an option without a group is internal
  return text;
}

constexpr const char* kExitCodes =
    ".SH EXIT STATUS\n"
    ".TP\n\\fB0\\fR\ndone\n"
    ".TP\n\\fB1\\fR\ndone, but a check failed, or the results are unreliable\n"
    ".TP\n\\fB2\\fR\nwrong command line\n"
    ".TP\n\\fB3\\fR\nunreadable or unusable input; the message names file, line and column\n"
    ".TP\n\\fB4\\fR\nnumerical failure, or results that could not be written\n"
    ".TP\n\\fB5\\fR\nlimit of time or memory reached\n"
    ".TP\n\\fB130\\fR\nstopped by the user; keyblock run \\-\\-resume continues a run\n"
    ".TP\n\\fB128 + n\\fR\nended by signal n: 137 killed, 141 output no longer read; a run can be resumed\n";

}  // namespace

std::string man_page(const CLI::App& program) {
  std::string page = fmt::format(
      ".\\\" -*- coding: utf-8 -*-\n.TH KEYBLOCK 1 \"\" \"keyblock {}\" \"User Commands\"\n"
      ".SH NAME\nkeyblock \\- discontinuous deformation analysis and the numerical manifold method\n"
      ".SH SYNOPSIS\n\\fBkeyblock\\fR \\fIcommand\\fR [\\fIoptions\\fR]\n"
      ".SH DESCRIPTION\n{}\n.SH OPTIONS\n{}.SH COMMANDS\n",
      KEYBLOCK_VERSION, escaped(program.get_description() + "."), options_of(program));
  for (const CLI::App* command : program.get_subcommands({}))
    page += fmt::format(".SS keyblock {}\n{}.\n{}.PP\n.nf\n{}.fi\n", escaped(command->get_name()),
                        escaped(command->get_description()), options_of(*command), escaped(command->get_footer()));
  return page + kExitCodes;
}

}  // namespace keyblock
