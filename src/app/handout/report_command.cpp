// `keyblock report`: writes one page about a run, or about all runs of a folder, to hand to others.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "app/command.hpp"
#include "app/handout/run_document.hpp"
#include "base/error.hpp"
#include "job/files.hpp"
#include "job/folder/output_files.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;

struct ReportOptions {
  std::string folder;
  std::string file;
  bool force = false;
  bool as_json = false;
};

ExitCode write_report(const ReportOptions& options) {
  const fs::path folder = options.folder;
  const std::string file = options.file.empty() ? (folder / "report.html").string() : options.file;
  if (const fs::path ending = fs::path(file).extension(); ending != ".html" && ending != ".htm")
    throw UsageError(fmt::format(
        "-o: a report is a page: expected a name that ends in .html, found {}; a browser prints it as PDF", file));
  require_writable({file}, {}, overwrite_if(options.force));
  const bool is_run = fs::is_regular_file(folder / kRecord);
  const report::Document document = is_run ? run_document(folder) : archive_document(folder);
  write_output(file, report::document_page(document), overwrite_if(options.force));
  if (options.as_json)
    fmt::print("{}\n", nlohmann::ordered_json(
                           {{"file", file}, {"title", document.title}, {"verdict", document.verdict_in_words}})
                           .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  spdlog::info("wrote {}: {}", file, document.verdict_in_words);
  return ExitCode::ok;
}

}  // namespace

Action configure_report(CLI::App& options) {
  const auto chosen = std::make_shared<ReportOptions>();
  options.add_option("DIR", chosen->folder, "results folder of a run, or a folder with such folders in it")
      ->required()
      ->check(CLI::ExistingDirectory);
  options.add_option("-o,--output", chosen->file, "page to write, HTML (default: DIR/report.html)")->type_name("FILE");
  options.add_flag("--force", chosen->force, "overwrite the file if it exists");
  options.add_flag("--json", chosen->as_json, "print file, title and verdict as JSON");
  return [chosen] { return write_report(*chosen); };
}

}  // namespace keyblock
