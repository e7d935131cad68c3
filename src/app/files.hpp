// Writing files the way every command does: never over a user's file unless told to, and whole or not at all.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace keyblock {

enum class Overwrite { no, yes };

/// Throws UsageError if `file` exists and may not be overwritten.
void require_free(const std::filesystem::path& file, Overwrite overwrite);

/// Throws UsageError if the folder that `file` is to stand in does not exist.
void require_folder_of(const std::filesystem::path& file);

/// Throws UsageError if `output` is `input`, or is no regular file (a device must not be replaced), whatever --force says.
void require_not_input(const std::filesystem::path& output, const std::filesystem::path& input);

/// Throws UsageError if `input` lies directly in `folder`, where results will be written.
void require_not_below(const std::filesystem::path& input, const std::filesystem::path& folder);

/// Until it returns the bytes may be lost with the power. Throws OutputError if it cannot.
void flush_to_disk(const std::filesystem::path& file_or_folder);

/// As `write_file`, and flushed before and after the renaming: at any moment the disk holds the old file or the new one, whole.
void write_durably(const std::filesystem::path& file, const std::string& bytes);

/// Writes beside the file and renames, so that a reader never meets half a file. Throws OutputError if it cannot.
void write_file(const std::filesystem::path& file, const std::string& text);

}  // namespace keyblock
