// Gathers frames into chunks; see page_writer.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page/page_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "report/page/page_bytes.hpp"
#include "report/page/page_html.hpp"

namespace keyblock::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kSamePlace = 1e-9;  // of the extent

struct Extent {
  Point least, most;

  Point middle() const { return 0.5 * (least + most); }
  double size() const { return std::max(most.x - least.x, most.y - least.y); }
};

Extent extent_of(const std::vector<Point>& places) {
  if (places.empty()) return {};
  Extent found{places[0], places[0]};
  for (const Point p : places) {
    found.least = {std::min(found.least.x, p.x), std::min(found.least.y, p.y)};
    found.most = {std::max(found.most.x, p.x), std::max(found.most.y, p.y)};
  }
  return found;
}

bool is_same(const PageShape& a, const PageShape& b) {
  if (a.key != b.key || a.number != b.number || a.material != b.material || a.kind != b.kind ||
      a.loop_body != b.loop_body || a.loop_size != b.loop_size)
    return false;
  const double reach = kSamePlace * extent_of(a.places).size();
  return std::ranges::equal(a.places, b.places, [&](Point p, Point q) { return distance(p, q) <= reach; });
}

std::string_view word_for(PageRowsOf on) {
  return on == PageRowsOf::body ? "body" : "vertex";
}

/// Words of all frames of a field, in the order [part][frame][row], each frame as its difference from the one before.
class FieldWords {
 public:
  FieldWords(std::size_t parts, std::size_t frames, std::size_t rows)
      : parts_(parts), frames_(frames), rows_(rows), words_(parts * frames * rows) {}

  void set(std::size_t part, std::size_t frame, std::size_t row, double value, int bits) {
    words_[(part * frames_ + frame) * rows_ + row] = rounded_bits(value, bits);
  }
  std::string bytes() && {
    const std::size_t size = frames_ * rows_;
    for (std::size_t part = 0; part < parts_ && rows_ > 0; ++part)
      subtract_rows(std::span(words_).subspan(part * size, size), rows_);
    return byte_planes(words_);
  }

 private:
  std::size_t parts_, frames_, rows_;
  std::vector<std::uint32_t> words_;
};

const PageValues* values_of(const PageFrame& frame, const std::string& name) {
  const auto found = std::ranges::find(frame.values, name, [](const PageValues& v) { return v.field.name; });
  return found == frame.values.end() ? nullptr : &*found;
}

const PageRows* rows_of(const PageFrame& frame, const std::string& name) {
  const auto found = std::ranges::find(frame.parts, name, &PageRows::name);
  return found == frame.parts.end() ? nullptr : &*found;
}

Json columns_json(const PageRows& rows) {
  Json columns = Json::array();
  for (const PageColumn& column : rows.columns) {
    Json entry{{"name", column.name},
               {"unit", column.unit},
               {"parts", column.parts},
               {"type", column.is_whole ? "u32" : "f32"}};
    if (!column.states.empty()) entry["names"] = column.states;
    columns.push_back(std::move(entry));
  }
  return columns;
}

void add_words(std::vector<std::uint32_t>& words, const PageColumn& column, Point origin) {
  for (std::size_t i = 0; i < column.numbers.size(); ++i) {
    const double number = column.numbers[i];
    if (column.is_whole)
      words.push_back(static_cast<std::uint32_t>(std::max(number, 0.0)));
    else if (column.is_place)
      words.push_back(rounded_bits(number - (i % 2 == 0 ? origin.x : origin.y), kPlaceBits));
    else
      words.push_back(rounded_bits(number, kRowBits));
  }
}

}  // namespace

Point origin_of(const PageShape& first) {
  return extent_of(first.places).middle();
}

PageWriter::PageWriter(Point origin, PageShape shape) : packs_(false), origin_(origin), shape_(std::move(shape)) {
  centroids_ = centroids_of(*shape_);
}

