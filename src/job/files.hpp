// Writing files the way every command does: never over a user's file unless told to, and whole or not at all.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace keyblock {

enum class Overwrite { no, yes };

/// As --force says.
inline Overwrite overwrite_if(bool is_told) {
  return is_told ? Overwrite::yes : Overwrite::no;
}

/// Throws UsageError if something bears the name `file`, a link to nothing included, and may not be overwritten.
void require_free(const std::filesystem::path& file, Overwrite overwrite);

/// Before any work is done, so that a long one is not lost: throws UsageError where one of `outputs` is there already
/// and may not be overwritten, and whatever --force says where it is one of `inputs` (or a file of one that is a
/// folder, pictures and settings left out), is the same as another output, is
/// no regular file (a device must not be replaced), or has no folder to stand in. Empty names are passed over.
void require_writable(const std::vector<std::filesystem::path>& outputs,
                      const std::vector<std::filesystem::path>& inputs, Overwrite overwrite);

/// Throws UsageError if `input` lies directly in `folder`, where results will be written.
void require_not_below(const std::filesystem::path& input, const std::filesystem::path& folder);

/// Until it returns the bytes may be lost with the power. Throws OutputError if it cannot.
void flush_to_disk(const std::filesystem::path& file_or_folder);

/// As `write_file`, and flushed before and after the renaming: at any moment the disk holds the old file or the new
/// one, whole. Throws UsageError if there is one and it may not be overwritten: of two that write at once one is told
/// so.
void write_durably(const std::filesystem::path& file, const std::string& bytes, Overwrite overwrite);

/// Writes a draft beside the file and renames it, so that a reader never meets half a file. A link of that name is
/// replaced, not followed. Throws OutputError if it cannot, or if the folder is gone; UsageError if there is a file of
/// that name by then and it may not be overwritten. A file that is replaced keeps its permissions.
void write_file(const std::filesystem::path& file, const std::string& text, Overwrite overwrite = Overwrite::yes);

/// A file that the user named: where it is a symbolic link, the file that it points to is written and the link stays.
/// Throws as `write_file`.
void write_output(const std::filesystem::path& file, const std::string& text, Overwrite overwrite);

/// Removes drafts from `folder` that a program killed while writing left there.
void remove_drafts(const std::filesystem::path& folder);

}  // namespace keyblock
