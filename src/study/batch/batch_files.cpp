// Walks the tree and sorts its files by content.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/batch/batch_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <map>

#include "formats/registry.hpp"
#include "formats/text/numbers.hpp"

namespace keyblock::study {

namespace fs = std::filesystem;

namespace {

// Files with these endings that fit no format are not damaged cases, except numbers in .txt and case-file keys in
// .json.
constexpr std::array<std::string_view, 36> kForeignEndings{
    ".bat", ".bmp", ".c",   ".cpp", ".csv",  ".doc", ".docx", ".exe", ".f",    ".for", ".f90",  ".gif",
    ".gz",  ".h",   ".hpp", ".htm", ".html", ".jpg", ".jpeg", ".js",  ".json", ".log", ".m",    ".md",
    ".pdf", ".png", ".ps",  ".pvd", ".py",   ".svg", ".tar",  ".txt", ".vtu",  ".xls", ".xlsx", ".zip"};

/// Returns the bytes of the first UTF-8 character of the text (Unicode, table 3-7); 0 if it begins with none.
std::size_t character_size(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = byte(0), second = byte(1);
  const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return follows(1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    const bool is_range = !(first == 0xE0 && second < 0xA0) && !(first == 0xED && second > 0x9F);
    return is_range && follows(1) && follows(2) ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    const bool is_range = !(first == 0xF0 && second < 0x90) && !(first == 0xF4 && second > 0x8F);
    return is_range && follows(1) && follows(2) && follows(3) ? 4 : 0;
  }
  return 0;
}

// Journal and catalogue hold UTF-8 only; old archives have names in code pages.
std::string escaped(std::string_view name) {
  std::string text;
  while (!name.empty()) {
    const std::size_t size = name.front() == '%' ? 0 : character_size(name);
    if (size == 0)
      text += fmt::format("%{:02X}", static_cast<unsigned char>(name.front()));
    else
      text += name.substr(0, size);
    name.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return text;
}

bool is_hidden(const fs::path& path) {
  return path.filename().string().starts_with('.');
}

bool begins_with(const fs::path& file, std::string_view words) {
  std::ifstream text(file, std::ios::binary);
  std::string head(words.size(), ' ');
  return text.read(head.data(), static_cast<std::streamsize>(head.size())) && head == words;
}

// A folder made by `batch -o` has a journal with this beginning.
bool is_of_a_batch(const fs::path& folder) {
  return begins_with(folder / "journal.jsonl", "{\"batch\":");
}

// A folder made by `run -o` or `fos -o` has a record with this beginning.
bool is_of_a_run(const fs::path& folder) {
  constexpr std::string_view kHead = "{\n \"program\": \"keyblock\"";
  return std::ranges::any_of(std::array{"run.json", "fos.json"},
                             [&](const char* record) { return begins_with(folder / record, kHead); });
}

// Returns the reason to leave out an entry of a folder; empty for files, and for folders to walk into.
std::string_view why_not(const fs::directory_entry& entry) {
  std::error_code ignored;
  const bool is_link = entry.is_symlink(ignored);
  if (is_hidden(entry.path())) return "hidden";
  if (is_link && !entry.exists(ignored)) return "dead link";
  if (is_link && entry.is_directory(ignored)) return "link to a folder";
  if (entry.is_directory(ignored) && is_of_a_run(entry.path())) return "results of a run";
  if (entry.is_directory(ignored)) return is_of_a_batch(entry.path()) ? "results of another batch" : "";
  return entry.is_regular_file(ignored) ? "" : "device or pipe";
}

void visit(const fs::path& folder, const fs::path& root, const fs::path& left_out, FoundFiles& found) {
  const auto name_of = [&](const fs::path& path) { return escaped(path.lexically_relative(root).generic_string()); };
  std::error_code error, ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (fs::equivalent(entry.path(), left_out, ignored)) continue;
    if (const std::string_view reason = why_not(entry); !reason.empty())
      found.passed_over.push_back({name_of(entry.path()), reason});
    else if (entry.is_directory(ignored))
      visit(entry.path(), root, left_out, found);
    else
      found.files.push_back(name_of(entry.path()));
  }
  if (error) found.passed_over.push_back({name_of(folder), "folder that cannot be opened"});
}

// A file that fits two dialects needs the kind of its geometry to be decided, but is an analysis in both.
std::optional<formats::Choice> choice_of(const formats::Source& source) {
  for (const formats::GeometryKind kind : {formats::GeometryKind::unknown, formats::GeometryKind::blocks}) {
    try {
      return formats::recognise(source, kind);
    } catch (const InputError&) {
      continue;
    }
  }
  return std::nullopt;
}

std::optional<formats::Content> content_of(const formats::Choice& choice, const formats::Source& source) {
  try {
    return formats::read_as(choice, source).content;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

bool has_geometry(const formats::Content& content) {
  return content.drawing || content.blocks || content.cover;
}

FileRole role_by_content(const formats::Content& content) {
  if (has_geometry(content)) return content.analysis ? FileRole::whole_case : FileRole::geometry;
  return content.analysis ? FileRole::analysis : FileRole::side_file;
}

// Formats with only one kind of content decide the role here; other formats need their content.
FileRole role_by_format(std::string_view format) {
  if (format.starts_with("dda-geometry") || format.starts_with("dda-blocks") || format == "nmm-cover")
    return FileRole::geometry;
  if (format.starts_with("dda-analysis") || format == "nmm-analysis") return FileRole::analysis;
  if (format.starts_with("berkeley-") || format.starts_with("motion-")) return FileRole::side_file;
  if (format == "udec-deck") return FileRole::foreign;
  return FileRole::unreadable;
}

// If most of the first words are numbers, the file is meant as a table, not as text.
bool looks_numeric(std::string_view text) {
  constexpr std::size_t kWords = 100, kFewest = 6;
  constexpr std::string_view kSpace = " \t\r\n,";
  std::size_t words = 0, numbers = 0;
  for (std::size_t at = text.find_first_not_of(kSpace); at != std::string_view::npos && words < kWords;) {
    const std::size_t end = std::min(text.find_first_of(kSpace, at), text.size());
    ++words;
    numbers += formats::parse_real(text.substr(at, end - at)) ? 1 : 0;
    at = text.find_first_not_of(kSpace, end);
  }
  return words >= kFewest && 2 * numbers > words;
}

// Keys that every geometry or analysis in the case-file format has, for a file whose mark is lost.
bool looks_like_a_case(std::string_view text) {
  return std::ranges::any_of(
      std::array<std::string_view, 4>{"\"youngs_modulus\"", "\"boundary_count\"", "\"outer\"", "\"loop_vertices\""},
      [&](std::string_view key) { return text.find(key) != std::string_view::npos; });
}

FileRole role_by_name(const fs::path& path, std::string_view text) {
  if (path.filename() == "expected.csv") return FileRole::side_file;
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const bool is_broken = (ending == ".txt" && looks_numeric(text)) || (ending == ".json" && looks_like_a_case(text));
  const bool is_foreign = std::ranges::find(kForeignEndings, ending) != kForeignEndings.end();
  return is_foreign && !is_broken ? FileRole::foreign : FileRole::unreadable;
}

/// Returns one more than the greatest number; 1 without numbers, because material 1 always exists.
template <class List, class Number>
std::size_t numbered(const List& list, Number number) {
  int greatest = 0;
  for (const auto& item : list) greatest = std::max(greatest, number(item));
  return static_cast<std::size_t>(greatest) + 1;
}

FitCounts counts_of(const Drawing& drawing) {
  return {false, numbered(drawing.material_lines, [](const MaterialLine& line) { return line.block_material; }),
          numbered(drawing.joints, [](const JointLine& line) { return line.joint_material; }),
          drawing.loading_points.size()};
}

FitCounts counts_of(const Blocks& blocks) {
  const auto greatest_joint = [](const BlockPolygon& block) {
    int greatest = 0;
    for (const BlockVertex& vertex : block.outer) greatest = std::max(greatest, vertex.joint_material);
    return greatest;
  };
  return {false, numbered(blocks.blocks, [](const BlockPolygon& block) { return block.material; }),
          numbered(blocks.blocks, greatest_joint), blocks.loading_points.size()};
}

FitCounts counts_of(const Cover& cover) {
  return {true, numbered(cover.elements, [](const CoverElement& element) { return element.material; }),
          numbered(cover.loop_vertices, [](const LoopVertex& vertex) { return vertex.joint_material; }),
          cover.loading_points.size()};
}

FitCounts counts_of(const Analysis& analysis) {
  return {analysis.dialect == AnalysisDialect::manifold, analysis.block_materials.size(),
          analysis.joint_materials.size(), analysis.point_loads.size()};
}

}  // namespace

FoundFiles files_below(const fs::path& root, const fs::path& left_out) {
  if (!fs::is_directory(root)) throw InputError({root.string(), 0, 0}, "expected a folder, found none");
  FoundFiles found;
  visit(root, root, left_out, found);
  std::ranges::sort(found.files);
  std::ranges::sort(found.passed_over, {}, &PassedOver::path);
  return found;
}

std::string sentence_of(const std::vector<PassedOver>& passed_over) {
  std::map<std::string_view, std::vector<std::string_view>> by_reason;
  for (const PassedOver& entry : passed_over) by_reason[entry.reason].push_back(entry.path);
  std::vector<std::string> parts;
  for (const auto& [reason, paths] : by_reason)
    parts.push_back(
        fmt::format("{} × {} ({}{})", paths.size(), reason, paths.size() > 1 ? "the first " : "", paths[0]));
  return fmt::format("{}", fmt::join(parts, ", "));
}

fs::path place_of(const fs::path& root, const std::string& path) {
  std::string name;
  for (std::size_t i = 0; i < path.size(); ++i) {
    unsigned byte = 0;
    const bool is_escape = path[i] == '%' && i + 2 < path.size();
    if (is_escape) std::from_chars(&path[i + 1], &path[i + 1] + 2, byte, 16);
    name += is_escape ? static_cast<char>(byte) : path[i];
    if (is_escape) i += 2;
  }
  return root / name;
}

std::optional<FitCounts> counts_of(const formats::Content& content) {
  if (content.drawing) return counts_of(*content.drawing);
  if (content.blocks) return counts_of(*content.blocks);
  if (content.cover) return counts_of(*content.cover);
  if (content.analysis) return counts_of(*content.analysis);
  return std::nullopt;
}

BatchFile look_at(const formats::Source& source, const std::string& path) {
  const auto choice = choice_of(source);
  if (!choice) return {path, role_by_name(path, source.text), {}, std::nullopt};
  BatchFile file{path, role_by_format(choice->format->name), std::string(choice->format->name), std::nullopt};
  if (file.role == FileRole::side_file || file.role == FileRole::foreign) return file;
  if (file.role == FileRole::unreadable && choice->recognition.fit == formats::Recognition::Fit::damaged)
    return {path, role_by_name(path, source.text), {}, std::nullopt};  // JSON or XML without this program's mark
  const auto content = content_of(*choice, source);
  if (!content) return file;
  if (file.role == FileRole::unreadable) file.role = role_by_content(*content);
  file.counts = counts_of(*content);
  return file;
}

std::string_view name_of(FileRole role) {
  switch (role) {
    case FileRole::geometry:
      return "geometry";
    case FileRole::analysis:
      return "analysis";
    case FileRole::whole_case:
      return "case";
    case FileRole::side_file:
      return "side file";
    case FileRole::foreign:
      return "other file";
    case FileRole::unreadable:
      return "unreadable";
  }
  return "unreadable";
}

}  // namespace keyblock::study
