// Reads the blocks of a measured-point file; the layout is in the header.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/berkeley/berkeley_measured.hpp"

#include <fmt/format.h>

#include <string_view>

#include "base/sentences/sentences.hpp"
#include "formats/text/split.hpp"
#include "formats/text/tokens.hpp"

namespace keyblock::formats {
namespace {

constexpr std::string_view kMark = "measpoint";

bool is_blank(char c) {
  return c == '\0' || c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

std::size_t next_word(std::string_view text, std::size_t at) {
  while (at < text.size() && is_blank(text[at])) ++at;
  return at;
}

Recognition recognise_measured(const Source& source) {
  const std::string_view text = without_bom(source.text);
  if (!text.substr(next_word(text, 0)).starts_with(kMark)) return {};
  return {Recognition::Fit::exact, "it begins with measpoint"};
}

/// Reads block after block; the numbers within one are separate tokens.
class MeasuredReader {
 public:
  explicit MeasuredReader(const Source& source)
      : text_(without_bom(source.text)), map_(std::make_shared<TextMap>(source.name, text_)) {}

  Reading read() {
    Reading reading;
    for (at_ = next_word(text_, 0); at_ < text_.size(); at_ = next_word(text_, at_))
      reading.content.tracks.push_back(next_track(reading.warnings));
    if (reading.content.tracks.empty()) fail("a measured point (measpoint1=[), found end of file");
    return reading;
  }

 private:
  [[noreturn]] void fail(std::string_view sentence) const {
    throw InputError(map_->place(at_), fmt::format("expected {}", sentence));
  }

  MeasuredTrack next_track(Warnings& warnings) {
    const std::size_t open = text_.find('[', at_);
    if (!text_.substr(at_).starts_with(kMark) || open == std::string_view::npos)
      fail("a measured point (measpoint1=[), found other text");
    MeasuredTrack track;
    track.point = next_number(open) - 1;
    const std::size_t close = text_.find(']', open);
    if (close == std::string_view::npos)
      warnings.push_back(warning_of({"track_cut", {{{"measured_point", track.point + 1}}, {{"close", "]"}}}},
                                    map_->place(text_.size())));
    track.rows = rows_between(open + 1, std::min(close, text_.size()), close == std::string_view::npos);
    at_ = close == std::string_view::npos ? text_.size() : close + 1;
    if (at_ < text_.size() && text_[at_] == ';') ++at_;
    return track;
  }

  /// Returns the number in `measpoint12 = [`.
  int next_number(std::size_t open) const {
    const std::size_t first = at_ + kMark.size();
    Tokens tokens{map_, text_.substr(0, text_.find('=', first)), Syntax::xml, open};
    add_words(tokens, first, std::min(open, tokens.text.size()) - first);
    Cursor cursor(tokens, "nothing");
    return cursor.next_integer_between(1, 1000000, "the number of the measured point");
  }

  std::vector<MeasuredRow> rows_between(std::size_t first, std::size_t last, bool is_cut) const {
    Tokens tokens{map_, text_, Syntax::xml, last};
    add_words(tokens, first, last - first);
    Cursor cursor(tokens, "the end of the rows");
    std::vector<MeasuredRow> rows;
    while (!cursor.at_end() && !(is_cut && cursor.numbers_left() < 9)) {
      cursor.enter({"row", rows.size() + 1, tokens.word_count / 9});
      rows.push_back(next_row(cursor));
    }
    return rows;
  }

  static MeasuredRow next_row(Cursor& cursor) {
    MeasuredRow row;
    row.step = cursor.next_integer("the step");
    row.time = cursor.next_real("the time");
    row.time_step = cursor.next_real("the time step");
    row.position.x = cursor.next_real("x");
    row.position.y = cursor.next_real("y");
    row.displacement = cursor.next_real("the displacement");
    row.velocity.x = cursor.next_real("the velocity in x");
    row.velocity.y = cursor.next_real("the velocity in y");
    row.speed = cursor.next_real("the speed");
    return row;
  }

  std::string_view text_;
  std::shared_ptr<const TextMap> map_;
  std::size_t at_ = 0;
};

Reading read_measured(const Source& source, const ReadHint&) {
  return MeasuredReader(source).read();
}

}  // namespace

constinit const Format kBerkeleyMeasured{.name = "berkeley-measured",
                                         .title = "measured points of Berkeley's DDA in time",
                                         .recognise = recognise_measured,
                                         .read = read_measured,
                                         .evidence = "public source; no real file seen",
                                         .sample = "measpoint1=[\n1 .1 .1 5 6 0 0 0 0\n];\n"};

}  // namespace keyblock::formats
