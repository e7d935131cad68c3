// `keyblock report`: writes one page about a run, or about all runs of a folder, to hand to others.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "app/command.hpp"
#include "app/handout/archive_document.hpp"
#include "app/handout/run_document.hpp"
#include "app/handout/strength_document.hpp"
#include "app/helpers/page_print.hpp"
#include "base/error.hpp"
#include "job/files.hpp"
#include "job/folder/output_files.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;

struct ReportOptions {
  std::string folder;
  std::string file;
  std::string project;
  bool has_pdf = false;
  bool force = false;
  bool as_json = false;
};

Handout handout_of(const fs::path& folder, const std::string& project) {
  if (fs::is_regular_file(folder / kRecord)) return run_document(folder, project);
  if (fs::is_regular_file(folder / kStrengthRecord)) return strength_document(folder, project);
  return archive_document(folder, project);
}

// Writes the page as PDF beside it. Returns its name; empty, with a message, if no browser is installed.
std::string write_pdf(const std::string& html, const std::string& file, Overwrite overwrite) {
  const std::string browser = printing_browser();
  if (browser.empty()) {
    spdlog::error("error: --pdf needs a browser that prints, and none is installed (Debian package chromium)");
    return {};
  }
  write_output(file, printed_page(html, browser), overwrite);
  return file;
}

ExitCode write_report(const ReportOptions& options) {
  const fs::path folder = options.folder;
  const std::string file = options.file.empty() ? (folder / "report.html").string() : options.file;
  if (const fs::path ending = fs::path(file).extension(); ending != ".html" && ending != ".htm")
    throw UsageError(fmt::format(
        "-o: a report is a page: expected a name that ends in .html, found {}; --pdf writes PDF beside it", file));
  const std::string pdf = fs::path(file).replace_extension(".pdf").string();
  const Overwrite overwrite = overwrite_if(options.force);
  require_writable(options.has_pdf ? std::vector<fs::path>{file, pdf} : std::vector<fs::path>{file}, {}, overwrite);
  const Handout handout = handout_of(folder, options.project);
  const report::Document& document = handout.document;
  const std::string html = report::document_page(document);
  write_output(file, html, overwrite);
  const std::string written = options.has_pdf ? write_pdf(html, pdf, overwrite) : std::string();
  if (options.as_json) {
    nlohmann::ordered_json json{{"file", file}, {"title", document.title}, {"verdict", document.verdict_in_words}};
    if (!written.empty()) json["pdf"] = written;
    json["faults"] = handout.faults;
    fmt::print("{}\n", json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  }
  for (const std::string& fault : handout.faults) spdlog::error("{}", fault);
  spdlog::info("wrote {}{}: {}", file, written.empty() ? "" : " and " + written, document.verdict_in_words);
  return handout.faults.empty() && written.empty() == !options.has_pdf ? ExitCode::ok : ExitCode::check_failed;
}

}  // namespace

Action configure_report(CLI::App& options) {
  const auto chosen = std::make_shared<ReportOptions>();
  options
      .add_option("DIR", chosen->folder,
                  "results folder of a run or of a factor of safety, or a folder with such folders in it")
      ->required()
      ->check(CLI::ExistingDirectory);
  options.add_option("-o,--output", chosen->file, "page to write, HTML (default: DIR/report.html)")->type_name("FILE");
  options.add_option("--project", chosen->project, "name of the project, for the head of the report")
      ->type_name("NAME");
  options.add_flag("--pdf", chosen->has_pdf, "also write the report as PDF beside the page; needs chromium");
  options.add_flag("--force", chosen->force, "overwrite the file if it exists");
  options.add_flag("--json", chosen->as_json, "print file, title and verdict as JSON");
  return [chosen] { return write_report(*chosen); };
}

}  // namespace keyblock
