// Configures spdlog, through which all messages go.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/messages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <array>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/counted.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"
#include "base/words/diagnostics.hpp"

namespace keyblock {
namespace {

/// Formats every message: text of files must not control the terminal.
class PrintableMessage : public spdlog::custom_flag_formatter {
 public:
  void format(const spdlog::details::log_msg& message, const std::tm&, spdlog::memory_buf_t& line) override {
    const std::string text = printable({message.payload.data(), message.payload.size()});
    const std::size_t before = line.size();
    line.append(text.data(), text.data() + text.size());
    for (const std::string_view word : {"error:", "warning:"}) {
      const std::size_t at = text.find(word);
      if (at == std::string::npos) continue;
      message.color_range_start = before + at;
      message.color_range_end = before + at + word.size();
      return;
    }
  }
  std::unique_ptr<custom_flag_formatter> clone() const override { return std::make_unique<PrintableMessage>(); }
};

std::unique_ptr<spdlog::formatter> plain_lines() {
  auto formatter = std::make_unique<spdlog::pattern_formatter>();
  formatter->add_flag<PrintableMessage>('*').set_pattern("%*");
  return formatter;
}

spdlog::sink_ptr terminal() {
  return spdlog::default_logger()->sinks().front();
}

// Messages are appended only to a log: other files of a user are not changed.
void log_into(const std::string& file) {
  std::error_code is_not_there;
  const bool is_new = !std::filesystem::exists(file, is_not_there) || std::filesystem::is_empty(file, is_not_there);
  const bool has_other_names = std::filesystem::hard_link_count(file, is_not_there) > 1;
  if (!is_new && (has_other_names || std::filesystem::canonical(file, is_not_there).extension() != ".log"))
    throw UsageError(fmt::format("--log {}: expected a new file, or one whose name ends in .log, found another", file));
  try {
    auto sink = std::make_shared<spdlog::sinks::basic_file_sink_st>(file);
    sink->set_formatter(plain_lines());
    spdlog::default_logger()->sinks().push_back(std::move(sink));
  } catch (const spdlog::spdlog_ex&) {
    throw UsageError("cannot write the log " + file);
  }
}

// Warnings of one name are of different kinds if their sentences differ in more than numbers. Text in quotes is a name.
std::string kind_of(const Warning& warning) {
  constexpr std::string_view kDigits = "0123456789";
  constexpr std::string_view kOfNumbers = "0123456789.e+-";
  std::string kind = warning.name + ' ';
  bool in_quotes = false;
  for (std::size_t i = 0; i < warning.sentence.size();) {
    const char c = warning.sentence[i];
    if (c == '"') in_quotes = !in_quotes;
    if (in_quotes || kDigits.find(c) == std::string_view::npos) {
      kind += c;
      ++i;
    } else {
      i = std::min(warning.sentence.find_first_not_of(kOfNumbers, i), warning.sentence.size());
    }
  }
  return kind;
}

/// First warning of a kind, and the number of warnings.
struct Kind {
  const Warning* first = nullptr;
  int count = 0;
};

/// Returns the kinds of each code; codes and kinds in the order of their first warnings.
std::vector<std::pair<std::string, std::vector<Kind>>> sorted_by_code(const Warnings& warnings) {
  std::vector<std::pair<std::string, std::vector<Kind>>> all;
  std::map<std::string, std::size_t> codes;  // place in `all`
  std::map<std::string, std::size_t> known;  // place of a kind in its code
  for (const Warning& warning : warnings) {
    const auto [code, is_new_code] = codes.emplace(warning.name, all.size());
    if (is_new_code) all.push_back({warning.name, {}});
    std::vector<Kind>& kinds = all[code->second].second;
    const auto [kind, is_new] = known.emplace(kind_of(warning), kinds.size());
    if (is_new) kinds.push_back({&warning, 0});
    ++kinds[kind->second].count;
  }
  return all;
}

/// Returns the second line of a warning or an error, indented; empty for notes, which have none.
std::string help_of(const std::string& code) {
  const Diagnostic* row = find_diagnostic(code);
  if (row == nullptr || row->level == DiagnosticLevel::note || row->level == DiagnosticLevel::silent) return {};
  return help_line(row->remedy);
}

void log_help(const std::string& code) {
  if (const std::string help = help_of(code); !help.empty()) spdlog::warn("{}", help);
}

/// First warning of a code, and the number of warnings with this code.
struct OfCode {
  const Warning* first = nullptr;
  std::size_t count = 0;
};

std::vector<OfCode> counted_by_code(const Warnings& warnings) {
  std::vector<OfCode> all;
  for (const Warning& warning : warnings) {
    auto known = std::ranges::find_if(all, [&](const OfCode& of) { return of.first->name == warning.name; });
    if (known == all.end()) known = all.insert(all.end(), {&warning, 0});
    ++known->count;
  }
  return all;
}

}  // namespace

void print_messages_plainly() {
  spdlog::set_default_logger(spdlog::stderr_color_st("keyblock"));
  spdlog::set_formatter(plain_lines());
  const char* no_color = std::getenv("NO_COLOR");
  if (no_color == nullptr || *no_color == 0) return;
  for (const spdlog::sink_ptr& sink : spdlog::default_logger()->sinks())
    if (auto* coloured = dynamic_cast<spdlog::sinks::stderr_color_sink_st*>(sink.get()))
      coloured->set_color_mode(spdlog::color_mode::never);
}

void add_message_options(CLI::App& program) {
  CLI::Option* quiet = program.add_flag_callback(
      "--quiet", [] { terminal()->set_level(spdlog::level::err); }, "print errors only");
  CLI::Option* verbose = program.add_flag_callback(
      "--verbose", [] { spdlog::set_level(spdlog::level::debug); },
      "print every warning in full, solver statistics and timings");
  quiet->excludes(verbose);
  program
      .add_option_function<std::string>("--log", log_into,
                                        "also append messages to FILE, which must be new or end in .log")
      ->type_name("FILE");
}

void print_record(const std::string& record, const std::string& file) {
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  const std::string line = record + "\n";
  errno = 0;
  const bool is_written = std::fwrite(line.data(), 1, line.size(), stdout) == line.size() && std::fflush(stdout) == 0;
  const int why = errno;
  std::signal(SIGPIPE, before);
  if (is_written) return;
  if (why != EBADF && why != EPIPE)
    throw OutputError(fmt::format("cannot write to standard output: {}", std::generic_category().message(why)));
  spdlog::warn("standard output is closed: the record is in {} alone", file);
  if (std::freopen("/dev/null", "w", stdout) == nullptr) throw OutputError("cannot write to standard output");
}

void log_warnings(const Warnings& warnings) {
  if (spdlog::should_log(spdlog::level::debug)) {
    for (const std::string& line : lines_of(warnings)) spdlog::warn("{}", line);
    return;
  }
  for (const auto& [code, kinds] : sorted_by_code(warnings)) {
    for (const auto& [first, count] : kinds)
      spdlog::warn("{}{}", to_string(*first), count > 1 ? fmt::format(" ({} times)", count) : "");
    log_help(code);
  }
}

std::vector<std::string> lines_of(const Warnings& warnings) {
  std::vector<std::string> lines;
  const auto put_help = [&](const std::string& code) {
    if (std::string help = help_of(code); !help.empty()) lines.push_back(std::move(help));
  };
  if (!spdlog::should_log(spdlog::level::debug)) {
    for (const auto& [first, count] : counted_by_code(warnings)) {
      lines.push_back(to_string(*first) + (count > 1 ? fmt::format(" (and {} more like this)", count - 1) : ""));
      put_help(first->name);
    }
    return lines;
  }
  std::set<std::string> helped;
  for (const Warning& warning : warnings) {
    lines.push_back(to_string(warning));
    if (helped.insert(warning.name).second) put_help(warning.name);
  }
  return lines;
}

void log_by_level(const Warnings& warnings, std::string_view of) {
  if (spdlog::should_log(spdlog::level::debug)) return log_warnings(warnings);
  constexpr std::size_t kMostCodes = 5;
  Warnings errors, shown;
  std::set<std::string> codes, more, notes;
  for (const Warning& warning : warnings) {
    const DiagnosticLevel level = level_of(warning.name);
    if (level == DiagnosticLevel::error) errors.push_back(warning);
    if (level == DiagnosticLevel::note) notes.insert(warning.name);
    if (level != DiagnosticLevel::warning) continue;
    if (codes.size() == kMostCodes && !codes.contains(warning.name)) {
      more.insert(warning.name);
      continue;
    }
    codes.insert(warning.name);
    shown.push_back(warning);
  }
  for (const Warnings& of_level : {errors, shown})
    for (const std::string& line : lines_of(of_level)) spdlog::warn("{}", line);
  if (!more.empty())
    spdlog::warn("{} on {}: {} (--verbose shows {})", counted(more.size(), "more warning"), of, fmt::join(more, ", "),
                 more.size() == 1 ? "it" : "them");
  if (!notes.empty())
    spdlog::info("{} on {}: {} (--verbose shows {})", counted(notes.size(), "note"), of, fmt::join(notes, ", "),
                 notes.size() == 1 ? "it" : "them");
}

std::string help_line(std::string_view remedy) {
  std::string words(remedy);
  if (words.size() > 1 && std::islower(static_cast<unsigned char>(words[1])) != 0)
    words.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(words.front())));
  if (words.ends_with('.')) words.pop_back();
  return "  help: " + words;
}

bool shows_progress() {
  return terminal()->should_log(spdlog::level::info);
}

}  // namespace keyblock
