// Reads both motion formats; the layouts are in the header.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/berkeley/motion.hpp"

#include <fmt/format.h>

#include "formats/text/demands.hpp"
#include "formats/text/numbers.hpp"
#include "formats/text/split.hpp"
#include "formats/text/tokens.hpp"

namespace keyblock::formats {
namespace {

constexpr double kShakeTimeStep = 0.02;
constexpr std::size_t kShakeValuesALine = 8;

std::size_t line_end(std::string_view text, std::size_t at) {
  return std::min(text.find('\n', at), text.size());
}

/// Line ends of a shake file, and its pieces as separate tokens.
class Shake {
 public:
  explicit Shake(const Source& source)
      : text_(without_bom(source.text)),
        first_(line_end(text_, 0)),
        second_(line_end(text_, std::min(first_ + 1, text_.size()))),
        map_(std::make_shared<const TextMap>(source.name, text_)) {}

  /// The first line is a title; it contains no comment.
  Tokens title() const { return tokens_between(0, first_, Syntax::xml); }
  Tokens second_line() const { return tokens_between(first_, second_, Syntax::native); }
  Tokens values() const { return tokens_between(second_, text_.size(), Syntax::native); }

 private:
  Tokens tokens_between(std::size_t first, std::size_t last, Syntax syntax) const {
    Tokens tokens{map_, text_, syntax, last};
    add_words(tokens, first, last - first);
    return tokens;
  }

  std::string_view text_;
  std::size_t first_;
  std::size_t second_;
  std::shared_ptr<const TextMap> map_;
};

bool holds_eight_a_line(const Tokens& values) {
  std::size_t before = values.start_of(0);
  for (std::size_t i = 1; i < values.numbers.size(); ++i) {
    const std::size_t start = values.start_of(i);
    const bool is_new_line = values.text.substr(before, start - before).find('\n') != std::string_view::npos;
    before = start;
    if (is_new_line != (i % kShakeValuesALine == 0)) return false;
  }
  return true;
}

Recognition recognise_shake(const Source& source) {
  const std::string_view text = without_bom(source.text);
  if (parse_real(text.substr(0, text.find_first_of(" \t\r\n")))) return {};  // most files: avoids splitting a long one
  const Shake shake(source);
  const Numbers head = shake.second_line().numbers;
  if (!shake.title().junk() || head.empty()) return {};
  const Tokens values = shake.values();
  const std::size_t have = values.numbers.size();
  if (have == 0 || head[0] != static_cast<double>(have) || values.junk() || !holds_eight_a_line(values)) return {};
  return {Recognition::Fit::exact, fmt::format("its second line announces the {} values that follow, 8 a line", have)};
}

/// Returns true if the first line has two numbers, unlike an analysis with as many steps.
bool has_head_of_two(const Tokens& tokens) {
  if (tokens.numbers.size() < 3) return false;
  const std::size_t end = line_end(tokens.text, tokens.start_of(0));
  return tokens.start_of(1) < end && end < tokens.start_of(2);
}

Recognition recognise_matlab(const Tokens& tokens) {
  const Numbers& n = tokens.numbers;
  if (!has_head_of_two(tokens) || !(n[0] > 0) || n[1] != static_cast<double>(n.size() - 2)) return {};
  return {Recognition::Fit::exact, fmt::format("its first line announces the {} values that follow", n.size() - 2)};
}

TimeCurve next_values(Cursor& cursor, int count, double time_step) {
  TimeCurve motion;
  motion.times.reserve(std::min(static_cast<std::size_t>(count), cursor.numbers_left()));
  motion.values.reserve(motion.times.capacity());
  motion.place = {cursor.place().file};
  for (int i = 0; i < count; ++i) {
    cursor.enter({"value", static_cast<std::size_t>(i) + 1, static_cast<std::size_t>(count)});
    motion.times.push_back(i * time_step);
    motion.values.push_back({cursor.next_real("the acceleration"), 0});
  }
  cursor.leave();
  return motion;
}

Reading reading_of(TimeCurve motion, const Cursor& cursor) {
  Reading reading;
  reading.content.motion = std::move(motion);
  reading.warnings = cursor.remainder();
  return reading;
}

Reading read_shake(const Source& source, const ReadHint&) {
  const Shake shake(source);
  const Tokens second_line = shake.second_line();
  const Tokens values = shake.values();
  const int count = Cursor(second_line, "end of line").next_integer("the number of values", kAtLeastOne);
  Cursor cursor(values);
  return reading_of(next_values(cursor, count, kShakeTimeStep), cursor);
}

Reading read_matlab(const Source& source, const ReadHint&) {
  const Tokens tokens = tokenise(source);
  Cursor cursor(tokens);
  const double time_step = cursor.next_real("the time step", kPositive);
  const int count = cursor.next_count("the number of values");
  return reading_of(next_values(cursor, count, time_step), cursor);
}

}  // namespace

constinit const Format kMotionShake{.name = "motion-shake",
                                    .title = "ground motion, format shake",
                                    .recognise = recognise_shake,
                                    .read = read_shake,
                                    .evidence = "public source; no real file seen",
                                    .sample = "a quake\n3\n.1 .2 .3\n"};
constinit const Format kMotionMatlab{.name = "motion-matlab",
                                     .title = "ground motion, format matlab",
                                     .read = read_matlab,
                                     .recognise_numbers = recognise_matlab,
                                     .evidence = "public source; no real file seen",
                                     .sample = ".01 3\n.1\n.2\n.3\n"};

}  // namespace keyblock::formats
