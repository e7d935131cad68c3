// `keyblock convert`: converts files from one format to another, and names all content that the target cannot hold.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "app/input/drawing_options.hpp"
#include "app/messages.hpp"
#include "base/error.hpp"
#include "job/files.hpp"
#include "job/run_report.hpp"
#include "study/convert/convert.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;

struct ConvertOptions {
  std::vector<std::string> files;
  std::string output;
  std::string target;
  bool is_strict = false;
  bool may_overwrite = false;
  bool takes_faults = false;
  bool as_json = false;
  DrawingOptions reading;
};

// Returns the endings that determine a target, each once.
std::string endings() {
  std::vector<std::string_view> all;
  for (const study::Target& target : study::targets())
    if (target.parts.size() == 1 && std::ranges::find(all, target.parts.front().ending) == all.end())
      all.push_back(target.parts.front().ending);
  return fmt::format("{}", fmt::join(all, ", "));
}

// Without a named target, returns the first whose files have the ending of the output.
const study::Target& target_of(const ConvertOptions& options) {
  if (!options.target.empty()) return study::target_named(options.target);
  const std::string ending = std::filesystem::path(options.output).extension().string();
  for (const study::Target& target : study::targets())
    if (target.parts.size() == 1 && target.parts.front().ending == ending) return target;
  throw UsageError(fmt::format("expected --to FORMAT, one of {}, or an output that ends in {}, found \"{}\"",
                               study::target_names(), endings(), options.output));
}

// A single file is the output itself. Several files have their endings, which replace one of the target's if there is
// one.
std::filesystem::path path_of(const ConvertOptions& options, const study::Target& target, std::string_view ending) {
  if (target.parts.size() == 1) return options.output;
  std::filesystem::path file = options.output;
  if (std::ranges::any_of(target.parts, [&](const auto& part) { return file.extension() == part.ending; }))
    file.replace_extension();
  return file += ending;
}

// An existing file is kept next to the new one, under the first free name.
void keep_backup(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return;
  std::filesystem::path backup = file;
  backup += ".bak";
  for (int i = 2; std::filesystem::exists(std::filesystem::symlink_status(backup)); ++i)
    backup = file.string() + fmt::format(".bak{}", i);
  std::filesystem::copy_file(file, backup);
  spdlog::info("{} kept as {}", file.string(), backup.string());
}

std::string words_of(const study::Loss& loss) {
  return fmt::format("{}: {}{}: {}", loss.is_added ? "added" : "lost", loss.item,
                     loss.times > 1 ? fmt::format(" ({} times, the first)", loss.times) : "", loss.sentence);
}

/// Returns a sentence per file of the target that is not written.
std::vector<std::string> not_written(const ConvertOptions& options, const study::Target& target,
                                     const study::Conversion& conversion) {
  std::vector<std::string> sentences;
  for (const study::UnwrittenFile& file : conversion.unwritten)
    sentences.push_back(
        fmt::format("not written: {}: {}", path_of(options, target, file.ending).string(), file.reason));
  return sentences;
}

Json json_of(const study::Conversion& conversion, const std::vector<std::string>& outputs,
             const std::vector<std::string>& unwritten) {
  Json losses = Json::array();
  for (const study::Loss& loss : conversion.losses)
    losses.push_back(
        {{"item", loss.item}, {"times", loss.times}, {"change", loss.sentence}, {"sentence", words_of(loss)}});
  return {{"outputs", outputs},
          {"not_written", unwritten},
          {"losses", losses},
          {"warnings", warning_list_json(conversion.warnings)},
          {"changed_rules", warning_list_json(conversion.changed_rules)}};
}

ExitCode convert_files(const ConvertOptions& options) {
  if (options.output.empty()) throw UsageError("convert: expected -o OUT");
  const study::Target& target = target_of(options);
  std::vector<std::filesystem::path> files;
  for (const study::Target::Part& part : target.parts) files.push_back(path_of(options, target, part.ending));
  std::vector<std::string> inputs = options.files;
  take_layers(inputs, options.reading.layers);
  require_writable(files, {inputs.begin(), inputs.end()}, overwrite_if(options.may_overwrite));
  const study::Conversion conversion =
      study::convert(formats::read_files(inputs, options.reading.choices), target,
                     options.takes_faults ? study::Faults::berkeley : study::Faults::none,
                     std::filesystem::absolute(options.output).parent_path());
  log_warnings(joined(conversion.warnings, conversion.changed_rules));
  const bool is_refused = options.is_strict && !conversion.losses.empty();
  std::vector<std::string> outputs;
  for (const study::ConvertedFile& file : conversion.files) {
    if (is_refused) break;
    const std::filesystem::path path = path_of(options, target, file.ending);
    keep_backup(path);
    write_output(path, file.text, overwrite_if(options.may_overwrite));
    outputs.push_back(path.string());
  }
  const std::vector<std::string> unwritten = not_written(options, target, conversion);
  if (options.as_json) {
    fmt::print("{}\n", json_of(conversion, outputs, unwritten).dump(1, ' ', false, Json::error_handler_t::replace));
  } else {
    for (const std::string& output : outputs) fmt::print("{}\n", output);
    for (const std::string& sentence : unwritten) fmt::print("{}\n", sentence);
    for (const study::Loss& loss : conversion.losses) fmt::print("{}\n", words_of(loss));
  }
  if (is_refused) spdlog::error("keyblock: error: {} cannot hold all; nothing is written (--strict)", target.name);
  return is_refused ? ExitCode::check_failed : ExitCode::ok;
}

}  // namespace

Action configure_convert(CLI::App& app) {
  const auto options = std::make_shared<ConvertOptions>();
  app.add_option("IN", options->files, "files of one case, in any order")->required();
  add_drawing_options(app, options->reading);
  app.add_option("-o,--output", options->output, "file to write; if the target is two files, their common name")
      ->type_name("FILE");
  app.add_option(
      "--to", options->target,
      "format: " + study::target_names() + ", or an ending such as json (default: by the ending of the output)");
  app.add_flag("--strict", options->is_strict, "write nothing and exit with 1 if anything would be lost");
  app.add_flag("--force", options->may_overwrite, "overwrite existing files; the old ones are kept as .bak");
  app.add_flag("--bug-compatible", options->takes_faults,
               "read old files and XML with the faults of the Berkeley program: first material line and bolts lost, "
               "boundary lines of XML dropped. Stress gradient and initial velocity share numbers");
  app.add_flag("--json", options->as_json, "print outputs, losses and warnings as JSON");
  return [options] { return convert_files(*options); };
}

}  // namespace keyblock
