// Unpacks the chunks of a page; written independently of the code that packs them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/page_reading.hpp"

#include <zlib.h>

#include <cstring>
#include <stdexcept>

namespace keyblock::support {
namespace {

using Json = nlohmann::json;

std::string from_base64(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::size_t value = letters.find(c);
    if (value == std::string::npos) continue;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    count += 6;
    if (count >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 0xff);
  }
  return bytes;
}

std::string inflated(const std::string& packed) {
  std::string bytes;
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) throw std::runtime_error("zlib");
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  char part[65536];
  int state = Z_OK;
  while (state == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(part);
    stream.avail_out = sizeof part;
    state = inflate(&stream, Z_NO_FLUSH);
    bytes.append(part, sizeof part - stream.avail_out);
  }
  inflateEnd(&stream);
  if (state != Z_STREAM_END) throw std::runtime_error("the chunk is cut");
  return bytes;
}

std::string between(const std::string& text, const std::string& opening) {
  const std::size_t at = text.find(opening);
  if (at == std::string::npos) throw std::out_of_range("no " + opening);
  const std::size_t first = at + opening.size();
  return text.substr(first, text.find("</script>", first) - first);
}

float as_float(std::uint32_t word) {
  float value = 0;
  std::memcpy(&value, &word, sizeof value);
  return value;
}

std::vector<std::uint32_t> words_in_turn(const std::string& bytes) {
  std::vector<std::uint32_t> words(bytes.size() / 4);
  std::memcpy(words.data(), bytes.data(), 4 * words.size());
  return words;
}

std::vector<std::uint32_t> words_of_planes(const std::string& bytes) {
  const std::size_t count = bytes.size() / 4;
  std::vector<std::uint32_t> words(count, 0);
  for (std::size_t plane = 0; plane < 4; ++plane)
    for (std::size_t i = 0; i < count; ++i)
      words[i] |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[plane * count + i])) << (8 * plane);
  return words;
}

}  // namespace

ReadPage::ReadPage(std::string text)
    : text_(std::move(text)),
      head_(Json::parse(between(text_, "<script type=\"application/json\" id=\"keyblock-head\">"))) {}

std::string ReadPage::bytes(const std::string& id) const {
  return inflated(from_base64(between(text_, "<script type=\"text/plain\" id=\"" + id + "\">")));
}

const Json& ReadPage::chunk(const std::string& what, std::size_t frame) const {
  for (const Json& chunk : head_.at("chunks"))
    if (chunk.at("what") == what && chunk.at("from") <= frame && frame <= chunk.at("to")) return chunk;
  throw std::out_of_range("no chunk of " + what);
}

ReadShape ReadPage::shape(std::size_t epoch) const {
  const std::vector<std::uint32_t> words = words_in_turn(bytes(head_.at("epochs").at(epoch).at("geometry")));
  std::size_t at = 3;
  const auto take = [&](std::size_t count) {
    at += count;
    return std::vector<std::uint32_t>(words.begin() + static_cast<std::ptrdiff_t>(at - count),
                                      words.begin() + static_cast<std::ptrdiff_t>(at));
  };
  const auto take_floats = [&](std::size_t count) {
    std::vector<float> floats;
    for (const std::uint32_t word : take(count)) floats.push_back(as_float(word));
    return floats;
  };
  ReadShape shape;
  for (auto* list : {&shape.key, &shape.number, &shape.material, &shape.kind}) *list = take(words[0]);
  shape.centroid = take_floats(2 * words[0]);
  shape.loop_body = take(words[1]);
  shape.loop_size = take(words[1]);
  shape.place = take_floats(2 * words[2]);
  if (at != words.size()) throw std::runtime_error("the geometry has another length");
  return shape;
}

float ReadPage::value(const std::string& field, std::size_t part, std::size_t frame, std::size_t row) const {
  const Json& found = chunk(field, frame);
  std::size_t parts = 0;
  for (const Json& known : head_.at("fields"))
    if (known.at("name") == field) parts = known.at("parts");
  const std::size_t from = found.at("from"), frames = found.at("to").get<std::size_t>() - from + 1;
  const std::vector<std::uint32_t> words = words_of_planes(bytes(found.at("id")));
  const std::size_t rows = words.size() / (parts * frames);
  std::uint32_t word = 0;
  for (std::size_t f = 0; f <= frame - from; ++f) word ^= words.at((part * frames + f) * rows + row);
  return as_float(word);
}

std::map<std::string, std::vector<double>> ReadPage::rows(const std::string& what, std::size_t frame) const {
  const Json& found = chunk(what, frame);
  std::vector<std::size_t> frames;
  if (found.contains("frames"))
    frames = found.at("frames").get<std::vector<std::size_t>>();
  else
    for (std::size_t f = found.at("from"); f <= found.at("to"); ++f) frames.push_back(f);
  const std::vector<std::uint32_t> words = words_of_planes(bytes(found.at("id")));
  std::map<std::string, std::vector<double>> columns;
  std::size_t at = frames.size();
  for (const Json& column : head_.at("parts").at(what).at("columns")) {
    std::vector<double>& numbers = columns[column.at("name")];
    const std::size_t parts = column.at("parts");
    for (std::size_t f = 0; f < frames.size(); ++f)
      for (std::size_t i = 0; i < parts * words.at(f); ++i, ++at)
        if (frames[f] == frame)
          numbers.push_back(column.at("type") == "u32" ? words.at(at) : static_cast<double>(as_float(words.at(at))));
  }
  if (at != words.size()) throw std::runtime_error("the chunk has another length");
  return columns;
}

}  // namespace keyblock::support
