// Lists the formats and chooses one by content. To add a format: 1) write its file pair, with its record, 2) add the
// record to the list below, 3) add a row to README.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <vector>

#include "base/bytes/file_bytes.hpp"
#include "base/context.hpp"
#include "base/parallel.hpp"
#include "formats/berkeley/berkeley_measured.hpp"
#include "formats/berkeley/berkeley_replay.hpp"
#include "formats/berkeley/ddaml.hpp"
#include "formats/berkeley/motion.hpp"
#include "formats/berkeley/recognised_only.hpp"
#include "formats/case_file/keyblock_case.hpp"
#include "formats/dxf/dxf.hpp"
#include "formats/dxf/dxf_layer_table.hpp"
#include "formats/shi/dda_analysis.hpp"
#include "formats/shi/dda_blocks.hpp"
#include "formats/shi/dda_geometry.hpp"
#include "formats/shi/nmm_analysis.hpp"
#include "formats/shi/nmm_cover.hpp"
#include "formats/text/decimal_comma.hpp"
#include "formats/text/split.hpp"
#include "formats/text/tokens.hpp"
#include "formats/views/views.hpp"

namespace keyblock::formats {
namespace {

/// Formats in the order of trial: by a mark first, then by the strength of the token equation.
constexpr std::array<const Format*, 20> kFormats{
    &kKeyblockCase,
    &kDdaExtended,
    &kDdaml,
    &kDxf,
    &kDxfLayers,
    &kUdecDeck,
    &kNmmCover,
    &kBerkeleyMeasured,
    &kBerkeleyReplay,
    &kDdaBlocks,
    &kDdaBlocksOfThree,
    &kDdaGeometry,
    &kDdaAnalysisBerkeley,
    &kDdaAnalysisShi,
    &kNmmAnalysis,
    &kDiskDda,
    &kMotionShake,
    &kMotionMatlab,
    &kVtk,
    &kCsv,
};

constexpr const char* kKnown = "a case file or a DDA geometry, block or analysis file";

[[noreturn]] void refuse(const Place& place, std::string_view found) {
  throw InputError(place, fmt::format("expected {}, found {}", kKnown, found));
}

bool is_blank(std::string_view text) {
  return std::ranges::all_of(text, [](unsigned char c) { return std::isspace(c) != 0; });
}

bool is_binary(char c) {
  const auto byte = static_cast<unsigned char>(c);
  const bool is_white = byte >= '\t' && byte <= '\r';
  return (byte < 0x20) & !is_white & (byte != 0x1a);
}

/// Returns the first byte from `at` on and before `last` that no text contains; npos if all are text. It counts piece
/// by piece, which compilers make fast.
std::size_t find_binary(std::string_view text, std::size_t at, std::size_t last) {
  constexpr std::size_t kPiece = 4096;
  for (; at < last; at += kPiece) {
    const std::string_view piece = text.substr(at, std::min(kPiece, last - at));
    unsigned char any = 0;
    for (const char c : piece) any |= static_cast<unsigned char>(is_binary(c));
    if (any != 0) return at + static_cast<std::size_t>(std::ranges::find_if(piece, is_binary) - piece.begin());
  }
  return std::string_view::npos;
}

std::size_t find_binary(std::string_view text) {
  std::vector<std::size_t> found(threads_for_bytes(text.size()));
  at_once(found.size(), [&](std::size_t i) {
    found[i] = find_binary(text, text.size() * i / found.size(), text.size() * (i + 1) / found.size());
  });
  return *std::ranges::min_element(found);
}

bool is_html(std::string_view text) {
  std::string head(text.substr(0, 4096));
  std::ranges::transform(head, head.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return head.find("<!doctype html") != std::string::npos || head.find("<html") != std::string::npos;
}

void refuse_other_files(const Source& source) {
  const std::string_view text = without_bom(source.text);
  if (text.empty()) refuse({source.name}, "an empty file");
  if (is_blank(text)) refuse({source.name}, "nothing but white space");
  if (text.starts_with("%PDF-") || text.starts_with("%!PS"))
    refuse({source.name}, "a page for printing (PDF or PostScript)");
  if (const std::string_view name = drawing_program_binary(text); !name.empty()) refuse({source.name}, name);
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
    refuse({source.name}, "text in UTF-16; save it as UTF-8");
  if (const std::size_t at = find_binary(text); at != std::string_view::npos)
    refuse(TextMap(source.name, text).place(at), "a binary file");
  const std::size_t first = text.find_first_not_of(" \t\r\n\f\v");
  if (text[first] == '<' && is_html(text)) refuse(TextMap(source.name, text).place(first), "an HTML page");
}

/// Long files that are rejected for their first bytes are not read further: a disk image may be larger than memory.
constexpr std::size_t kHead = 1 << 16;

bool no_text_begins_with(const std::string& head) {
  return find_binary(without_bom(head)) != std::string_view::npos &&
         kBerkeleyMeasured.recognise({"", head}).fit == Recognition::Fit::none;
}

Recognition recognition_of(const Format& format, const Source& source, const Tokens& tokens) {
  if (format.recognise) return format.recognise(source);
  return format.recognise_numbers ? format.recognise_numbers(tokens) : Recognition{};
}

std::vector<Choice> choices(const Source& source, const Tokens& tokens) {
  std::vector<Choice> found;
  for (const Format* format : kFormats) {
    Recognition recognition = recognition_of(*format, source, tokens);
    if (recognition.fit != Recognition::Fit::none) found.push_back({format, std::move(recognition)});
  }
  return found;
}

std::string describe_file(const Choice& choice) {
  return fmt::format("{} ({})", choice.format->title, choice.recognition.evidence);
}

/// Returns true for an analysis whose numbers no dialect of DDA explains completely.
bool is_poor_dda_analysis(const Choice& choice) {
  const bool is_dda = choice.format == &kDdaAnalysisBerkeley || choice.format == &kDdaAnalysisShi;
  return is_dda && choice.recognition.fit != Recognition::Fit::exact;
}

[[noreturn]] void refuse_nothing_fits(const Source& source, const Tokens& tokens) {
  if (tokens.word_count == 0) refuse({source.name}, "nothing but comments");
  Cursor(tokens).fail(kKnown);
}

}  // namespace

std::span<const Format* const> all_formats() {
  return kFormats;
}

const Format* find_format(std::string_view name) {
  const auto found = std::ranges::find(kFormats, name, &Format::name);
  return found == kFormats.end() ? nullptr : *found;
}

namespace {

void require_file(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(located(path), error);
  if (!std::filesystem::exists(status)) throw InputError({path}, "expected a file, found none");
  if (std::filesystem::is_directory(status)) throw InputError({path}, "expected a file, found a directory");
  if (!std::filesystem::is_regular_file(status))
    throw InputError({path}, "expected a regular file, found a device or pipe");
}

}  // namespace

Source load(const std::string& path) {
  require_file(path);
  return {path, file_bytes(path)};
}

Source load_text(const std::string& path) {
  require_file(path);
  if (std::string head = file_head(path, kHead); head.size() == kHead && no_text_begins_with(head))
    return {path, std::move(head)};
  return {path, file_bytes(path)};
}

const Tokens& Opened::tokens() {
  if (!tokens_) tokens_ = tokenise(source_);
  return *tokens_;
}

Choice Opened::recognise(GeometryKind geometry) {
  if (Recognition measured = kBerkeleyMeasured.recognise(source_); measured.fit == Recognition::Fit::exact)
    return {&kBerkeleyMeasured, std::move(measured)};  // it may hold zero bytes, which in other files mean binary data
  refuse_other_files(source_);
  const std::vector<Choice> found = choices(source_, tokens());
  const auto has_mark = [](const Choice& choice) { return choice.format->recognise != nullptr; };
  if (std::ranges::none_of(found, has_mark)) refuse_decimal_commas(tokens());
  if (found.empty()) refuse_nothing_fits(source_, tokens());
  const auto fit = [](const Choice& choice) { return choice.recognition.fit; };
  const auto best = std::ranges::max_element(found, {}, fit);  // the first of equals: order of trial
  if (geometry == GeometryKind::cover && is_poor_dda_analysis(*best))
    return {&kNmmAnalysis,
            {Recognition::Fit::damaged, "it begins like an analysis, and a cover file is in the same folder"}};
  const auto is_rival = [](const Choice& c) {
    return c.format == &kNmmAnalysis && c.recognition.fit == Recognition::Fit::exact;
  };
  const auto rival = std::ranges::find_if(found, is_rival);
  if (best->format != &kDdaAnalysisShi || fit(*best) != Recognition::Fit::exact || rival == found.end()) return *best;
  if (geometry == GeometryKind::unknown)
    throw InputError({source_.name},
                     fmt::format("expected the geometry of this file, which fits two formats, {} and {}; found none",
                                 describe_file(*best), describe_file(*rival)));
  return geometry == GeometryKind::cover ? *rival : *best;
}

Reading Opened::read_as(const Choice& choice, const ReadHint& hint) {
  if (choice.format->read_tokens) return choice.format->read_tokens(tokens(), hint);
  if (choice.format->read) {
    tokens_.reset();  // this reader splits the text itself
    return choice.format->read(source_, hint);
  }
  throw InputError({source_.name}, fmt::format("expected a file this version reads, found {}: recognised, not yet read",
                                               describe_file(choice)));
}

Choice recognise(const Source& source, GeometryKind geometry) {
  return Opened(source).recognise(geometry);
}

Reading read(const Source& source, const ReadHint& hint) {
  Opened opened(source);
  return opened.read_as(opened.recognise(hint.geometry), hint);
}

Reading read_as(const Choice& choice, const Source& source, const ReadHint& hint) {
  return Opened(source).read_as(choice, hint);
}

}  // namespace keyblock::formats