void PageWriter::add(PageFrame frame) {
  if (!origin_) origin_ = origin_of(frame.shape);
  const bool is_new = !shape_ || !is_same(*shape_, frame.shape);
  if (is_new || waiting_.size() == kFramesOfChunk) write_chunks();
  if (is_new) begin_epoch(frame.shape);
  frames_.push_back({{"step", frame.step},
                     {"time", frame.time},
                     {"load_factor", frame.load_factor ? Json(*frame.load_factor) : Json()},
                     {"epoch", epoch()},
                     {"stage", frame.stage},
                     {"is_static", frame.is_static}});
  motions_.push_back(motions_of(*shape_, centroids_, frame.moves));
  frame.shape = {};
  waiting_.push_back(std::move(frame));
}

void PageWriter::begin_epoch(const PageShape& shape) {
  shape_ = shape;
  centroids_ = centroids_of(shape);
  const auto word = [](std::size_t count) { return static_cast<std::uint32_t>(count); };
  std::vector<std::uint32_t> words{word(shape.bodies()), word(shape.loop_body.size()), word(shape.places.size())};
  for (const std::vector<std::uint32_t>* list : {&shape.key, &shape.number, &shape.material, &shape.kind})
    words.insert(words.end(), list->begin(), list->end());
  const auto add_place = [&](Point p) {
    words.push_back(rounded_bits(p.x, 23));
    words.push_back(rounded_bits(p.y, 23));
  };
  for (const Point centroid : centroids_) add_place(centroid - *origin_);
  words.insert(words.end(), shape.loop_body.begin(), shape.loop_body.end());
  words.insert(words.end(), shape.loop_size.begin(), shape.loop_size.end());
  std::size_t v = 0;
  for (std::size_t loop = 0; loop < shape.loop_size.size(); ++loop)
    for (std::uint32_t k = 0; k < shape.loop_size[loop]; ++k, ++v)
      add_place(shape.places[v] - centroids_[shape.loop_body[loop]]);
  epochs_.push_back({{"bodies", shape.bodies()},
                     {"loops", shape.loop_body.size()},
                     {"vertices", shape.places.size()},
                     {"geometry", add_text(little_endian(words))}});
}

std::string PageWriter::add_text(std::string bytes) {
  return texts_.emplace_back(fmt::format("c{}", texts_.size()), packs_ ? packed_text(bytes) : std::move(bytes)).first;
}

Json& PageWriter::add_chunk(const std::string& what, std::string bytes) {
  chunks_.push_back({{"id", add_text(std::move(bytes))},
                     {"what", what},
                     {"from", written_},
                     {"to", written_ + waiting_.size() - 1},
                     {"epoch", epoch()}});
  return chunks_.back();
}

void PageWriter::name_field(const PageField& field, int bits) {
  if (std::ranges::any_of(fields_, [&](const Json& known) { return known["name"] == field.name; })) return;
  Json entry{{"name", field.name},
             {"label", field.label},
             {"unit", field.unit},
             {"on", word_for(field.on)},
             {"parts", field.parts()}};
  if (!field.components.empty()) entry["components"] = field.components;
  entry["bits"] = bits;
  entry["kind"] = field.states.empty() ? "real" : "state";
  if (!field.states.empty()) entry["names"] = field.states;
  fields_.push_back(std::move(entry));
}

void PageWriter::write_chunks() {
  if (waiting_.empty()) return;
  write_motion();
  if (std::ranges::any_of(motions_, [](const BodyMotions& m) { return !m.is_exact; })) write_vertex_motion();
  write_fields();
  write_parts();
  written_ += waiting_.size();
  waiting_.clear();
  motions_.clear();
}

void PageWriter::write_motion() {
  name_field({"motion", "Motion", "", PageRowsOf::body, {"ux", "uy", "g11", "g12", "g21", "g22"}}, kMotionBits);
  FieldWords words(6, waiting_.size(), shape_->bodies());
  for (std::size_t part = 0; part < 6; ++part)
    for (std::size_t f = 0; f < waiting_.size(); ++f)
      for (std::size_t b = 0; b < shape_->bodies(); ++b)
        words.set(part, f, b, motions_[f].bodies[b][part], kMotionBits);
  add_chunk("motion", std::move(words).bytes());
}

