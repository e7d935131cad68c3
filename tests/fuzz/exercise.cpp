// Reads, checks and writes under the meter.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/exercise.hpp"

#include <fmt/format.h>

#include <optional>
#include <stdexcept>

#include "formats/case.hpp"
#include "formats/registry.hpp"
#include "problem/checks/check.hpp"
#include "tests/fuzz/meter.hpp"

namespace keyblock::support {
namespace {

using namespace formats;

/// The analysis files of the samples belong to a geometry with these points.
const ReadHint kHint{1, 2, GeometryKind::unknown};

std::optional<Reading> reading_of(const Reader& reader, const Source& source) {
  try {
    return reader.format ? reader.format->read(source, kHint) : read(source, kHint);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

struct Measured {
  Cost cost;
  std::optional<Content> content;
};

Measured measured(const Reader& reader, const std::string& text) {
  const Source source{"tests/a_long_name_of_a_file", text};
  const double start = processor_seconds();
  const std::size_t before = bytes_held();
  forget_peak();
  std::optional<Reading> reading = reading_of(reader, source);
  Measured result{{peak_bytes() - before, 0}, {}};
  if (reading) {
    try {
      check(pair({reading->content}));
    } catch (const InputError&) {  // two geometries in one file
    }
    result.content = std::move(reading->content);
  }
  result.cost.seconds = processor_seconds() - start;
  return result;
}

void write_everywhere(const Content& content) {
  for (const Format* format : all_formats()) {
    if (!format->write) continue;
    try {
      format->write(content);
    } catch (const std::invalid_argument&) {  // lacks what this format holds
    }
  }
}

}  // namespace

std::vector<Reader> all_readers() {
  std::vector<Reader> readers;
  for (const Format* format : all_formats())
    if (format->read) readers.push_back({format->name, format});
  readers.push_back({"anything", nullptr});
  return readers;
}

Reader find_reader(std::string_view name) {
  for (const Reader& reader : all_readers())
    if (reader.name == name) return reader;
  throw std::invalid_argument(fmt::format("no reader is called {}", name));
}

Cost read_and_check(const Reader& reader, const std::string& text) {
  return measured(reader, text).cost;
}

Cost exercise(const Reader& reader, const std::string& text) {
  const double start = processor_seconds();
  auto [cost, content] = measured(reader, text);
  if (content) write_everywhere(*content);
  cost.seconds = processor_seconds() - start;
  return cost;
}

std::string excess(const Cost& cost, std::size_t size, double slowdown) {
  const double limit = kBytesPerByte * static_cast<double>(size) + static_cast<double>(kBytesAtLeast);
  if (static_cast<double>(cost.bytes) > limit)
    return fmt::format("{} bytes held for an input of {}: {:.1f} times its size", cost.bytes, size,
                       static_cast<double>(cost.bytes) / static_cast<double>(size));
  const double time_limit = slowdown * (kSecondsPerMegabyte * static_cast<double>(size) / 1e6 + kSecondsAtLeast);
  if (cost.seconds > time_limit) return fmt::format("{:.2f} s for an input of {} bytes", cost.seconds, size);
  return {};
}

}  // namespace keyblock::support
