// Receives the events of yaml-cpp's parser and appends nodes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/yaml_text.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <sstream>
#include <vector>

namespace keyblock::formats {
namespace {

constexpr std::size_t kDeepest = 12;  // a case file needs 8
constexpr std::size_t kLongest = std::numeric_limits<std::uint32_t>::max();
constexpr std::string_view kMark = "keyblock:";
constexpr const char* kPlain = "?";  // the tag of a plain scalar

bool is_one_of(std::string_view text, const std::array<std::string_view, 3>& words) {
  return std::ranges::find(words, text) != words.end();
}

bool looks_like_number(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  if (text.starts_with('.')) text.remove_prefix(1);
  return !text.empty() && text.front() >= '0' && text.front() <= '9';
}

}  // namespace

/// Appends one node per value; keys of maps are strings.
class YamlReader final : public YAML::EventHandler {
 public:
  YamlReader(JsonText& into, std::string_view text) : into_(into), text_(text) {
    const std::size_t mark = text.size() - without_bom(text).size();
    line_starts_.push_back(mark);
    for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1))
      line_starts_.push_back(at + 1);
  }

  void read() {
    std::istringstream stream{std::string(text_)};
    try {
      YAML::Parser parser(stream);
      if (!parser.HandleNextDocument(*this) || into_.nodes_.empty())
        fail_at(text_.size(), "a case file in YAML, found the end of the file");
      is_over_ = true;
      parser.HandleNextDocument(*this);
    } catch (const YAML::Exception& fault) {
      fail_at(offset_of(fault.mark), fmt::format("sound YAML, found a fault: {}", fault.msg));
    }
  }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (is_over_) fail_at(offset_of(mark), "one document, found another");
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    refuse_anchor(mark, anchor);
    add(mark, JsonKind::null);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    fail_at(offset_of(mark), "a value, found an alias; write the value out");
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    refuse_anchor(mark, anchor);
    const bool is_plain = tag == kPlain || tag.empty();
    if (is_key() || !is_plain) return add_string(mark, value);
    constexpr std::array<std::string_view, 3> kTrue{"true", "True", "TRUE"}, kFalse{"false", "False", "FALSE"};
    if (is_one_of(value, kTrue)) return add(mark, JsonKind::yes);
    if (is_one_of(value, kFalse)) return add(mark, JsonKind::no);
    if (!looks_like_number(value)) return add_string(mark, value);
    double number = 0;
    const char* const first = value.data() + (value.starts_with('+') ? 1 : 0);
    const char* const last = value.data() + value.size();
    const auto [end, error] = std::from_chars(first, last, number);
    if (end != last) return add_string(mark, value);  // "20 GPa"
    if (error != std::errc{}) fail_at(offset_of(mark), fmt::format("a number of double precision, found {}", value));
    add(mark, JsonKind::number);
    into_.nodes_.back().number = number;
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    refuse_anchor(mark, anchor);
    open(mark, JsonKind::array);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    refuse_anchor(mark, anchor);
    open(mark, JsonKind::object);
  }
  void OnMapEnd() override { close(); }

 private:
  struct Open {
    std::size_t node;
    bool is_map;
    bool wants_key;
  };

  [[noreturn]] void fail_at(std::size_t offset, const std::string& expected) const {
    throw InputError(into_.map_.place(std::min(offset, text_.size())), "expected " + expected);
  }
  std::size_t offset_of(const YAML::Mark& mark) const {
    if (mark.line < 0 || static_cast<std::size_t>(mark.line) >= line_starts_.size()) return text_.size();
    return std::min(line_starts_[static_cast<std::size_t>(mark.line)] + static_cast<std::size_t>(mark.column),
                    text_.size());
  }
  void refuse_anchor(const YAML::Mark& mark, YAML::anchor_t anchor) const {
    if (anchor != 0) fail_at(offset_of(mark), "a value, found an anchor; write the value out");
  }
  bool is_key() const { return !open_.empty() && open_.back().is_map && open_.back().wants_key; }

  void add(const YAML::Mark& mark, JsonKind kind) {
    const bool is_text = kind == JsonKind::string;
    if (is_key() && !is_text) fail_at(offset_of(mark), "a key, found something that is no word");
    JsonText::Node node{};
    node.offset = offset_of(mark);
    node.kind = static_cast<std::uint8_t>(kind);
    into_.nodes_.push_back(node);
    if (!open_.empty() && open_.back().is_map) open_.back().wants_key = !open_.back().wants_key;
  }
  void add_string(const YAML::Mark& mark, const std::string& value) {
    add(mark, JsonKind::string);
    into_.nodes_.back().string = {static_cast<std::uint32_t>(value.size()),
                                  static_cast<std::uint32_t>(into_.strings_.size())};
    into_.strings_ += value;
  }
  void open(const YAML::Mark& mark, JsonKind kind) {
    add(mark, kind);
    open_.push_back({into_.nodes_.size() - 1, kind == JsonKind::object, true});
    if (open_.size() > kDeepest)
      fail_at(offset_of(mark), fmt::format("at most {} levels of lists and maps, found another", kDeepest));
  }
  void close() {
    into_.nodes_[open_.back().node].end = into_.nodes_.size();
    open_.pop_back();
  }

  JsonText& into_;
  std::string_view text_;
  std::vector<std::size_t> line_starts_;
  std::vector<Open> open_;
  bool is_over_ = false;
};

bool is_yaml_case(std::string_view text) {
  text = without_bom(text);
  for (std::size_t at = text.find(kMark); at != std::string_view::npos; at = text.find(kMark, at + 1))
    if (at == 0 || text[at - 1] == '\n') return true;
  return false;
}

void read_yaml(JsonText& into, const Source& source) {
  if (source.text.size() > kLongest)
    throw InputError({source.name},
                     fmt::format("expected at most {} bytes of YAML, found {}", kLongest, source.text.size()));
  YamlReader(into, source.text).read();
}

}  // namespace keyblock::formats
