// Reads and writes a 100 MB cover file, beside the method of Shi's programs: fscanf, number after number.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>

#include "formats/registry.hpp"
#include "formats/shi/nmm_cover.hpp"

namespace {

using namespace keyblock;

/// A sheet of `count` triangles, two per cell, whose covers are the nodes of the cells. `digits` behind the point: 6 as
/// Shi's programs print, 17 as a double may need.
std::string cover_text(int count, int digits) {
  const int columns = 1000, rows = count / columns / 2;
  std::string text =
      fmt::format("{} 2 2 2\n{} {} 1 5\n", 2 * columns * rows, 8 * columns * rows, (columns + 1) * (rows + 1));
  for (int i = 0; i < 6; ++i) text += fmt::format("{:.6f} {:.6f} {:.6f}\n", 0.1 * i, 0.05, 1.0);
  const auto out = std::back_inserter(text);
  const auto add_point = [&](double x, double y) { fmt::format_to(out, "{:.{}f} {:.{}f}\n", x, digits, y, digits); };
  const auto x_of = [](int column) { return 0.7310585 * column + 1 / 3.0; };
  const auto y_of = [](int row) { return -40 + 0.6180339 * row + 1 / 7.0; };
  const auto node = [&](int column, int row) { return row * (columns + 1) + column + 1; };
  for (int i = 0; i < 2 * columns * rows; ++i) fmt::format_to(out, "{} {} 1\n", 4 * i + 1, 4 * i + 3);
  constexpr std::array<std::array<int, 8>, 2> kCorners{{{0, 0, 1, 0, 1, 1, 0, 0}, {0, 0, 1, 1, 0, 1, 0, 0}}};
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      for (const auto& corners : kCorners)
        for (std::size_t i = 0; i < 8; i += 2) add_point(x_of(column + corners[i]), y_of(row + corners[i + 1]));
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column) add_point(x_of(column), y_of(row));
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      for (const auto& corners : kCorners) {
        for (std::size_t i = 0; i < 6; i += 2)
          fmt::format_to(out, "{} ", node(column + corners[i], row + corners[i + 1]));
        text += '\n';
      }
  return text + "1 4\n1 1\n2 1\n3 1\n7 1\n1 1\n";
}

/// Reads the numbers of a cover file into arrays, as Shi's programs do; returns their count.
std::size_t read_by_fscanf(const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "r");
  if (!file) throw std::runtime_error("cannot open " + path);
  std::vector<int> whole;
  std::vector<double> real;
  const auto next_whole = [&](std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      int value = 0;
      if (std::fscanf(file, "%d", &value) != 1) throw std::runtime_error("the file ends early");
      whole.push_back(value);
    }
  };
  const auto next_real = [&](std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      double value = 0;
      if (std::fscanf(file, "%lf", &value) != 1) throw std::runtime_error("the file ends early");
      real.push_back(value);
    }
  };
  next_whole(8);
  const std::vector<std::size_t> n(whole.begin(), whole.end());
  whole.reserve(8 + 6 * n[0] + 2 * (n[6] + n[7]));
  real.reserve(3 * (n[1] + n[2] + n[3]) + 2 * (n[4] + n[5]));
  next_real(3 * (n[1] + n[2] + n[3]));
  next_whole(3 * n[0]);
  next_real(2 * (n[4] + n[5]));
  next_whole(3 * n[0] + 2 * (n[6] + n[7]));
  std::fclose(file);
  return whole.size() + real.size();
}

double seconds_of(clockid_t clock) {
  std::timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Cost of a piece of work: wall-clock time, and processor time of all threads, user and system.
struct Seconds {
  double wall = 1e300;
  double processor = 1e300;
};

/// The least of several runs: other programs on the machine count less so.
void time_again(Seconds& best, const std::function<void()>& work) {
  const Seconds start{seconds_of(CLOCK_MONOTONIC), seconds_of(CLOCK_PROCESS_CPUTIME_ID)};
  work();
  best.wall = std::min(best.wall, seconds_of(CLOCK_MONOTONIC) - start.wall);
  best.processor = std::min(best.processor, seconds_of(CLOCK_PROCESS_CPUTIME_ID) - start.processor);
}

struct Speeds {
  double ratio = 0;  ///< of reading, to fscanf, on the wall
  double write = 0;  ///< MB/s
};

Speeds measure(int digits, int elements, int runs) {
  const std::string path =
      (std::filesystem::temp_directory_path() / fmt::format("keyblock_cover_{}", getpid())).string();
  std::ofstream(path, std::ios::binary) << cover_text(elements, digits);
  const double megabytes = static_cast<double>(std::filesystem::file_size(path)) / 1e6;
  Seconds old_way, load, ours, write;
  std::string written;
  for (int i = 0; i < runs; ++i) {
    time_again(old_way, [&] { read_by_fscanf(path); });
    time_again(load, [&] { formats::load(path); });
    time_again(ours, [&] { formats::read(formats::load(path)); });
    const formats::Content content = formats::read(formats::load(path)).content;
    time_again(write, [&] { written = formats::kNmmCover.write(content); });
  }
  std::filesystem::remove(path);
  const double written_megabytes = static_cast<double>(written.size()) / 1e6;
  const auto print = [&](std::string_view clock, double Seconds::*of) {
    fmt::print(
        "{:2} digits {:4.0f} MB, {}: fscanf {:6.1f} MB/s; load, recognise and read {:6.1f} MB/s (load alone {:6.1f}), "
        "{:4.1f} times as fast; write {:6.1f} MB/s\n",
        digits, megabytes, clock, megabytes / old_way.*of, megabytes / ours.*of, megabytes / load.*of,
        old_way.*of / ours.*of, written_megabytes / write.*of);
  };
  print("on the wall   ", &Seconds::wall);
  print("processor time", &Seconds::processor);
  return {old_way.wall / ours.wall, written_megabytes / write.wall};
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Speed of reading and writing a cover file beside fscanf");
  int runs = 5;
  app.add_option("--runs", runs, "the best of so many is printed")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  const Speeds six = measure(6, 730000, runs);
  measure(17, 420000, runs);
  return six.ratio >= 10 && six.write >= 100 ? 0 : 1;
}
