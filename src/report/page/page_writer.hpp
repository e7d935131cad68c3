// Writes the frames of a run as the data of its page: a head (JSON) and chunks of numbers (base64 of zlib).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Head: format "keyblock-page", version 1, program, title, precision, units, materials, joints, tables, still,
// verdict (tone, words, reason), run (the record). `origin` is taken off all places. Frames have step, time,
// load_factor, epoch, stage, is_static. Epochs have bodies, loops, vertices, and geometry, the id of its chunk.
// Fields have name, label, unit, on, parts, components, bits, kind, names. Chunks have id, what, from, to, epoch,
// and frames if not all. `parts` has the columns of the tables in time. All words have four bytes, the lowest first.
// Geometry of an epoch: counts B, L, V of bodies, loops, corners; key[B], number[B], material[B], kind[B]; centroid[2B]
// from the origin; loop_body[L] (row), loop_size[L]; place[2V] from the centroid of the body. Holes by the even-odd
// rule.
// Field: floats in the order [part][frame][row], rounded to `bits` bits of fraction. Each frame is its exclusive or
// with the frame before in the chunk. Byte planes follow: all lowest bytes first. `motion` of a body: ux, uy, g11, g12,
// g21, g22; a corner at X from the centroid moves by u + G X. `vertex_motion` is there if bodies of a chunk move
// otherwise.
// Table in time: count[frames], then each column's numbers of all frames, in byte planes.
// A chunk has at most 25 frames, all of one epoch. An epoch ends if a body goes, comes or changes its undeformed shape.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "report/page/affine_motion.hpp"
#include "report/page/page_bytes.hpp"
#include "report/page/page_frame.hpp"
#include "report/page/page_html.hpp"

namespace keyblock::report {

inline constexpr std::size_t kFramesOfChunk = 25;
inline constexpr int kMotionBits = 14;
inline constexpr int kRowBits = 12;    ///< of contacts, bolts and other tables in time
inline constexpr int kPlaceBits = 18;  ///< of places in such tables

/// Returns the place that a page counts from if this is the shape of its first frame: the middle of all corners.
Point origin_of(const PageShape& first);

/// New frames for a page. `head` has frames, epochs, fields, chunks and parts; `sizes` has the bytes of each chunk by
/// its id. Frames and new epochs count from 0; -1 is the last epoch of the page.
struct PageUpdate {
  nlohmann::ordered_json head;
  std::string bytes;  ///< chunk after chunk, not packed
};

class PageWriter {
 public:
  PageWriter() = default;

  /// Goes on where a page ends that counts from `origin`, and whose last epoch has this shape.
  PageWriter(Point origin, PageShape shape);

  /// Adds the next frame. A body that changed begins a new epoch.
  void add(PageFrame frame);

  /// Returns the place that the page counts from: the middle of the first frame. Precondition: there is a frame.
  Point origin() const { return *origin_; }

  /// Returns the page: the built one with the head and the chunks. `head` has the members that frames do not give.
  std::string finish(nlohmann::ordered_json head) &&;

  PageUpdate update() &&;

 private:
  nlohmann::ordered_json members();
  int epoch() const { return static_cast<int>(epochs_.size()) - 1; }
  void begin_epoch(const PageShape& shape);
  void write_chunks();
  void write_motion();
  void write_vertex_motion();
  void write_fields();
  void write_field(const PageField& field);
  void write_parts();
  void write_part(const std::string& name);
  void name_field(const PageField& field, int bits);
  nlohmann::ordered_json& add_chunk(const std::string& what, std::string bytes);
  std::string add_text(std::string bytes);

  nlohmann::ordered_json frames_ = nlohmann::ordered_json::array();
  nlohmann::ordered_json epochs_ = nlohmann::ordered_json::array();
  nlohmann::ordered_json fields_ = nlohmann::ordered_json::array();
  nlohmann::ordered_json chunks_ = nlohmann::ordered_json::array();
  nlohmann::ordered_json parts_ = nlohmann::ordered_json::object();
  std::vector<PageText> texts_;
  bool packs_ = true;  ///< as base64 of zlib
  std::optional<Point> origin_;
  std::optional<PageShape> shape_;    ///< of the epoch
  std::vector<Point> centroids_;      ///< of the epoch
  std::vector<PageFrame> waiting_;    ///< frames of the next chunk, without their shapes
  std::vector<BodyMotions> motions_;  ///< of those
  std::size_t written_ = 0;           ///< frames in chunks
};

}  // namespace keyblock::report
