// Writes and reads arrays of numbers in VTK's XML files; see vtk_file.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/views/vtk_file.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <stdexcept>
#include <type_traits>

#include "base/error.hpp"
#include "formats/text/numbers.hpp"

namespace keyblock::formats {
namespace {

static_assert(std::endian::native == std::endian::little, "bytes are written as the machine has them");

constexpr std::array<std::string_view, 4> kNames{"automatic", "raw", "zlib", "text"};
constexpr std::string_view kPlaces = "Points";
constexpr std::size_t kManyPoints = 2000;  // frames of fewer are so small that packing gains nothing
constexpr std::string_view kOpening = "<AppendedData encoding=\"raw\">";
constexpr std::string_view kPacker = "vtkZLibDataCompressor";
constexpr std::size_t kPackedAtOnce = 1 << 15;  // bytes per block of zlib, as in VTK
constexpr std::size_t kBytesOfPoint = 128;      // more than a frame has; a string that grows is copied
constexpr std::size_t kWord = sizeof(std::uint64_t);

template <class T>
constexpr std::string_view type_name() {
  if constexpr (std::is_same_v<T, double>) return "Float64";
  if constexpr (std::is_same_v<T, float>) return "Float32";
  if constexpr (std::is_same_v<T, std::int32_t>) return "Int32";
  if constexpr (std::is_same_v<T, std::uint8_t>) return "UInt8";
}

std::string number_text(double value) {
  return format_real(value);
}
std::string number_text(float value) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}
std::string number_text(int value) {
  return std::to_string(value);
}

void append_word(std::string& bytes, std::uint64_t value) {
  std::array<char, kWord> word;
  std::memcpy(word.data(), &value, kWord);
  bytes.append(word.data(), kWord);
}

// Level 1: compressible data reach most of their compression at once.
constexpr VtkPacking kPacked{Z_BEST_SPEED, Z_DEFAULT_STRATEGY};
// Every third number of a vector is 0. The digits of the others do not repeat: a search for earlier ones is in vain.
constexpr VtkPacking kRuns{Z_BEST_SPEED, Z_RLE};
constexpr VtkPacking kStored{Z_NO_COMPRESSION, Z_DEFAULT_STRATEGY};

/// Appends bytes as zlib stores them if it packs nothing: one block, and their checksum.
void store(std::span<const std::uint8_t> bytes, std::string& text) {
  static_assert(kPackedAtOnce <= 0xFFFF);
  const auto size = static_cast<std::uint16_t>(bytes.size());
  const auto sum = static_cast<std::uint32_t>(adler32(adler32(0, nullptr, 0), bytes.data(), size));
  const auto byte = [](std::uint32_t number, int shift) { return static_cast<char>(number >> shift & 0xFF); };
  const std::uint32_t rest = ~std::uint32_t{size};
  text += {'\x78', '\x01', '\x01', byte(size, 0), byte(size, 8), byte(rest, 0), byte(rest, 8)};
  text.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  for (const int shift : {24, 16, 8, 0}) text += byte(sum, shift);
}

// Packing places takes a third of the time of all vectors and gains least.
VtkPacking packing_of(VtkCoding coding, std::string_view name, int width, bool are_reals) {
  if (coding == VtkCoding::zlib || !are_reals) return kPacked;
  return width == 3 && name != kPlaces ? kRuns : kStored;
}

}  // namespace

/// Packs blocks one by one. It is made once per file: its tables take longer to clear than a small array to pack.
class VtkFile::Packer {
 public:
  Packer() {
    constexpr int kWindow = 15, kMemory = 8;  // the defaults
    if (deflateInit2(&stream_, kPacked.level, Z_DEFLATED, kWindow, kMemory, kPacked.strategy) != Z_OK) give_up();
  }
  Packer(const Packer&) = delete;
  Packer& operator=(const Packer&) = delete;
  ~Packer() { deflateEnd(&stream_); }

  /// Appends the packed bytes to `text`.
  void pack(std::span<const std::uint8_t> bytes, const VtkPacking& packing, std::string& text) {
    if (packing.level == Z_NO_COMPRESSION) return store(bytes, text);
    const std::size_t before = text.size();
    text.resize(before + deflateBound(&stream_, bytes.size()));
    if (deflateParams(&stream_, packing.level, packing.strategy) != Z_OK) give_up();
    stream_.next_in = const_cast<Bytef*>(bytes.data());
    stream_.avail_in = static_cast<uInt>(bytes.size());
    stream_.next_out = reinterpret_cast<Bytef*>(text.data() + before);
    stream_.avail_out = static_cast<uInt>(text.size() - before);
    if (deflate(&stream_, Z_FINISH) != Z_STREAM_END) give_up();
    text.resize(before + stream_.total_out);
    deflateReset(&stream_);
  }

 private:
  [[noreturn]] static void give_up() { throw OutputError("zlib cannot pack a frame"); }

  z_stream stream_{};
};

