// Finds the palette first, then writes its chunks and the compressed rows.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/png.hpp"

#include <zlib.h>

#include <array>
#include <optional>
#include <stdexcept>

namespace keyblock::report {
namespace {

constexpr std::size_t kMostColours = 256;  // of a palette with one byte per pixel
constexpr std::size_t kSlots = 1024;       // of the hash table: a power of two, four per colour
constexpr int kLevel = 3;                  // of zlib: 6 takes twice the time for 5 % less

struct Indexed {
  std::vector<std::uint32_t> palette;
  std::string rows;  ///< a filter byte, then one index per pixel
};

/// Index of each colour, found by open addressing.
class Palette {
 public:
  explicit Palette(std::uint32_t mask) : mask_(mask) { slots_.fill(-1); }

  /// Index of the first colour met that is equal under the mask; nothing if the palette is full.
  std::optional<std::uint8_t> index_of(std::uint32_t colour) {
    const std::uint32_t key = colour & mask_;
    for (std::size_t slot = (key * 2654435761U) >> 22;; slot = (slot + 1) % kSlots) {
      const int found = slots_[slot];
      if (found >= 0 && (colours_[static_cast<std::size_t>(found)] & mask_) == key)
        return static_cast<std::uint8_t>(found);
      if (found >= 0) continue;
      if (colours_.size() == kMostColours) return std::nullopt;
      slots_[slot] = static_cast<int>(colours_.size());
      colours_.push_back(colour);
      return static_cast<std::uint8_t>(colours_.size() - 1);
    }
  }

  const std::vector<std::uint32_t>& colours() const { return colours_; }

 private:
  std::uint32_t mask_;
  std::array<int, kSlots> slots_{};
  std::vector<std::uint32_t> colours_;
};

/// Nothing if more colours than a palette holds differ under the mask.
std::optional<Indexed> indexed(const Image& image, std::uint32_t mask) {
  Palette palette(mask);
  Indexed out;
  out.rows.reserve(image.pixels.size() + static_cast<std::size_t>(image.height));
  std::uint32_t last = 0;
  char last_index = 0;
  bool is_first = true;
  auto pixel = image.pixels.begin();
  for (int row = 0; row < image.height; ++row) {
    out.rows += '\0';
    for (int column = 0; column < image.width; ++column, ++pixel) {
      if (is_first || *pixel != last) {
        const auto index = palette.index_of(*pixel);
        if (!index) return std::nullopt;
        last = *pixel;
        last_index = static_cast<char>(*index);
        is_first = false;
      }
      out.rows += last_index;
    }
  }
  out.palette = palette.colours();
  return out;
}

Indexed indexed(const Image& image) {
  std::uint32_t channel = 0xFF;
  for (;; channel = (channel << 1) & 0xFF)
    if (auto found = indexed(image, channel * 0x01010101U)) return *std::move(found);
}

void add_number(std::string& bytes, std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>((value >> shift) & 0xFF);
}

void add_chunk(std::string& bytes, std::string_view kind, std::string_view data) {
  add_number(bytes, static_cast<std::uint32_t>(data.size()));
  const std::size_t start = bytes.size();
  bytes += kind;
  bytes += data;
  const auto* from = reinterpret_cast<const Bytef*>(bytes.data() + start);
  add_number(bytes, static_cast<std::uint32_t>(crc32(0, from, static_cast<uInt>(bytes.size() - start))));
}

std::string compressed(const std::string& data) {
  uLongf size = compressBound(data.size());
  std::string packed(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(data.data()),
                data.size(), kLevel) != Z_OK)
    throw std::runtime_error("zlib cannot compress a picture");
  packed.resize(size);
  return packed;
}

}  // namespace

std::string png_of(const Image& image) {
  const Indexed found = indexed(image);
  std::string head, colours, opacities;
  add_number(head, static_cast<std::uint32_t>(image.width));
  add_number(head, static_cast<std::uint32_t>(image.height));
  head += std::string_view("\x08\x03\0\0\0", 5);  // 8 bits, indices; the only methods; rows in order
  for (const std::uint32_t colour : found.palette) {
    for (const int shift : {16, 8, 0}) colours += static_cast<char>((colour >> shift) & 0xFF);
    opacities += static_cast<char>(colour >> 24);
  }
  std::string bytes("\x89PNG\r\n\x1a\n");
  add_chunk(bytes, "IHDR", head);
  add_chunk(bytes, "PLTE", colours);
  add_chunk(bytes, "tRNS", opacities);
  add_chunk(bytes, "IDAT", compressed(found.rows));
  add_chunk(bytes, "IEND", {});
  return bytes;
}

Image halved(const Image& image) {
  Image half{(image.width + 1) / 2, (image.height + 1) / 2, {}};
  half.pixels.reserve(static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
  for (int row = 0; row < image.height; row += 2)
    for (int column = 0; column < image.width; column += 2)
      half.pixels.push_back(image.pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                                         static_cast<std::size_t>(column)]);
  return half;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : kDigits[(three >> (18 - 6 * k)) & 0x3F];
  }
  return text;
}

}  // namespace keyblock::report
