// Reads the frames of a replay file; the layout is in the header.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/berkeley/berkeley_replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <span>

#include "base/sentences/sentences.hpp"
#include "formats/text/split.hpp"
#include "formats/text/tokens.hpp"
#include "geometry/polygon.hpp"

namespace keyblock::formats {
namespace {

constexpr std::int64_t kHeadSize = 7;
constexpr std::int64_t kSpareSlots = 4;  // as in the block file

struct Head {
  std::int64_t saved = 0, blocks = 0, bolts = 0, slots = 0, fixed = 0, loading = 0, measured = 0;

  std::int64_t points() const { return fixed + loading + measured; }
  std::int64_t before_frames() const { return kHeadSize + 3 * (blocks + 1); }
  std::int64_t frame() const { return 3 * (slots + 1) + 9 * bolts + 4 * (points() + 1); }
};

/// The slot ranges must follow each other and fill the slots: no other file does so after a surplus row.
std::optional<Head> head_of(std::span<const double> n) {
  if (n.size() < static_cast<std::size_t>(kHeadSize)) return std::nullopt;
  for (const double number : n.first(kHeadSize))
    if (!is_whole(number) || number < 0) return std::nullopt;
  const auto count = [&](int i) { return static_cast<std::int64_t>(n[i]); };
  const Head head{count(0), count(1), count(2), count(3), count(4), count(5), count(6)};
  if (head.blocks < 1 || head.before_frames() > static_cast<std::int64_t>(n.size())) return std::nullopt;
  double start = 1;
  for (std::int64_t block = 1; block <= head.blocks; ++block) {
    const auto range = n.subspan(kHeadSize + 3 * block, 3);
    if (range[1] != start || !(range[2] >= start + 2) || !is_whole(range[2])) return std::nullopt;
    start = range[2] + 1 + kSpareSlots;
  }
  if (start != static_cast<double>(head.slots) + 1) return std::nullopt;
  return head;
}

std::int64_t whole_frames(const Head& head, std::size_t numbers) {
  return (static_cast<std::int64_t>(numbers) - head.before_frames()) / head.frame();
}

Recognition recognise_replay(const Tokens& tokens) {
  using Fit = Recognition::Fit;
  const auto head = head_of(tokens.numbers);
  if (!head) return {};
  const std::int64_t frames = whole_frames(*head, tokens.numbers.size());
  const std::string evidence = fmt::format("7-number head announces {} blocks in {} frames, the file has {} whole ones",
                                           head->blocks, head->saved + 1, frames);
  if (frames == 0) return {Fit::damaged, evidence};
  if (frames <= head->saved) return {Fit::variant, evidence};
  const std::int64_t total = head->before_frames() + (head->saved + 1) * head->frame();
  return {total == static_cast<std::int64_t>(tokens.numbers.size()) ? Fit::exact : Fit::surplus, evidence};
}

struct Range {
  int material = 0;
  std::size_t first = 0;  ///< slot, from 0
  std::size_t size = 0;
};

class ReplayReader {
 public:
  explicit ReplayReader(const Tokens& tokens) : cursor_(tokens), tokens_(tokens) {}

  Reading read() {
    const auto head = head_of(tokens_.numbers);
    if (!head) cursor_.fail("the head of a replay file, with vertex slots of blocks that follow each other");
    head_ = *head;
    const std::int64_t whole = whole_frames(head_, tokens_.numbers.size());
    const std::int64_t frames = std::min(head_.saved + 1, std::max<std::int64_t>(whole, 1));
    skip(kHeadSize);
    read_ranges();
    for (std::int64_t i = 0; i < frames; ++i) read_frame(static_cast<int>(i), frames);
    cursor_.leave();
    Reading reading;
    if (frames <= head_.saved)
      reading.warnings.push_back(
          warning_of({"frames_missing", {{{"announced", head_.saved + 1}, {"frames", frames}}}}, cursor_.place()));
    else
      reading.warnings = cursor_.remainder();
    reading.content.frames = std::move(frames_);
    return reading;
  }

 private:
  void skip(std::int64_t numbers) {
    for (std::int64_t i = 0; i < numbers; ++i) cursor_.next_real("a row without meaning");
  }