namespace {

VtkCoding coding_of(VtkCoding chosen, std::size_t points) {
  return chosen == VtkCoding::automatic && points < kManyPoints ? VtkCoding::raw : chosen;
}

bool is_packed(VtkCoding coding) {
  return coding == VtkCoding::automatic || coding == VtkCoding::zlib;
}

/// Reads words and bytes from a given place on.
class Bytes {
 public:
  Bytes(std::string_view bytes, std::size_t at, const Place& place) : bytes_(bytes), at_(at), place_(place) {}

  std::string_view take(std::uint64_t count) {
    if (at_ > bytes_.size() || count > bytes_.size() - at_)
      throw InputError(place_, fmt::format("expected an array of {} bytes behind the XML, found {}", count,
                                           at_ > bytes_.size() ? 0 : bytes_.size() - at_));
    const std::string_view taken = bytes_.substr(at_, count);
    at_ += count;
    return taken;
  }
  std::uint64_t word() {
    std::uint64_t value = 0;
    std::memcpy(&value, take(kWord).data(), kWord);
    return value;
  }

 private:
  std::string_view bytes_;
  std::size_t at_;
  const Place& place_;
};

// `of_all`: packed bytes of all arrays. An array that packs better than this does not hold a frame.
std::string unpacked(Bytes& bytes, std::size_t of_all, const Place& place) {
  const std::uint64_t blocks = bytes.word();
  const std::uint64_t size = bytes.word();
  const std::uint64_t last = bytes.word();
  if (size > kPackedAtOnce)
    throw InputError(place, fmt::format("expected blocks of {} bytes, found {}", kPackedAtOnce, size));
  const std::string_view sizes = bytes.take(std::min(blocks, std::uint64_t{1} << 40) * kWord);
  constexpr std::uint64_t kBestRatio = 16, kAlways = 1 << 20;
  if (blocks * size > std::max(kAlways, kBestRatio * of_all))
    throw InputError(place, fmt::format("expected an array of at most {} bytes, found one of {}",
                                        std::max(kAlways, kBestRatio * of_all), blocks * size));
  std::string all;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    std::uint64_t of_packed = 0;
    std::memcpy(&of_packed, sizes.data() + i * kWord, kWord);
    const std::string_view block = bytes.take(of_packed);
    const std::uint64_t whole = i + 1 == blocks && last > 0 ? last : size;
    std::array<Bytef, kPackedAtOnce> out;
    uLongf made = out.size();
    if (uncompress(out.data(), &made, reinterpret_cast<const Bytef*>(block.data()), block.size()) != Z_OK ||
        made != whole)
      throw InputError(place, "expected bytes that zlib has packed, found others");
    all.append(reinterpret_cast<const char*>(out.data()), made);
  }
  return all;
}

template <class T>
std::vector<double> numbers_of(std::string_view bytes, const Place& place) {
  if (bytes.size() % sizeof(T) != 0)
    throw InputError(place, fmt::format("expected whole numbers of {} bytes, found {} bytes", sizeof(T), bytes.size()));
  if (bytes.empty()) return {};
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return {values.begin(), values.end()};
}

std::vector<double> numbers_of(std::string_view type, std::string_view bytes, const Place& place) {
  if (type == "Float64") return numbers_of<double>(bytes, place);
  if (type == "Float32") return numbers_of<float>(bytes, place);
  if (type == "Int64") return numbers_of<std::int64_t>(bytes, place);
  if (type == "Int32") return numbers_of<std::int32_t>(bytes, place);
  if (type == "UInt8") return numbers_of<std::uint8_t>(bytes, place);
  throw InputError(place, fmt::format("expected an array of Float64, Float32, Int64, Int32 or UInt8, found {}", type));
}

}  // namespace

std::vector<std::string> vtk_coding_names() {
  return {kNames.begin(), kNames.end()};
}

VtkCoding vtk_coding_of(std::string_view name) {
  const auto* const found = std::ranges::find(kNames, name);
  if (found == kNames.end())
    throw std::invalid_argument(fmt::format("expected automatic, raw, zlib or text, found \"{}\"", name));
  return static_cast<VtkCoding>(found - kNames.begin());
}

std::string vtk_field(std::string_view name, double number) {
  return fmt::format("<DataArray type=\"Float64\" Name=\"{}\" NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n",
                     name, format_real(number));
}

std::string vtk_field(std::string_view name, std::string_view text) {
  std::string codes;
  for (const char c : text) codes += fmt::format("{} ", static_cast<unsigned char>(c));
  return fmt::format("<DataArray type=\"String\" Name=\"{}\" NumberOfTuples=\"1\" format=\"ascii\">{}0</DataArray>\n",
                     name, codes);
}

VtkFile::VtkFile(std::string_view grid, std::string_view fields, std::string_view counts, std::size_t points,
                 VtkCoding coding)
    : grid_(grid),
      coding_(coding_of(coding, points)),
      xml_(fmt::format("<?xml version=\"1.0\"?>\n"
                       "<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\"{}>\n"
                       "<{}>\n<FieldData>\n{}</FieldData>\n<Piece {}>\n",
                       grid, is_packed(coding_) ? fmt::format(" compressor=\"{}\"", kPacker) : std::string(), grid,
                       fields, counts)) {
  if (is_packed(coding_)) packer_ = std::make_unique<Packer>();
  if (coding_ != VtkCoding::text) appended_.reserve(points * kBytesOfPoint);
}

