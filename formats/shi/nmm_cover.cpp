// Reads and writes the cover file; the layout is in the header.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/shi/nmm_cover.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <initializer_list>
#include <iterator>
#include <span>
#include <stdexcept>

#include "base/large_pages.hpp"
#include "base/sentences/sentences.hpp"
#include "formats/text/numbers.hpp"
#include "formats/text/split.hpp"
#include "formats/text/tokens.hpp"
#include "geometry/polygon.hpp"

namespace keyblock::formats {
namespace {

constexpr std::size_t kHeadSize = 8;
constexpr std::size_t kManyNumbers = 1000000;  // some milliseconds of work: enough for a thread
constexpr std::size_t kFewElements = 20000;    // their places take some hundredths of a second
constexpr int kSlotsAnElement = 4;             // three corners and the first again

struct Head {
  int elements, fixed, loading, measured, slots, covers, loops, loop_slots;

  std::size_t total() const {
    const auto size = [](int count) { return static_cast<std::size_t>(count); };
    return kHeadSize + 3 * (size(fixed) + size(loading) + size(measured)) + 6 * size(elements) +
           2 * (size(slots) + size(covers) + size(loops) + size(loop_slots));
  }
};

/// A polygon has 3 vertices and its first again; a block file differs by a 1 in the eighth place.
std::optional<Head> head_of(std::span<const double> n) {
  if (n.size() < kHeadSize) return std::nullopt;
  if (!std::ranges::all_of(n.first(kHeadSize), [](double v) { return is_whole(v) && v >= 0; })) return std::nullopt;
  if (n[0] < 1 || n[4] < kSlotsAnElement * n[0] || n[5] < 3 || n[7] < 4 * n[6]) return std::nullopt;
  const auto count = [&](std::size_t i) { return static_cast<int>(n[i]); };
  return Head{count(0), count(1), count(2), count(3), count(4), count(5), count(6), count(7)};
}

/// Returns the number of elements with which the head would fit the file, if it is the only error of the head.
std::optional<int> fitting_elements(std::span<const double> n) {
  constexpr std::size_t kElementSize = 6;
  if (n.size() < kHeadSize || !is_whole(n[0]) || n[0] < 1 || !is_whole(n[4])) return std::nullopt;
  std::vector<double> one(n.begin(), n.begin() + kHeadSize);
  one[0] = 1;
  const auto head = head_of(one);
  if (!head || head->total() > n.size() || (n.size() - head->total()) % kElementSize != 0) return std::nullopt;
  const auto elements = static_cast<double>(1 + (n.size() - head->total()) / kElementSize);
  if (kSlotsAnElement * elements > n[4]) return std::nullopt;
  return static_cast<int>(elements);
}

Recognition recognise(const Tokens& tokens) {
  using Fit = Recognition::Fit;
  const auto head = head_of(tokens.numbers);
  if (const auto elements = head ? std::nullopt : fitting_elements(tokens.numbers))
    return {Fit::damaged, fmt::format("8-number head whose counts would fit {} elements, not {}", *elements,
                                      format_real(tokens.numbers[0]))};
  if (!head) return {};
  const std::size_t have = tokens.numbers.size();
  const std::string evidence =
      fmt::format("8-number head with {} elements and {} covers gives {} numbers, the file has {}", head->elements,
                  head->covers, head->total(), have);
  if (head->total() == have) return {Fit::exact, evidence};
  return {head->total() < have ? Fit::surplus : Fit::damaged, evidence};
}

/// Reads a cover file. Every list is as long as its count, which the words of the file have confirmed.
class CoverReader {
 public:
  explicit CoverReader(const Tokens& tokens) : tokens_(tokens), cursor_(tokens) {}

  Reading read() {
    read_head();
    read_points("fixed point", head_.fixed, 0, cover_.fixed_points);
    read_points("loading point", head_.loading, 1, cover_.loading_points);
    read_points("measured point", head_.measured, 0, cover_.measured_points);
    read_lists();
    place_elements();
    cursor_.leave();
    Reading reading;
    reading.content.cover = std::move(cover_);
    reading.warnings = joined(std::move(warnings_), cursor_.remainder());
    return reading;
  }