  void read_ranges() {
    skip(3);
    for (std::int64_t i = 0; i < head_.blocks; ++i) {
      Range range;
      range.material = cursor_.next_index("the block material");
      range.first = static_cast<std::size_t>(cursor_.next_index("the first vertex slot"));
      range.size = static_cast<std::size_t>(cursor_.next_integer("the last vertex slot")) - range.first;
      ranges_.push_back(range);
    }
  }

  std::vector<Point> next_slots() {
    skip(3);
    std::vector<Point> slots;  // grows as the file confirms: its first frame may be cut
    for (std::int64_t i = 0; i < head_.slots; ++i) {
      skip(1);
      const double x = cursor_.next_real("x of a vertex slot");
      slots.push_back({x, cursor_.next_real("y of a vertex slot")});
    }
    return slots;
  }

  ElementFrame element_of(const Range& range, const std::vector<Point>& slots) const {
    ElementFrame element;
    const auto first = slots.begin() + static_cast<std::ptrdiff_t>(range.first);
    element.loops = {{first, first + static_cast<std::ptrdiff_t>(range.size)}};
    element.material = range.material;
    element.area = area(element.loops[0]);
    element.centroid = centroid(element.loops[0]);
    return element;
  }

  BoltFrame next_bolt() {
    BoltFrame bolt;
    bolt.first.x = cursor_.next_real("x of the start of a bolt");
    bolt.first.y = cursor_.next_real("y of the start of a bolt");
    bolt.second.x = cursor_.next_real("x of the end of a bolt");
    bolt.second.y = cursor_.next_real("y of the end of a bolt");
    skip(5);
    return bolt;
  }

  std::vector<PointFrame> next_points(std::int64_t count) {
    std::vector<PointFrame> points;
    for (std::int64_t i = 0; i < count; ++i) {
      PointFrame point;
      skip(1);
      point.position.x = cursor_.next_real("x of a point");
      point.position.y = cursor_.next_real("y of a point");
      point.element = cursor_.next_integer_between(0, static_cast<int>(head_.blocks), "the block of a point") - 1;
      points.push_back(point);
    }
    return points;
  }

  void read_frame(int number, std::int64_t of) {
    cursor_.enter({"frame", static_cast<std::size_t>(number) + 1, static_cast<std::size_t>(of)});
    Frame frame;
    frame.step = number;
    const std::vector<Point> slots = next_slots();
    for (const Range& range : ranges_) frame.elements.push_back(element_of(range, slots));
    for (std::int64_t i = 0; i < head_.bolts; ++i) frame.bolts.push_back(next_bolt());
    skip(4);
    frame.fixed_points = next_points(head_.fixed);
    frame.loading_points = next_points(head_.loading);
    frame.measured_points = next_points(head_.measured);
    frames_.push_back(since_start(std::move(frame)));
  }

  static void measure(std::vector<PointFrame>& points, const std::vector<PointFrame>& start) {
    for (std::size_t i = 0; i < points.size(); ++i) points[i].displacement = points[i].position - start[i].position;
  }

  Frame since_start(Frame frame) const {
    if (frames_.empty()) return frame;
    const Frame& start = frames_.front();
    for (std::size_t i = 0; i < frame.elements.size(); ++i)
      frame.elements[i].displacement = frame.elements[i].centroid - start.elements[i].centroid;
    measure(frame.fixed_points, start.fixed_points);
    measure(frame.loading_points, start.loading_points);
    measure(frame.measured_points, start.measured_points);
    return frame;
  }

  Cursor cursor_;
  const Tokens& tokens_;
  Head head_;
  std::vector<Range> ranges_;
  std::vector<Frame> frames_;
};

Reading read_tokens(const Tokens& tokens, const ReadHint&) {
  return ReplayReader(tokens).read();
}

}  // namespace

constinit const Format kBerkeleyReplay{
    .name = "berkeley-replay",
    .title = "replay file of Berkeley's DDA (frames)",
    .read = read_split<read_tokens>,
    .recognise_numbers = recognise_replay,
    .read_tokens = read_tokens,
    .evidence = "public source; no real file seen",
    .sample =
        "1 1 1 7\n1 0 0\n0 0 0\n1 1 3\n9 9 9\n1 0 0\n1 1 0\n1 0 1\n1 0 0\n0 0 0\n0 0 0\n0 0 0\n"
        "0 0 1 0 1 1 5 6 7\n0 0 0 0\n0 .1 .1 1\n"};

}  // namespace keyblock::formats
