// Encapsulates HDF5. Files are made and opened in memory, so that writing them is one rename.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/checkpoint.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <cstring>
#include <mutex>
#include <new>
#include <stdexcept>

#include "base/bytes/sha256.hpp"

namespace keyblock {
namespace {

constexpr int kLayout = 8;
constexpr std::size_t kHeaderBytes = 512;  // smallest offset above 0 at which HDF5 looks for its first byte
constexpr std::size_t kGrowth = 1 << 20;   // of the file in memory
constexpr std::string_view kOpening = "keyblock checkpoint, layout ";
constexpr std::string_view kDigestWord = ", sha256 ";

/// Failed HDF5 call, for lack of memory or because of the contents of a file.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// HDF5 identifier, closed on destruction; a negative one is a failed call.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {
    if (id < 0) throw Refused("HDF5 refuses a call: out of memory, or a damaged file");
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { close_(id_); }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Debian's HDF5 is not thread-safe: one thread at a time may call it.
std::mutex& hdf5() {
  static std::mutex mutex;
  return mutex;
}

void require(bool done) {
  if (!done) throw Refused("HDF5 cannot read or write a dataset");
}

/// Keeps HDF5 from printing its errors, which this file reports itself. A caller of the library may want its own
/// printed.
class Silence {
 public:
  Silence() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
  ~Silence() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

Handle access_in_memory() {
  return {H5Pcreate(H5P_FILE_ACCESS), H5Pclose};
}

Handle text_type(std::size_t size) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, size);
  H5Tset_cset(type, H5T_CSET_UTF8);
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  return {type, H5Tclose};
}

void write_column(hid_t place, const std::string& name, hid_t stored, hid_t in_memory, std::size_t count,
                  const void* values) {
  const hsize_t size = count;
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  const Handle untimed(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);  // the same run gives the same bytes
  H5Pset_obj_track_times(untimed, false);
  const Handle set(H5Dcreate2(place, name.c_str(), stored, space, H5P_DEFAULT, untimed, H5P_DEFAULT), H5Dclose);
  require(H5Dwrite(set, in_memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
}

void write_texts(hid_t place, const std::string& name, const std::vector<std::string>& texts) {
  std::size_t longest = 1;
  for (const std::string& text : texts) longest = std::max(longest, text.size());
  std::string all(longest * texts.size(), '\0');
  for (std::size_t i = 0; i < texts.size(); ++i)
    std::ranges::copy(texts[i], all.begin() + static_cast<long>(i * longest));
  const Handle type = text_type(longest);
  write_column(place, name, type, type, texts.size(), all.data());
}

void write(hid_t place, const ArchiveNode& node) {
  if (const auto* reals = std::get_if<std::vector<double>>(&node.column))
    return write_column(place, node.name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, reals->size(), reals->data());
  if (const auto* integers = std::get_if<std::vector<std::int64_t>>(&node.column))
    return write_column(place, node.name, H5T_STD_I64LE, H5T_NATIVE_INT64, integers->size(), integers->data());
  if (const auto* texts = std::get_if<std::vector<std::string>>(&node.column))
    return write_texts(place, node.name, *texts);
  const Handle group(H5Gcreate2(place, node.name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  for (const auto& child : node.children) write(group, *child);
}

// The data are sound and stay in memory: if HDF5 fails, memory is short.
std::string image_of(const ArchiveNode& root) try {
  const std::lock_guard lock(hdf5());
  const Silence silence;
  const Handle access = access_in_memory();
  H5Pset_fapl_core(access, kGrowth, false);
  const Handle file(H5Fcreate("checkpoint", H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose);
  for (const auto& child : root.children) write(file, *child);
  require(H5Fflush(file, H5F_SCOPE_GLOBAL) >= 0);
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  require(size > 0);
  std::string image(static_cast<std::size_t>(size), '\0');
  require(H5Fget_file_image(file, image.data(), image.size()) == size);
  return image;
} catch (const Refused&) {
  throw std::bad_alloc();
}

// `most`: bytes of the file; a dataset that claims more is rejected.
void read_column(hid_t set, std::size_t most, ArchiveNode& node) {
  const Handle space(H5Dget_space(set), H5Sclose);
  const Handle type(H5Dget_type(set), H5Tclose);
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  const std::size_t bytes = H5Tget_size(type);
  require(count >= 0 && bytes > 0 && static_cast<std::size_t>(count) <= most / bytes);
  const auto size = static_cast<std::size_t>(count);
  const auto read = [&](hid_t in_memory, void* values) {
    require(H5Dread(set, in_memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
  };
  switch (H5Tget_class(type)) {
    case H5T_FLOAT:
      read(H5T_NATIVE_DOUBLE, node.column.emplace<std::vector<double>>(size).data());
      return;
    case H5T_INTEGER:
      read(H5T_NATIVE_INT64, node.column.emplace<std::vector<std::int64_t>>(size).data());
      return;
    case H5T_STRING: {
      require(H5Tis_variable_str(type) == 0);
      std::string all(size * bytes, '\0');
      read(text_type(bytes), all.data());
      auto& texts = node.column.emplace<std::vector<std::string>>();
      for (std::size_t i = 0; i < size; ++i) {
        const char* const text = all.data() + i * bytes;
        texts.emplace_back(text, strnlen(text, bytes));
      }
      return;
    }
    default:
      require(false);
  }
}

void read_children(hid_t group, std::size_t most, ArchiveNode& node) {
  H5G_info_t info;
  require(H5Gget_info(group, &info) >= 0);
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    const auto named = [&](char* name, std::size_t size) {
      return H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, name, size, H5P_DEFAULT);
    };
    const ssize_t length = named(nullptr, 0);
    require(length > 0);
    auto child = std::make_unique<ArchiveNode>();
    child->name.resize(static_cast<std::size_t>(length));
    named(child->name.data(), child->name.size() + 1);
    const Handle object(H5Oopen(group, child->name.c_str(), H5P_DEFAULT), H5Oclose);
    if (H5Iget_type(object) == H5I_GROUP)
      read_children(object, most, *child);
    else
      read_column(object, most, *child);
    node.children.push_back(std::move(child));
  }
}

std::unique_ptr<ArchiveNode> tree_of(std::string image) {
  const std::lock_guard lock(hdf5());
  const Silence silence;
  const Handle access = access_in_memory();
  H5Pset_fapl_core(access, kGrowth, false);
  require(H5Pset_file_image(access, image.data(), image.size()) >= 0);
  const Handle file(H5Fopen("checkpoint", H5F_ACC_RDONLY, access), H5Fclose);
  const Handle top(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose);
  auto root = std::make_unique<ArchiveNode>();
  read_children(top, image.size(), *root);
  return root;
}

[[noreturn]] void refuse(const std::string& file, const std::string& sentence) {
  throw InputError({file, 0, 0}, sentence);
}

std::string header_of(const std::string& image) {
  std::string header = fmt::format("{}{}{}{}\n", kOpening, kLayout, kDigestWord, sha256(image));
  header.resize(kHeaderBytes, '\0');
  return header;
}

}  // namespace

std::string checkpoint_bytes(const Archive& archive) {
  const std::string image = image_of(archive.root());
  return header_of(image) + image;
}

Archive archive_of_checkpoint(const std::string& file, const std::string& bytes) {
  if (!bytes.starts_with(kOpening)) refuse(file, "expected a checkpoint of keyblock, found something else");
  const std::string line = bytes.substr(kOpening.size(), kHeaderBytes - kOpening.size());
  const std::string layout = line.substr(0, line.find(kDigestWord));
  if (layout != std::to_string(kLayout) && layout.find_first_not_of("0123456789") == std::string::npos)
    refuse(file, fmt::format("expected a checkpoint of layout {}, found layout {}", kLayout, layout));
  const std::string image = bytes.substr(std::min(bytes.size(), kHeaderBytes));
  if (!bytes.starts_with(header_of(image)))
    refuse(file, "expected the bytes that were saved, found others: the file is cut off or damaged");
  try {
    return {file, tree_of(image)};
  } catch (const std::runtime_error& error) {
    refuse(file,
           fmt::format("expected an HDF5 file behind the first {} bytes, found none: {}", kHeaderBytes, error.what()));
  }
}

}  // namespace keyblock
