// `keyblock new`: writes a commented example case.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/command.hpp"
#include "app/option_checks.hpp"
#include "app/templates/case_templates.hpp"
#include "base/error.hpp"
#include "formats/strict_json.hpp"
#include "job/files.hpp"

namespace keyblock {
namespace {

struct NewOptions {
  std::string name;
  std::string file;
  bool is_strict = false;  ///< JSON
  bool force = false;
  bool as_json = false;
};

std::vector<std::string> template_names() {
  std::vector<std::string> names;
  for (const CaseTemplate& known : case_templates()) names.emplace_back(known.name);
  return names;
}

// Converts a template to YAML. Keys of the outer object lose their quotes and commas, inner content is unchanged, and
// // outside of quotes becomes #.
class YamlOfTemplate {
 public:
  explicit YamlOfTemplate(std::string_view json) : json_(json) {
    while (at_ < json_.size()) take();
    while (yaml_.ends_with("\n\n")) yaml_.pop_back();
  }
  std::string text() && { return std::move(yaml_); }

 private:
  void take() {
    const char c = json_[at_];
    const bool is_line_start = at_ == 0 || json_[at_ - 1] == '\n';
    if (is_line_start && depth_ == 1 && c == ' ') {
      ++at_;
    } else if (json_.substr(at_).starts_with("//")) {
      const std::size_t end = std::min(json_.find('\n', at_), json_.size());
      yaml_ += fmt::format("#{}", json_.substr(at_ + 2, end - at_ - 2));
      at_ = end;
    } else if (c == '"') {
      take_word();
    } else {
      take_sign(c);
      ++at_;
    }
  }

  void take_word() {
    const std::size_t end = json_.find('"', at_ + 1) + 1;
    const bool is_outer_key = depth_ == 1 && (yaml_.empty() || yaml_.back() == '\n');
    yaml_ += is_outer_key ? json_.substr(at_ + 1, end - at_ - 2) : json_.substr(at_, end - at_);
    at_ = end;
  }

  void take_sign(char c) {
    const bool opens = c == '{' || c == '[', closes = c == '}' || c == ']';
    const bool is_of_outer = (opens && depth_ == 0) || (closes && depth_ == 1) || (c == ',' && depth_ == 1);
    depth_ += opens ? 1 : closes ? -1 : 0;
    const bool is_empty_line = c == '\n' && yaml_.empty();
    if (!is_of_outer && !is_empty_line) yaml_ += c;
  }

  std::string_view json_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::string yaml_;
};

ExitCode write_template(const NewOptions& options) {
  const auto found = std::ranges::find(case_templates(), options.name, &CaseTemplate::name);
  const std::string file = options.file.empty() ? options.name + ".json" : options.file;
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  std::error_code error;
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  if (error) throw UsageError(fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
  require_writable({file}, {}, overwrite_if(options.force));
  const bool is_yaml = file.ends_with(".yaml") || file.ends_with(".yml");
  const std::string text(found->text);
  write_output(file,
               is_yaml             ? YamlOfTemplate(text).text()
               : options.is_strict ? formats::strict_json({file, text})
                                   : text,
               overwrite_if(options.force));
  if (options.as_json)
    fmt::print("{}\n", nlohmann::ordered_json({{"file", file}, {"kind", options.name}, {"about", found->about}})
                           .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  spdlog::info("wrote {}: {}", file, found->about);
  spdlog::info("next: keyblock run {} -o out", file);
  return ExitCode::ok;
}

}  // namespace

Action configure_new(CLI::App& options) {
  const auto chosen = std::make_shared<NewOptions>();
  std::vector<std::string> lines;
  for (const CaseTemplate& known : case_templates()) lines.push_back(fmt::format("{}: {}", known.name, known.about));
  options.add_option("KIND", chosen->name, fmt::format("{}", fmt::join(lines, "; ")))
      ->required()
      ->check(one_word_of(template_names()));
  options
      .add_option("-o,--output", chosen->file,
                  "case file to write, .json or .yaml (default: KIND.json); missing folders are created")
      ->type_name("FILE");
  options.add_flag("--strict-json", chosen->is_strict,
                   "write JSON without comments and trailing commas, which every parser reads");
  options.add_flag("--force", chosen->force, "overwrite the file if it exists");
  options.add_flag("--json", chosen->as_json, "print name, kind and description of the file as JSON");
  return [chosen] { return write_template(*chosen); };
}

}  // namespace keyblock
