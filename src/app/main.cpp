// Runs the program from one table of commands; prints every error and selects the exit code.
// To add a command: 1) write `commands/NAME_command.cpp`, 2) declare its `configure_NAME` in
// command.hpp, 3) add a row to the table below, 4) run its help text in tests/commands_test.cpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/command.hpp"
#include "app/help_format.hpp"
#include "app/messages.hpp"
#include "app/version.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/printable.hpp"

namespace keyblock {
namespace {

constexpr std::array<Command, 23> kCommands{{
    {"new", "create a commented example case: slope, arch, beam, tunnel or block", configure_new,
     "keyblock new slope\nkeyblock new arch -o my_arch.json"},
    {"check", "check input files: format, contents, likely mistakes, estimated run time", configure_check,
     "keyblock check old.geo old.ana\nkeyblock check slope.json --trial 10\nkeyblock check archive"},
    {"cut", "cut a drawing into blocks, or a mesh into NMM elements and covers", configure_cut,
     "keyblock cut slope.dxf -o slope.blk --svg slope.svg\nkeyblock cut slope.dxf --mesh 20 -o slope.cv"},
    {"joints", "draw joint sets from their statistics into an outline", configure_joints,
     "keyblock joints --slope height=10,angle=60 --set dip=35,spacing=2,trace=50 -o slope.dxf"},
    {"run", "run a case and write its results into a folder", configure_run,
     "keyblock run old.geo old.ana -o out\nkeyblock run old.geo old.ana --both -o out\n"
     "keyblock run slope.json -o out --set motion=static\n"
     "keyblock run slope.json -o out --history crest=point:12,20 --history line:0,5,30,5\nkeyblock run --resume out"},
    {"plot", "draw a quantity, a step or curves of a finished run", configure_plot,
     "keyblock plot out --field s1\nkeyblock plot out --field crosses --step 200 -o crosses.svg\n"
     "keyblock plot out --curve dx1,dy1 -o crest.pdf --width 84"},
    {"report", "write one page about a run, or about a folder of runs, to hand to others", configure_report,
     "keyblock report out\nkeyblock report results -o results.html"},
    {"view", "write a finished run as one page for a browser", configure_view,
     "keyblock view out\nkeyblock view out -o slope.html"},
    {"serve", "open a window in the browser for the cases and results of a folder", configure_serve,
     "keyblock serve\nkeyblock serve archive --port 8123"},
    {"fos", "compute the factor of safety by strength reduction of joints or rock", configure_fos,
     "keyblock fos slope.json -o out\nkeyblock fos slope.json --reduce joints --to-within 0.005"},
    {"sif", "compute stress intensity factors and J at the crack tips of a case", configure_sif,
     "keyblock sif legacy_cases/stress_intensity/edge_crack_05\nkeyblock sif plate.json --json"},
    {"compare", "rerun verification cases and compare them with their reference values", configure_compare,
     "keyblock compare legacy_cases/sliding_block\nkeyblock compare legacy_cases --all --json"},
    {"tradeoff", "compare accuracy and run time over many settings", configure_tradeoff,
     "keyblock tradeoff slope.json --budget 60s\nkeyblock tradeoff slope.json --error 1e-3"},
    {"sweep", "run a case over any of its values", configure_sweep,
     "keyblock sweep block.json --over '/analysis/joint_materials/0/friction_angle_deg=10:25:5' -o sweep"},
    {"batch", "check, run or convert every case of an archive; write a catalogue", configure_batch,
     "keyblock batch archive --check -o out\nkeyblock batch archive --run --time-limit 600 -o out"},
    {"convert", "convert a case to another format; list what is lost", configure_convert,
     "keyblock convert old.geo old.ana -o case.json\nkeyblock convert slope.json -o slope.dxf"},
    {"element", "drive one element of a material along a path of strains and stresses", configure_element,
     "keyblock element case.json --path triaxial --confining 5 --to -0.02"},
    {"fit", "fit rock parameters to stress-strain curves, triaxial or toughness tests", configure_fit,
     "keyblock fit curve.csv --svg curve.svg\nkeyblock fit --triaxial tests.csv"},
    {"formats", "list the file formats, the case-file schema, the material library", configure_formats,
     "keyblock formats dxf\nkeyblock formats --schema > keyblock-case.schema.json\nkeyblock formats --materials"},
    {"info", "same as formats", configure_formats, "keyblock info dxf"},
    {"explain", "explain a warning by its code: meaning and remedy", configure_explain,
     "keyblock explain energy_beyond_limit\nkeyblock explain --json"},
    {"shell", "print the man page, or the completion script for bash", configure_shell,
     "keyblock shell man > keyblock.1\nkeyblock shell bash > keyblock.bash"},
    {"version", "print version, commit and compiler", configure_version, "keyblock version"},
}};

// CLI11 reports only that a command is missing.
void require_known(const std::string& command) {
  if (command.starts_with('-') || std::ranges::find(kCommands, command, &Command::name) != kCommands.end()) return;
  std::vector<const char*> names;
  for (const Command& known : kCommands) names.push_back(known.name);
  throw UsageError(fmt::format("there is no command \"{}\", only {}{}", command, fmt::join(names, ", "),
                               nearest_words(command, {names.begin(), names.end()})));
}

// Detects a limit such as that of `ulimit -v` or of a batch.
bool has_memory_limit() {
  rlimit limit{};
  return getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

// Returns an option that begins with the name, "--out", or the nearest; empty if no option is near.
std::string meant_by(const std::string& name, const std::vector<std::string>& known) {
  constexpr std::size_t kLeast = 4;  // with the hyphens
  const auto begins = [&](const std::string& option) { return name.size() >= kLeast && option.starts_with(name); };
  const auto found = std::ranges::find_if(known, begins);
  return found == known.end() ? nearest(name, known) : *found;
}

// CLI11 names only the unexpected argument.
void suggest_option(const CLI::App& program, const std::vector<std::string>& arguments) {
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  std::vector<std::string> known;
  for (const CLI::App* app : {&program, chosen.empty() ? &program : static_cast<const CLI::App*>(chosen.front())})
    for (const CLI::Option* option : app->get_options())
      for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  for (const std::string& argument : arguments) {
    const std::string name = argument.substr(0, argument.find('='));
    if (!name.starts_with("--") || std::ranges::find(known, name) != known.end()) continue;
    if (const std::string found = meant_by(name, known); !found.empty())
      spdlog::error("keyblock: there is no option {}; did you mean {}?", name, found);
  }
}

std::string with_examples(const char* examples) {
  std::string text = "Examples:\n  ";
  for (const char* c = examples; *c != 0; ++c) {
    text += *c;
    if (*c == '\n') text += "  ";
  }
  return text + "\n";
}

// Replaces `help` by --help, `help COMMAND` by the help of the command, and no arguments by `help`.
std::vector<std::string> as_asked(std::vector<std::string> arguments) {
  if (arguments.empty() || arguments == std::vector<std::string>{"help"}) return {"--help"};
  if (arguments.front() == "help") arguments = {arguments[1], "--help"};
  require_known(arguments.front());
  return arguments;
}

// Returns true for commands among the arguments; `shell` prints the options of all. Those of the others would take a
// third of the start-up time.
bool needs_options(const Command& command, const std::vector<std::string>& arguments) {
  return std::ranges::any_of(arguments, [&](std::string_view word) { return word == command.name || word == "shell"; });
}

int run_program(const std::vector<std::string>& arguments) {
  CLI::App program{
      "Keyblock: discontinuous deformation analysis (DDA) and numerical manifold method (NMM) in two dimensions"};
  program.name("keyblock");
  program.formatter(std::make_shared<HelpFormat>());
  program.set_version_flag("--version", version_words());
  program.require_subcommand(1);
  program.footer(
      "First run: keyblock new slope && keyblock run slope.json -o out. Options and examples: keyblock help COMMAND.");
  add_message_options(program);
  Action chosen;
  for (const Command& command : kCommands) {
    CLI::App* options = program.add_subcommand(command.name, command.sentence);
    options->fallthrough();
    options->footer(with_examples(command.examples));
    if (!needs_options(command, arguments)) continue;
    const auto action = std::make_shared<Action>(command.configure(*options));
    options->callback([&chosen, action] { chosen = *action; });
  }
  try {
    program.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));  // in reverse order
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) suggest_option(program, arguments);
    std::ostringstream messages;
    const bool is_help = program.exit(error, std::cout, messages) == 0;
    std::istringstream lines(messages.str());
    for (std::string line; std::getline(lines, line);) std::cerr << printable(line) << '\n';
    return static_cast<int>(is_help ? ExitCode::ok : ExitCode::usage);
  }
  const ExitCode code = chosen();
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) throw OutputError("cannot write to standard output");
  return static_cast<int>(code);
}

