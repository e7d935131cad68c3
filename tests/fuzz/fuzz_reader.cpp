// Runs one reader under libFuzzer.
//
//   fuzz_reader list             names of the readers
//   fuzz_reader seeds FOLDER     writes the sample of every format there, to start from
//   fuzz_reader READER FLAGS…    libFuzzer with that reader; FLAGS and folders are libFuzzer's
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "formats/registry.hpp"
#include "tests/fuzz/exercise.hpp"
#include "tests/fuzz/meter.hpp"

namespace {

using namespace keyblock;

/// Largest slowdown of a reader by sanitizers and coverage counters.
constexpr double kSlowdown = 20;

support::Reader& reader_under_test() {
  static support::Reader reader;
  return reader;
}

void list_readers() {
  for (const support::Reader& reader : support::all_readers()) fmt::print("{}\n", reader.name);
}

void write_seeds(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const formats::Format* format : formats::all_formats())
    std::ofstream(folder / format->name, std::ios::binary) << format->sample;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  const std::string_view word = *argc > 1 ? (*argv)[1] : "list";
  if (word == "list") {
    list_readers();
    std::exit(0);
  }
  if (word == "seeds" && *argc > 2) {
    write_seeds((*argv)[2]);
    std::exit(0);
  }
  reader_under_test() = support::find_reader(word);
  support::count_xml();
  for (int i = 1; i < *argc; ++i) (*argv)[i] = (*argv)[i + 1];
  --*argc;
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const support::Cost cost = support::exercise(reader_under_test(), text);
  if (const std::string words = support::excess(cost, size, kSlowdown); !words.empty()) {
    fmt::print(stderr, "error: {}\n", words);
    std::abort();
  }
  return 0;
}
