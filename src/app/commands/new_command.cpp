// `keyblock new`: a commented case to begin one's own from.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "app/templates/case_templates.hpp"
#include "job/files.hpp"

namespace keyblock {
namespace {

struct NewOptions {
  std::string name;
  std::string file;
  bool force = false;
  bool as_json = false;
};

std::vector<std::string> template_names() {
  std::vector<std::string> names;
  for (const CaseTemplate& known : case_templates()) names.emplace_back(known.name);
  return names;
}

ExitCode write_template(const NewOptions& options) {
  const auto found = std::ranges::find(case_templates(), options.name, &CaseTemplate::name);
  const std::string file = options.file.empty() ? options.name + ".json" : options.file;
  require_writable({file}, {}, overwrite_if(options.force));
  write_output(file, found->text, overwrite_if(options.force));
  if (options.as_json)
    fmt::print("{}\n",
               nlohmann::ordered_json({{"file", file}, {"kind", options.name}, {"about", found->about}}).dump());
  spdlog::info("{}: {}; keyblock check {} looks at it, keyblock run {} -o out runs it", file, found->about, file, file);
  return ExitCode::ok;
}

}  // namespace

Action configure_new(CLI::App& options) {
  const auto chosen = std::make_shared<NewOptions>();
  std::vector<std::string> lines;
  for (const CaseTemplate& known : case_templates()) lines.push_back(fmt::format("{}: {}", known.name, known.about));
  options.add_option("KIND", chosen->name, fmt::format("{}", fmt::join(lines, "; ")))
      ->required()
      ->check(CLI::IsMember(template_names()));
  options.add_option("-o,--output", chosen->file, "the case file to write (default: KIND.json)");
  options.add_flag("--force", chosen->force, "overwrite the file if it exists");
  options.add_flag("--json", chosen->as_json, "print the name of the file, its kind and what it is as JSON");
  return [chosen] { return write_template(*chosen); };
}

}  // namespace keyblock
