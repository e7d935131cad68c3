// Starts the browser with a profile folder of its own, which is removed.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/helpers/page_print.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cstdlib>

#include "app/helpers/helper_program.hpp"
#include "base/bytes/file_bytes.hpp"
#include "base/error.hpp"
#include "job/files.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 4> kBrowsers{"chromium", "chromium-browser", "google-chrome", "chrome"};

}  // namespace

std::string printing_browser() {
  if (const char* given = std::getenv("CHROMIUM"); given != nullptr) return is_installed(given) ? given : "";
  for (const char* browser : kBrowsers)
    if (is_installed(browser)) return browser;
  return {};
}

std::string printed_page(const std::string& html, const std::string& browser) {
  const WorkFolder folder("keyblock_print");
  const fs::path page = folder / "page.html", pdf = folder / "page.pdf";
  write_file(page, html);
  std::vector<std::string> words{browser,
                                 "--headless",
                                 "--disable-gpu",
                                 "--no-first-run",
                                 fmt::format("--user-data-dir={}", (folder / "profile").string()),
                                 "--no-pdf-header-footer",
                                 "--print-to-pdf-no-header",
                                 fmt::format("--print-to-pdf={}", pdf.string())};
  if (geteuid() == 0) words.emplace_back("--no-sandbox");  // Chromium refuses to start for root with it
  words.push_back("file://" + page.string());
  const int code = run_helper(words, Words::dropped);
  if (code != 0 || !fs::is_regular_file(pdf))
    throw OutputError(fmt::format("{} wrote no PDF (exit code {})", browser, code));
  return file_bytes(pdf.string());
}

}  // namespace keyblock