// If a standard stream is closed, the first opened file would receive its output. Messages are then dropped; missing
// output is an error when it is required.
void fill_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0) open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
}

// Ends the program at once: exit handlers, such as that of HDF5, crash on objects that were left half made.
[[noreturn]] void leave_out_of_memory(const char* for_what) {
  const bool is_limited = has_memory_limit();
  spdlog::error("keyblock: error: there is not enough memory for {}{}", for_what,
                is_limited ? " within the limit" : "");
  std::fflush(nullptr);
  std::_Exit(static_cast<int>(is_limited ? ExitCode::limit : ExitCode::numerical_failure));
}

int not_written(const char* program) {
  const bool is_job = program != nullptr && std::string_view(program) == kJobName;
  return is_job ? kCannotWrite : static_cast<int>(ExitCode::numerical_failure);
}

// Handles errors of the system: threads need memory, and tables are written to standard output.
int code_of(const std::system_error& error, const char* program) {
  if (error.code() == std::errc::resource_unavailable_try_again) leave_out_of_memory("another thread");
  if (std::ferror(stdout) != 0)
    spdlog::error("keyblock: error: cannot write to standard output: {}", error.code().message());
  else
    spdlog::error("keyblock: error: {}", error.what());
  const bool is_full = std::ferror(stdout) != 0 || error.code() == std::errc::no_space_on_device;
  return is_full ? not_written(program) : static_cast<int>(ExitCode::numerical_failure);
}

}  // namespace
}  // namespace keyblock

