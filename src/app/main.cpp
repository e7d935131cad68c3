// The program: one table of commands; prints every error and picks the exit code.
// To add a command: 1) write `commands/NAME_command.cpp`, 2) declare its `configure_NAME` in
// command.hpp, 3) add a row to the table below, 4) run its help text in tests/commands_test.cpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <string>
#include <system_error>
#include <vector>

#include "app/command.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"

namespace keyblock {
namespace {

constexpr std::array<Command, 15> kCommands{{
    {"check", "says what files are, what they hold and what is odd about them", configure_check},
    {"cut", "cuts a drawing into blocks, or a mesh by it into elements and covers", configure_cut},
    {"joints", "draws joint sets from statistics into an outline", configure_joints},
    {"run", "reruns a case and writes its results into a folder", configure_run},
    {"fos", "divides the strength of joints or rock until a case no longer stands", configure_fos},
    {"sif", "stress intensity factors and J of the crack tips of a case", configure_sif},
    {"compare", "reruns cases against their expected values and the old program's traces", configure_compare},
    {"tradeoff", "runs a case in many ways: what each digit of accuracy costs", configure_tradeoff},
    {"sweep", "runs a case over contact stiffness and step: where it is accurate, where it fails", configure_sweep},
    {"batch", "checks, runs or converts every case of an archive, and writes a catalogue", configure_batch},
    {"convert", "writes a case in another format and names what that cannot hold", configure_convert},
    {"element", "drives one element of a material along a path of strains and stresses", configure_element},
    {"fit", "finds parameters of rock from measured curves of stress and strain, or from triaxial tests",
     configure_fit},
    {"formats", "lists the file formats and how well each is known (also: info)", configure_formats},
    {"info", "the same as formats", configure_formats},
}};

// CLI11 says no more than that a command is needed.
void require_known(const std::string& command) {
  if (command.starts_with('-') || std::ranges::find(kCommands, command, &Command::name) != kCommands.end()) return;
  std::vector<const char*> names;
  for (const Command& known : kCommands) names.push_back(known.name);
  throw UsageError(fmt::format("there is no command \"{}\", only {}", command, fmt::join(names, ", ")));
}

// As `ulimit -v` or a batch sets it.
bool has_memory_limit() {
  rlimit limit{};
  return getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

/// Every message passes here: what files say must not speak to the terminal.
class PrintableMessage : public spdlog::custom_flag_formatter {
 public:
  void format(const spdlog::details::log_msg& message, const std::tm&, spdlog::memory_buf_t& line) override {
    const std::string text = printable({message.payload.data(), message.payload.size()});
    line.append(text.data(), text.data() + text.size());
  }
  std::unique_ptr<custom_flag_formatter> clone() const override { return std::make_unique<PrintableMessage>(); }
};

void print_messages_plainly() {
  spdlog::set_default_logger(spdlog::stderr_color_st("keyblock"));
  auto formatter = std::make_unique<spdlog::pattern_formatter>();
  formatter->add_flag<PrintableMessage>('*').set_pattern("%*");
  spdlog::set_formatter(std::move(formatter));
}

int run_program(int argc, char** argv) {
  if (argc > 1) require_known(argv[1]);
  CLI::App program{
      "Keyblock: reruns the files of discontinuous deformation analysis and the numerical manifold method"};
  program.name("keyblock");
  program.set_version_flag("--version", KEYBLOCK_VERSION);
  program.require_subcommand(1);
  Action chosen;
  for (const Command& command : kCommands) {
    CLI::App* options = program.add_subcommand(command.name, command.sentence);
    const auto action = std::make_shared<Action>(command.configure(*options));
    options->callback([&chosen, action] { chosen = *action; });
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return static_cast<int>(program.exit(error) == 0 ? ExitCode::ok : ExitCode::usage);
  }
  const ExitCode code = chosen();
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) throw OutputError("cannot write to standard output");
  return static_cast<int>(code);
}

// The first file opened would otherwise take the place of a stream that is closed, and what is printed would go into
// it. What cannot be said is not said; what cannot be printed is an error once it is asked for.
void fill_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0) open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
}

ExitCode out_of_memory(const char* for_what) {
  const bool is_limited = has_memory_limit();
  spdlog::error("keyblock: error: there is not enough memory for {}{}", for_what,
                is_limited ? " within the limit" : "");
  return is_limited ? ExitCode::limit : ExitCode::numerical_failure;
}

// Of the system: threads need memory, and tables write to standard output.
ExitCode code_of(const std::system_error& error) {
  if (error.code() == std::errc::resource_unavailable_try_again) return out_of_memory("another thread");
  if (std::ferror(stdout) != 0)
    spdlog::error("keyblock: error: cannot write to standard output: {}", error.code().message());
  else
    spdlog::error("keyblock: error: {}", error.what());
  return ExitCode::numerical_failure;
}

}  // namespace
}  // namespace keyblock

int main(int argc, char** argv) {
  keyblock::fill_closed_streams();
  // A file that grows beyond its limit is one that cannot be written, and is told as such.
  std::signal(SIGXFSZ, SIG_IGN);
  keyblock::print_messages_plainly();
  try {
    return keyblock::run_program(argc, argv);
  } catch (const keyblock::InputError& error) {
    spdlog::error("{}", error.what());
    return static_cast<int>(keyblock::ExitCode::unreadable);
  } catch (const keyblock::UsageError& error) {
    spdlog::error("keyblock: error: {}", error.what());
    return static_cast<int>(keyblock::ExitCode::usage);
  } catch (const std::filesystem::filesystem_error& error) {
    spdlog::error("{}: error: {}", error.path1().string(), error.code().message());
    return static_cast<int>(keyblock::ExitCode::usage);
  } catch (const std::bad_alloc&) {
    return static_cast<int>(keyblock::out_of_memory("this"));
  } catch (const std::system_error& error) {
    return static_cast<int>(keyblock::code_of(error));
  } catch (const std::exception& error) {
    spdlog::error("keyblock: error: {}", error.what());
    return static_cast<int>(keyblock::ExitCode::numerical_failure);
  }
}
