// Fills the parts that reports of runs, of archives and of factors of safety share.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/handout/handout.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include "base/bytes/file_bytes.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;

std::string date_of(std::time_t time) {
  std::tm parts{};
  gmtime_r(&time, &parts);
  std::array<char, 64> text{};
  std::strftime(text.data(), text.size(), "%d %B %Y", &parts);
  return text[0] == '0' ? text.data() + 1 : text.data();
}

std::string date_of(const fs::path& file) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error);
  if (error) return {};
  return date_of(std::chrono::system_clock::to_time_t(
      std::chrono::time_point_cast<std::chrono::system_clock::duration>(std::chrono::file_clock::to_sys(time))));
}

}  // namespace

std::string today() {
  std::time_t now = std::time(nullptr);
  if (const char* given = std::getenv("SOURCE_DATE_EPOCH"); given != nullptr)
    std::from_chars(given, given + std::strlen(given), now);
  return date_of(now);
}

std::vector<std::pair<std::string, std::string>> facts_of(const std::string& project, const std::string& program,
                                                          const fs::path& record) {
  return {{"Project", project}, {"Program", program}, {"Computed", date_of(record)}, {"Report", today()}};
}

void add_if_filled(std::vector<report::DocumentSection>& sections, report::DocumentSection section) {
  std::erase_if(section.tables, [](const report::DocumentTable& table) { return table.rows.empty(); });
  if (!section.tables.empty() || !section.pictures.empty() || !section.paragraphs.empty())
    sections.push_back(std::move(section));
}

void add_anchors(std::vector<report::DocumentSection>& sections) {
  for (report::DocumentSection& section : sections) {
    section.anchor = section.heading;
    std::ranges::replace(section.anchor, ' ', '-');
  }
}

std::vector<report::DocumentPicture> pictures_in(const fs::path& folder,
                                                 const std::vector<std::pair<std::string, std::string>>& known,
                                                 std::size_t most) {
  std::vector<report::DocumentPicture> pictures;
  for (const auto& [name, caption] : known) {
    if (pictures.size() >= most || !fs::is_regular_file(folder / name)) continue;
    std::string svg = file_bytes((folder / name).string());
    if (svg.starts_with("<svg") || svg.starts_with("<?xml")) pictures.push_back({std::move(svg), caption});
  }
  return pictures;
}

}  // namespace keyblock
