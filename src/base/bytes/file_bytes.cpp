// Compiled as C++23, where the library has it: only then can a string be made long without being filled first.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/bytes/file_bytes.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>

#include "base/context.hpp"
#include "base/error.hpp"
#include "base/large_pages.hpp"
#include "base/parallel.hpp"

namespace keyblock {
namespace {

/// Throws InputError for a file outside of the folders that a reader may look into; links are followed.
void require_permitted(const std::string& path) {
  namespace fs = std::filesystem;
  const char* const folders = std::getenv(kReadsBelow);
  if (folders == nullptr) return;
  std::error_code error;
  const fs::path file = fs::weakly_canonical(fs::absolute(located(path)), error);
  std::istringstream lines(folders);
  for (std::string folder; std::getline(lines, folder);) {
    const fs::path below(folder);
    if (!error && std::mismatch(below.begin(), below.end(), file.begin(), file.end()).first == below.end()) return;
  }
  throw InputError({path}, "expected a file within the served folder, found one outside of it");
}

class OpenFile {
 public:
  explicit OpenFile(const std::string& path) {
    require_permitted(path);
    descriptor_ = open(located(path).c_str(), O_RDONLY | O_CLOEXEC);
    struct stat status {};
    if (descriptor_ < 0 || fstat(descriptor_, &status) != 0)
      throw InputError({path}, "expected a readable file, found one that cannot be opened");
    size_ = static_cast<std::size_t>(status.st_size);
  }
  ~OpenFile() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  std::size_t size() const { return size_; }

  /// Reads the bytes from `first` to `last` to their place in `room`; returns false if the file ends too early.
  bool read(char* room, std::size_t first, std::size_t last) const {
    while (first < last) {
      const ssize_t count = pread(descriptor_, room + first, last - first, static_cast<off_t>(first));
      if (count == 0 || (count < 0 && errno != EINTR)) return false;
      if (count > 0) first += static_cast<std::size_t>(count);
    }
    return true;
  }

 private:
  int descriptor_ = -1;
  std::size_t size_ = 0;
};

template <typename Fill>
void make_long(std::string& text, std::size_t size, Fill fill) {
#ifdef __cpp_lib_string_resize_and_overwrite
  text.resize_and_overwrite(size, [&](char* room, std::size_t) {
    fill(room);
    return size;
  });
#else
  text.resize(size);
  fill(text.data());
#endif
}

/// The first `size` bytes.
std::string bytes_of(const OpenFile& file, const std::string& path, std::size_t size) {
  const std::size_t parts = threads_for_bytes(size);
  std::atomic<bool> is_whole = true;
  std::string text;
  reserve_large(text, size);
  make_long(text, size, [&](char* room) {
    at_once(parts, [&](std::size_t i) {
      if (!file.read(room, size * i / parts, size * (i + 1) / parts)) is_whole = false;
    });
  });
  if (!is_whole) throw InputError({path}, "expected a readable file, found one that ends too early");
  return text;
}

}  // namespace

std::string file_bytes(const std::string& path) {
  const OpenFile file(path);
  return bytes_of(file, path, file.size());
}

std::string file_head(const std::string& path, std::size_t most) {
  const OpenFile file(path);
  return bytes_of(file, path, std::min(file.size(), most));
}

}  // namespace keyblock