void PageWriter::write_vertex_motion() {
  name_field({"vertex_motion", "Displacement of corners", "", PageRowsOf::vertex, {"x", "y"}}, kMotionBits);
  FieldWords words(2, waiting_.size(), shape_->places.size());
  for (std::size_t f = 0; f < waiting_.size(); ++f)
    for (std::size_t v = 0; v < shape_->places.size(); ++v) {
      words.set(0, f, v, waiting_[f].moves[v].x, kMotionBits);
      words.set(1, f, v, waiting_[f].moves[v].y, kMotionBits);
    }
  add_chunk("vertex_motion", std::move(words).bytes());
}

void PageWriter::write_fields() {
  std::vector<std::string> names;
  for (const PageFrame& frame : waiting_)
    for (const PageValues& values : frame.values)
      if (std::ranges::find(names, values.field.name) == names.end()) {
        names.push_back(values.field.name);
        write_field(values.field);
      }
}

void PageWriter::write_field(const PageField& field) {
  const int bits = field.states.empty() ? field.bits : 23;
  name_field(field, bits);
  const std::size_t parts = field.parts();
  const std::size_t rows = field.on == PageRowsOf::body ? shape_->bodies() : shape_->places.size();
  FieldWords words(parts, waiting_.size(), rows);
  for (std::size_t f = 0; f < waiting_.size(); ++f) {
    const PageValues* values = values_of(waiting_[f], field.name);
    for (std::size_t part = 0; part < parts; ++part)
      for (std::size_t row = 0; row < rows; ++row)
        words.set(part, f, row, values == nullptr ? NAN : values->numbers[row * parts + part], bits);
  }
  add_chunk(field.name, std::move(words).bytes());
}

void PageWriter::write_parts() {
  std::vector<std::string> names;
  for (const PageFrame& frame : waiting_)
    for (const PageRows& rows : frame.parts)
      if (std::ranges::find(names, rows.name) == names.end()) names.push_back(rows.name);
  for (const std::string& name : names) write_part(name);
}

// Writes the frames that recorded this part.
void PageWriter::write_part(const std::string& name) {
  std::vector<const PageRows*> recorded;
  Json indices = Json::array();
  for (std::size_t f = 0; f < waiting_.size(); ++f)
    if (const PageRows* rows = rows_of(waiting_[f], name)) {
      recorded.push_back(rows);
      indices.push_back(written_ + f);
    }
  const PageRows& like = *recorded.front();
  if (!parts_.contains(name)) parts_[name] = {{"columns", columns_json(like)}};
  std::vector<std::uint32_t> words;
  for (const PageRows* rows : recorded) words.push_back(static_cast<std::uint32_t>(rows->count));
  for (std::size_t c = 0; c < like.columns.size(); ++c)
    for (const PageRows* rows : recorded) add_words(words, rows->columns[c], *origin_);
  Json& chunk = add_chunk(name, byte_planes(words));
  if (recorded.size() < waiting_.size()) chunk["frames"] = std::move(indices);
}

Json PageWriter::members() {
  write_chunks();
  return {{"frames", std::move(frames_)},
          {"epochs", std::move(epochs_)},
          {"fields", std::move(fields_)},
          {"chunks", std::move(chunks_)},
          {"parts", std::move(parts_)}};
}

std::string PageWriter::finish(Json head) && {
  const Point origin = origin_.value_or(Point{});
  head["origin"] = {origin.x, origin.y};
  head.update(members());
  return page_with(head, texts_);
}

PageUpdate PageWriter::update() && {
  PageUpdate found{members(), {}};
  for (const auto& [id, bytes] : texts_) {
    found.head["sizes"][id] = bytes.size();
    found.bytes += bytes;
  }
  return found;
}

}  // namespace keyblock::report
