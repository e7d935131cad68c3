// `keyblock explain`: explains a warning or doubt by its code, or lists all codes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <nlohmann/json.hpp>
#include <ranges>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/words/diagnostics.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;

struct ExplainOptions {
  std::string code;  ///< empty: the list of all codes
  bool as_json = false;
};

Json json_of(const Diagnostic& row) {
  return {{"code", row.code},
          {"level", word_of(row.level)},
          {"summary", row.summary},
          {"meaning", row.meaning},
          {"remedy", row.remedy}};
}

// Accepts a code as messages print it: in brackets.
std::string without_brackets(std::string code) {
  if (code.size() > 1 && code.front() == '[' && code.back() == ']') code = code.substr(1, code.size() - 2);
  std::ranges::transform(code, code.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return code;
}

const Diagnostic& named(const std::string& asked) {
  const std::string code = without_brackets(asked);
  if (const Diagnostic* row = find_diagnostic(code)) return *row;
  std::vector<std::string> codes;
  for (const Diagnostic& row : diagnostics()) codes.emplace_back(row.code);
  throw UsageError(fmt::format("explain: there is no entry \"{}\"{}; `keyblock explain` lists them", code,
                               nearest_words(code, codes)));
}

ExitCode explain(const ExplainOptions& options) {
  if (options.code.empty()) {
    if (options.as_json) {
      Json rows = Json::array();
      for (const Diagnostic& row : diagnostics()) rows.push_back(json_of(row));
      fmt::print("{}\n", rows.dump(1));
    } else {
      const std::size_t longest = std::ranges::max(
          diagnostics() | std::views::transform([](const Diagnostic& row) { return row.code.size(); }));
      for (const Diagnostic& row : diagnostics())
        fmt::print("{:<{}} {:<8} {}\n", row.code, longest, word_of(row.level), row.summary);
    }
    return ExitCode::ok;
  }
  const Diagnostic& row = named(options.code);
  if (options.as_json)
    fmt::print("{}\n", json_of(row).dump(1));
  else
    fmt::print("{} ({}): {}\n\n{}\n\nWhat to do: {}\n", row.code, word_of(row.level), row.summary, row.meaning,
               row.remedy);
  return ExitCode::ok;
}

}  // namespace

Action configure_explain(CLI::App& options) {
  const auto chosen = std::make_shared<ExplainOptions>();
  options.add_option("code", chosen->code, "code in brackets at the end of a warning (default: list all)")
      ->type_name("CODE");
  options.add_flag("--json", chosen->as_json, "print as JSON");
  return [chosen] { return explain(*chosen); };
}

}  // namespace keyblock