int main(int argc, char** argv) {
  keyblock::fill_closed_streams();
  // A file that grows beyond its limit gives the error of a file that cannot be written.
  std::signal(SIGXFSZ, SIG_IGN);
  keyblock::print_messages_plainly();
  try {
    return keyblock::run_program(keyblock::as_asked({argv + std::min(argc, 1), argv + argc}));
  } catch (const keyblock::InputError& error) {
    spdlog::error("{}", error.what());
    return static_cast<int>(keyblock::ExitCode::unreadable);
  } catch (const keyblock::UsageError& error) {
    spdlog::error("keyblock: error: {}", error.what());
    return static_cast<int>(keyblock::ExitCode::usage);
  } catch (const std::invalid_argument& error) {  // a wrong setting or profile of any command
    spdlog::error("keyblock: error: {}", error.what());
    return static_cast<int>(keyblock::ExitCode::usage);
  } catch (const std::filesystem::filesystem_error& error) {
    spdlog::error("{}: error: {}", error.path1().string(), error.code().message());
    const bool is_full = error.code() == std::errc::no_space_on_device;
    return is_full ? keyblock::not_written(argv[0]) : static_cast<int>(keyblock::ExitCode::usage);
  } catch (const keyblock::OutputError& error) {
    spdlog::error("keyblock: error: {}", error.what());
    return keyblock::not_written(argv[0]);
  } catch (const std::bad_alloc&) {
    keyblock::leave_out_of_memory("this");
  } catch (const std::system_error& error) {
    return keyblock::code_of(error, argv[0]);
  } catch (const std::exception& error) {
    spdlog::error("keyblock: error: {}", error.what());
    return static_cast<int>(keyblock::ExitCode::numerical_failure);
  }
}
