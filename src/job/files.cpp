// Writes files through drafts that are renamed, and checks names of outputs before any work.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <memory>
#include <string_view>
#include <system_error>

#include "base/context.hpp"
#include "base/error.hpp"

namespace keyblock {

namespace fs = std::filesystem;

namespace {

// Start of the name of a draft; the process and a count follow. It is short, because the name of the file may already
// have the greatest length.
constexpr std::string_view kDraft = ".keyblock_draft_";

bool is_taken(const fs::path& file) {
  std::error_code error;
  return fs::exists(fs::symlink_status(file, error));
}

void require_folder_of(const fs::path& file) {
  std::error_code error;
  if (const fs::path folder = file.parent_path(); !folder.empty() && !fs::is_directory(folder, error))
    throw UsageError(fmt::format("there is no folder {} for {}", folder.string(), file.filename().string()));
}

/// Returns true if a case folder reads the file: all files except the pictures and settings that commands write there.
bool is_case_input(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error) || !fs::equivalent(folder, fs::absolute(file).parent_path(), error))
    return false;
  const std::string ending = file.extension().string();
  return ending != ".svg" && ending != ".settings" && ending != ".html";
}

void require_replaceable(const fs::path& output, const std::vector<fs::path>& inputs) {
  if (!is_taken(output)) return;
  std::error_code error;
  if (!fs::exists(output, error)) throw UsageError(fmt::format("{} is a link to nothing", output.string()));
  if (!fs::is_regular_file(output, error)) throw UsageError(fmt::format("{} is no regular file", output.string()));
  for (const fs::path& input : inputs)
    if (fs::equivalent(output, input, error) || is_case_input(output, input))
      throw UsageError(fmt::format("{} is an input; give another name", output.string()));
}

// Returns the place of a file of that name after all links are resolved.
fs::path place_of(const fs::path& file) {
  std::error_code error;
  const fs::path place = fs::weakly_canonical(fs::absolute(file), error);
  return error ? fs::absolute(file).lexically_normal() : place;
}

[[noreturn]] void give_up(const fs::path& file, int why) {
  throw OutputError(fmt::format("cannot write {}: {}", file.string(), std::generic_category().message(why)));
}

void write_all(int descriptor, std::string_view text, const fs::path& file) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno != EINTR) give_up(file, errno);
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// New file next to `file`, with a unique name. It is removed unless it takes the name of `file`.
class Draft {
 public:
  explicit Draft(const fs::path& file) : file_(file) {
    static std::atomic<unsigned> count = 0;
    do {
      name_ = file.parent_path() / fmt::format("{}{}_{}", kDraft, getpid(), count++);
      descriptor_ = open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    } while (descriptor_ < 0 && errno == EEXIST);
    if (descriptor_ < 0) give_up(file, errno);
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  ~Draft() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!is_in_place_) unlink(name_.c_str());
  }

  void write(std::string_view text) { write_all(descriptor_, text, file_); }

  void flush() {
    if (fsync(descriptor_) != 0) give_up(file_, errno);
  }

  // Some file systems report a full disk only when the file is closed.
  void put_in_place() {
    take_permissions();
    const bool is_closed = close(descriptor_) == 0;
    descriptor_ = -1;
    if (!is_closed || std::rename(name_.c_str(), file_.c_str()) != 0) give_up(file_, errno);
    is_in_place_ = true;
  }

  // A second name is made only if the name is free. On file systems without second names, an exclusively created file
  // takes the name first.
  void put_where_none_is() {
    if (link(name_.c_str(), file_.c_str()) == 0) return;
    if (errno != EEXIST) {
      const int taken = open(file_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
      if (taken >= 0) {
        close(taken);
        return put_in_place();
      }
    }
    if (errno != EEXIST) give_up(file_, errno);
    require_free(file_, Overwrite::no);
    give_up(file_, EEXIST);  // existed a moment ago, does not now
  }

 private:
  // Keeps the permissions of an existing file; a new file has those that the user's mask leaves.
  void take_permissions() const {
    struct stat there {};
    if (lstat(file_.c_str(), &there) == 0 && S_ISREG(there.st_mode)) fchmod(descriptor_, there.st_mode & 07777);
  }

  fs::path file_;
  fs::path name_;
  int descriptor_ = -1;
  bool is_in_place_ = false;
};

}  // namespace

void require_free(const fs::path& file, Overwrite overwrite) {
  if (overwrite == Overwrite::no && is_taken(file))
    throw ChoiceError("force", file.string() + " exists; give another name, or ", " to overwrite it");
}

void require_writable(const std::vector<fs::path>& outputs, const std::vector<fs::path>& inputs, Overwrite overwrite) {
  std::vector<fs::path> places;
  for (const fs::path& output : outputs) {
    if (output.empty()) continue;
    require_replaceable(output, inputs);
    require_free(output, overwrite);
    require_folder_of(output);
    const fs::path place = place_of(output);
    if (std::ranges::find(places, place) != places.end())
      throw UsageError(fmt::format("{} is named for two outputs; give one another name", output.string()));
    places.push_back(place);
  }
}

void require_not_below(const fs::path& input, const fs::path& folder) {
  std::error_code error;
  const fs::path parent = located(input.has_parent_path() ? input.parent_path() : fs::path("."));
  if (fs::equivalent(parent, folder, error))
    throw UsageError(fmt::format("{} lies in the folder for the results; give another folder", input.string()));
}

void write_file(const fs::path& file, const std::string& text, Overwrite overwrite) {
  Draft draft(file);
  draft.write(text);
  if (overwrite == Overwrite::yes)
    draft.put_in_place();
  else
    draft.put_where_none_is();
}

void append_to_file(const fs::path& file, std::string_view text) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor < 0) give_up(file, errno);
  const auto close_it = [](const int* opened) { close(*opened); };
  std::unique_ptr<const int, decltype(close_it)> closes(&descriptor, close_it);
  write_all(descriptor, text, file);
  closes.release();
  if (close(descriptor) != 0) give_up(file, errno);
}

void flush_to_disk(const fs::path& file_or_folder) {
  const int descriptor = open(file_or_folder.c_str(), O_RDONLY | O_CLOEXEC);
  const bool flushed = descriptor >= 0 && fsync(descriptor) == 0;
  if (descriptor >= 0) close(descriptor);
  if (!flushed) throw OutputError(fmt::format("cannot write {}: it does not reach the disk", file_or_folder.string()));
}

void write_durably(const fs::path& file, const std::string& bytes, Overwrite overwrite) {
  Draft draft(file);
  draft.write(bytes);
  draft.flush();
  if (overwrite == Overwrite::yes)
    draft.put_in_place();
  else
    draft.put_where_none_is();
  flush_to_disk(file.parent_path());
}

void write_output(const fs::path& file, const std::string& text, Overwrite overwrite) {
  std::error_code error;
  const bool is_link = overwrite == Overwrite::yes && fs::is_symlink(file, error);
  write_file(is_link ? fs::canonical(file) : file, text, overwrite);
}

void remove_drafts(const fs::path& folder, std::optional<int> process) {
  std::error_code error;
  const std::string start = process ? fmt::format("{}{}_", kDraft, *process) : std::string(kDraft);
  std::vector<fs::path> drafts;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.path().filename().string().starts_with(start)) drafts.push_back(entry.path());
  for (const fs::path& draft : drafts) unlink(draft.c_str());
}

}  // namespace keyblock