 private:
  void read_head() {
    const auto next = [&](int least, std::string_view name) {
      const Place place = cursor_.place();
      const int count = cursor_.next_count(name);
      if (count >= least) return count;
      throw InputError(place, fmt::format("expected {} ({} or more), found \"{}\"", name, least, count));
    };
    const Place first = cursor_.place();
    head_.elements = next(1, "the number of elements");
    head_.fixed = next(0, "the number of fixed points");
    head_.loading = next(0, "the number of loading points");
    head_.measured = next(0, "the number of measured points");
    head_.slots = next(4, "the number of vertex slots");
    head_.covers = next(3, "the number of physical covers");
    head_.loops = next(0, "the number of loops");
    head_.loop_slots = next(0, "the number of loop-vertex slots");
    if (head_.elements > head_.slots / kSlotsAnElement)
      throw InputError(
          first, fmt::format("expected the number of elements (at most {}: there are {} vertex slots), found \"{}\"",
                             head_.slots / kSlotsAnElement, head_.slots, head_.elements));
  }

  /// Reads the positions, most of a long file, on a separate thread. The error of the first list in the file is
  /// reported.
  void read_lists() {
    CoverReader positions = *this;
    const std::size_t count = 2 * (static_cast<std::size_t>(head_.slots) + static_cast<std::size_t>(head_.covers));
    const auto policy = count > kManyNumbers ? std::launch::async : std::launch::deferred;
    std::future<void> positions_read = std::async(policy, [&] { positions.skip_elements_and_read_positions(); });
    read_elements();
    try {
      cursor_.skip(count);
      read_covers_of_elements();
      read_loops();
      read_loop_vertices();
    } catch (const InputError&) {
      positions_read.get();
      throw;
    }
    positions_read.get();
    cover_.vertices = std::move(positions.cover_.vertices);
    cover_.nodes = std::move(positions.cover_.nodes);
  }

  void skip_elements_and_read_positions() {
    cursor_.skip(3 * static_cast<std::size_t>(head_.elements));
    read_positions("vertex slot", head_.slots, cover_.vertices);
    read_positions("physical cover", head_.covers, cover_.nodes);
  }

  void enter(std::string_view noun, int number, int of) {
    cursor_.enter({noun, static_cast<std::size_t>(number) + 1, static_cast<std::size_t>(of)});
  }

  int next_index_of(int count, std::string_view name) { return cursor_.next_integer_between(1, count, name) - 1; }

  /// `least_element` 0: a point in no element is left out; 1: it is rejected.
  void read_points(std::string_view noun, int count, int least_element, std::vector<CoverPoint>& points) {
    reserve_large(points, static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
      enter(noun, i, count);
      CoverPoint point;
      point.place = cursor_.place();
      point.position.x = cursor_.next_real("x");
      point.position.y = cursor_.next_real("y");
      point.element = cursor_.next_integer_between(least_element, head_.elements, "the element") - 1;
      if (point.element >= 0) {
        points.push_back(point);
        continue;
      }
      const Facts facts{{}, {{"noun", std::string(noun)}}, {}, {{point.position.x, point.position.y}}};
      add_warning(warnings_, warning_of({"point_outside_elements", facts}, point.place));
    }
  }

  /// Requires at least 3 corners, and space for the first again.
  SlotRange next_range(int slots, std::string_view first_name, std::string_view last_name) {
    const int first = cursor_.next_integer_between(1, slots - 3, first_name);
    const int last = cursor_.next_integer_between(first + 2, slots - 1, last_name);
    return {first - 1, last - first + 1};
  }

  void read_elements() {
    reserve_large(cover_.elements, static_cast<std::size_t>(head_.elements));
    for (int i = 0; i < head_.elements; ++i) {
      enter("element", i, head_.elements);
      CoverElement element{};
      element.vertices = next_range(head_.slots, "the first vertex slot", "the last vertex slot");
      element.material = cursor_.next_index("the block material");
      cover_.elements.push_back(element);
    }
  }

  void read_positions(std::string_view noun, int count, std::vector<Point>& points) {
    reserve_large(points, static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
      enter(noun, i, count);
      const double x = cursor_.next_real("x");
      points.push_back({x, cursor_.next_real("y")});
    }
  }

  /// Stores the places only if there are few elements: for all it would take longer than reading them.
  void place_elements() {
    const std::size_t points = cover_points();
    const bool are_few = cover_.elements.size() <= kFewElements;
    for (std::size_t i = 0; i < cover_.elements.size(); ++i)
      if (are_few || !(area(cover_.polygon(cover_.elements[i])) > 0))
        cover_.elements[i].place = tokens_.place_of(kHeadSize + 3 * (points + i));
  }

