// `keyblock view`: writes a completed run as one page for a browser.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "app/handout/frame_faults.hpp"
#include "app/handout/strength_document.hpp"
#include "job/files.hpp"
#include "job/folder/frame_files.hpp"
#include "job/folder/output_files.hpp"
#include "job/page/run_page.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;

struct ViewOptions {
  std::string folder;
  std::string file;
  bool force = false;
  bool as_json = false;
};

/// Returns the files of the folder that a page may not replace.
std::vector<fs::path> kept_files(const fs::path& folder) {
  std::vector<fs::path> kept;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() != ".html") kept.push_back(entry.path());
  return kept;
}

bool is_of_strength(const fs::path& folder) {
  return fs::is_regular_file(folder / kStrengthRecord) && !fs::is_directory(folder / kFrameFolder);
}

/// Returns the page of a run, or that of a factor of safety.
std::string page_of(const fs::path& folder) {
  return is_of_strength(folder) ? report::document_page(strength_document(folder, {}).document) : run_page(folder);
}

ExitCode view(const ViewOptions& options) {
  const std::string file = options.file.empty() ? (fs::path(options.folder) / kPageFile).string() : options.file;
  require_writable({file}, kept_files(options.folder), overwrite_if(options.force));
  const std::string altered = is_of_strength(options.folder) ? "" : outputs_altered(options.folder);
  const std::string page = page_of(options.folder);
  write_output(file, page, overwrite_if(options.force));
  if (options.as_json)
    fmt::print("{}\n", nlohmann::ordered_json({{"file", file}, {"bytes", page.size()}})
                           .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  spdlog::info("{}: {:.3g} MB, opens in a browser without a network", file, static_cast<double>(page.size()) / 1e6);
  if (altered.empty()) return ExitCode::ok;
  spdlog::error("{}: error: {}; the page shows what is there", options.folder, altered);
  return ExitCode::check_failed;
}

}  // namespace

Action configure_view(CLI::App& options) {
  const auto chosen = std::make_shared<ViewOptions>();
  options.add_option("RUN", chosen->folder, "results folder of a finished or stopped run, or of a factor of safety")
      ->required()
      ->check(CLI::ExistingDirectory);
  options.add_option("-o,--output", chosen->file, fmt::format("page to write (default: RUN/{})", kPageFile))
      ->type_name("FILE");
  options.add_flag("--force", chosen->force, "overwrite the page if it exists");
  options.add_flag("--json", chosen->as_json, "print file and size as JSON");
  return [chosen] { return view(*chosen); };
}

}  // namespace keyblock