VtkFile::~VtkFile() = default;

void VtkFile::begin(std::string_view section) {
  section_ = section;
  xml_ += fmt::format("<{}>\n", section);
}

void VtkFile::end() {
  xml_ += fmt::format("</{}>\n", section_);
}

template <class T>
void VtkFile::add_values(std::string_view name, std::span<const T> values, int width) {
  xml_ += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" ", type_name<T>(), name, width);
  if (coding_ != VtkCoding::text) {
    xml_ += fmt::format("format=\"appended\" offset=\"{}\"/>\n", appended_.size());
    append({reinterpret_cast<const std::uint8_t*>(values.data()), values.size_bytes()},
           packing_of(coding_, name, width, std::is_floating_point_v<T>));
    return;
  }
  xml_ += "format=\"ascii\">\n";
  for (std::size_t i = 0; i < values.size(); ++i) {
    xml_ += number_text(values[i]);
    xml_ += (i + 1) % static_cast<std::size_t>(width) == 0 ? '\n' : ' ';
  }
  xml_ += "</DataArray>\n";
}

void VtkFile::append(std::span<const std::uint8_t> bytes, const VtkPacking& packing) {
  if (!is_packed(coding_)) {
    append_word(appended_, bytes.size());
    appended_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return;
  }
  const std::size_t blocks = (bytes.size() + kPackedAtOnce - 1) / kPackedAtOnce;
  append_word(appended_, blocks);
  append_word(appended_, kPackedAtOnce);
  append_word(appended_, bytes.size() % kPackedAtOnce);
  const std::size_t sizes = appended_.size();
  appended_.append(blocks * kWord, '\0');
  for (std::size_t i = 0; i < blocks; ++i) {
    const std::size_t before = appended_.size(), at = i * kPackedAtOnce;
    packer_->pack(bytes.subspan(at, std::min(kPackedAtOnce, bytes.size() - at)), packing, appended_);
    const std::uint64_t size = appended_.size() - before;
    std::memcpy(appended_.data() + sizes + i * kWord, &size, kWord);
  }
}

void VtkFile::add(std::string_view name, std::span<const double> values, int width) {
  add_values(name, values, width);
}
void VtkFile::add(std::string_view name, std::span<const float> values, int width) {
  add_values(name, values, width);
}
void VtkFile::add(std::string_view name, std::span<const std::int32_t> values, int width) {
  add_values(name, values, width);
}
void VtkFile::add(std::string_view name, std::span<const std::uint8_t> values, int width) {
  add_values(name, values, width);
}

void VtkFile::add_points(std::span<const Point> places) {
  std::vector<double> coordinates;
  coordinates.reserve(3 * places.size());
  for (const Point p : places) coordinates.insert(coordinates.end(), {p.x, p.y, 0});
  begin(kPlaces);
  add(kPlaces, coordinates, 3);
  end();
}

std::string VtkFile::text() && {
  constexpr std::string_view kEnd = "</VTKFile>\n";
  xml_ += fmt::format("</Piece>\n</{}>\n", grid_);
  if (coding_ == VtkCoding::text) return std::move(xml_.append(kEnd));
  appended_.insert(0, xml_.append(kOpening).append("_"));
  return std::move(appended_.append("\n</AppendedData>\n").append(kEnd));
}

VtkParts vtk_parts_of(const Source& source) {
  const std::size_t at = source.text.find(kOpening);
  if (at == std::string::npos) return {source, {}, false};
  const std::string_view behind = std::string_view(source.text).substr(at + kOpening.size());
  const std::size_t mark = behind.find('_');
  if (mark == std::string_view::npos || behind.find_first_not_of(" \t\r\n") != mark)
    throw InputError({source.name}, "expected _ before the bytes of <AppendedData>, found none");
  VtkParts parts{{source.name, source.text.substr(0, at) + "</VTKFile>\n"}, behind.substr(mark + 1), false};
  parts.is_packed = parts.xml.text.find(kPacker) != std::string::npos;
  return parts;
}

std::vector<double> vtk_numbers(const VtkParts& parts, std::string_view type, std::string_view offset,
                                const Place& place) {
  std::size_t at = 0;
  const auto [stop, error] = std::from_chars(offset.data(), offset.data() + offset.size(), at);
  if (error != std::errc() || stop != offset.data() + offset.size())
    throw InputError(place, fmt::format("expected an offset of bytes, found \"{}\"", offset));
  Bytes bytes(parts.appended, at, place);
  if (!parts.is_packed) {
    const std::uint64_t size = bytes.word();
    return numbers_of(type, bytes.take(size), place);
  }
  return numbers_of(type, unpacked(bytes, parts.appended.size(), place), place);
}

}  // namespace keyblock::formats