  std::size_t cover_points() const {
    return static_cast<std::size_t>(head_.fixed) + static_cast<std::size_t>(head_.loading) +
           static_cast<std::size_t>(head_.measured);
  }

  void read_covers_of_elements() {
    for (int i = 0; i < head_.elements; ++i) {
      enter("element", i, head_.elements);
      for (int& cover : cover_.elements[static_cast<std::size_t>(i)].covers)
        cover = next_index_of(head_.covers, "a physical cover");
    }
  }

  void read_loops() {
    reserve_large(cover_.loops, static_cast<std::size_t>(head_.loops));
    for (int i = 0; i < head_.loops; ++i) {
      enter("loop", i, head_.loops);
      cover_.loops.push_back(next_range(head_.loop_slots, "the first loop-vertex slot", "the last loop-vertex slot"));
    }
  }

  void read_loop_vertices() {
    reserve_large(cover_.loop_vertices, static_cast<std::size_t>(head_.loop_slots));
    for (int i = 0; i < head_.loop_slots; ++i) {
      enter("loop-vertex slot", i, head_.loop_slots);
      const int slot = next_index_of(head_.slots, "the vertex slot");
      cover_.loop_vertices.push_back({slot, cursor_.next_index("the joint material")});
    }
  }

  const Tokens& tokens_;
  Cursor cursor_;
  Head head_{};
  Cover cover_;
  Warnings warnings_;
};

Reading read_tokens(const Tokens& tokens, const ReadHint&) {
  Reading reading = CoverReader(tokens).read();
  reading.content.cover->place = {tokens.map->file()};
  return reading;
}

/// Writes element numbers of points as reals, as in every known file.
void write_points(std::string& text, const std::vector<CoverPoint>& points) {
  for (const CoverPoint& point : points)
    fmt::format_to(std::back_inserter(text), "{} {} {}.000000\n", format_real(point.position.x),
                   format_real(point.position.y), point.element + 1);
}

void write_row(std::string& text, std::initializer_list<int> row) {
  for (const int value : row) {
    append_integer(text, value);
    text += ' ';
  }
  text.back() = '\n';
}

void write_positions(std::string& text, const std::vector<Point>& points) {
  for (const Point& point : points) {
    append_real(text, point.x);
    text += ' ';
    append_real(text, point.y);
    text += '\n';
  }
}

std::string write(const Content& content) {
  if (!content.cover) throw std::invalid_argument("a cover file needs a cover");
  const Cover& cover = *content.cover;
  std::string text = fmt::format("{} {} {} {}\n{} {} {} {}\n", cover.elements.size(), cover.fixed_points.size(),
                                 cover.loading_points.size(), cover.measured_points.size(), cover.vertices.size(),
                                 cover.nodes.size(), cover.loops.size(), cover.loop_vertices.size());
  write_points(text, cover.fixed_points);
  write_points(text, cover.loading_points);
  write_points(text, cover.measured_points);
  for (const CoverElement& element : cover.elements) {
    const SlotRange& slots = element.vertices;
    write_row(text, {slots.first + 1, slots.first + slots.size, element.material + 1});
  }
  write_positions(text, cover.vertices);
  write_positions(text, cover.nodes);
  for (const CoverElement& element : cover.elements)
    write_row(text, {element.covers[0] + 1, element.covers[1] + 1, element.covers[2] + 1});
  for (const SlotRange& loop : cover.loops) write_row(text, {loop.first + 1, loop.first + loop.size});
  for (const LoopVertex& vertex : cover.loop_vertices) write_row(text, {vertex.slot + 1, vertex.joint_material + 1});
  return text;
}

}  // namespace

constinit const Format kNmmCover{
    .name = "nmm-cover",
    .title = "NMM cover file (cv)",
    .read = read_split<read_tokens>,
    .write = write,
    .recognise_numbers = recognise,
    .read_tokens = read_tokens,
    .evidence = "data, to the last number of 15 files",
    .sample =
        "2 1 1 2\n8 6 2 8\n0.25 0 1\n0.5 1 2\n0.75 0.5 1\n0.25 0.75 2\n5 7 1\n1 3 0\n0 0\n1 1\n0 1\n0 0\n0 0\n1 0\n"
        "1 1\n0 0\n0 0\n0 0\n1 0\n0 1\n1 1\n1 1\n1 3 5\n2 6 4\n1 3\n5 7\n5 1\n6 1\n7 2\n5 1\n1 2\n2 1\n3 1\n1 2\n"};

}  // namespace keyblock::formats
