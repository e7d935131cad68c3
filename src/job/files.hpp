// Writes files for all commands: whole or not at all, and over a user's file only if the user permits it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

enum class Overwrite { no, yes };

/// Returns `yes` if --force was given.
inline Overwrite overwrite_if(bool is_told) {
  return is_told ? Overwrite::yes : Overwrite::no;
}

/// Throws UsageError if `file` exists, even as a link to nothing, and may not be overwritten.
void require_free(const std::filesystem::path& file, Overwrite overwrite);

/// Checks the outputs before any work, so that no long work is lost. Throws UsageError if one of `outputs` exists and
/// may not be overwritten. Throws even with --force if an output is one of `inputs`, or a file of an input folder other
/// than pictures and settings. Throws also if it equals another output, is no regular file (a device must not be
/// replaced), or has no folder. Empty names are skipped.
void require_writable(const std::vector<std::filesystem::path>& outputs,
                      const std::vector<std::filesystem::path>& inputs, Overwrite overwrite);

/// Throws UsageError if `input` lies directly in `folder`, the folder of the results.
void require_not_below(const std::filesystem::path& input, const std::filesystem::path& folder);

/// Flushes a file or folder to the disk; before it returns, a power failure may lose the bytes. Throws OutputError on
/// failure.
void flush_to_disk(const std::filesystem::path& file_or_folder);

/// Writes like `write_file`, and flushes before and after the renaming: the disk always holds the whole old or new
/// file. Throws UsageError if the file exists and may not be overwritten; if two programs write at once, one gets this
/// error.
void write_durably(const std::filesystem::path& file, const std::string& bytes, Overwrite overwrite);

/// Writes a draft next to the file and renames it, so that a reader never sees half a file. A link of that name is
/// replaced, not followed. Throws OutputError on failure, or if the folder is gone. Throws UsageError if a file of that
/// name exists by then and may not be overwritten. A replaced file keeps its permissions.
void write_file(const std::filesystem::path& file, const std::string& text, Overwrite overwrite = Overwrite::yes);

/// Adds `text` to the end of a file. Throws OutputError.
void append_to_file(const std::filesystem::path& file, std::string_view text);

/// Writes a file that the user named. If it is a symbolic link, the file that it points to is written and the link
/// stays. Throws like `write_file`.
void write_output(const std::filesystem::path& file, const std::string& text, Overwrite overwrite);

/// Removes drafts from `folder` that a killed program left there: the process with this number, or any.
void remove_drafts(const std::filesystem::path& folder, std::optional<int> process = std::nullopt);

}  // namespace keyblock
