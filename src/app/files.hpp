// Writing files the way every command does: never over a user's file unless told to, and whole or not at all.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace keyblock {

enum class Overwrite { no, yes };

/// Throws UsageError if `file` exists and may not be overwritten.
void require_free(const std::filesystem::path& file, Overwrite overwrite);

/// Writes beside the file and renames, so that a reader never meets half a file. Throws OutputError if it cannot.
void write_file(const std::filesystem::path& file, const std::string& text);

/// SHA-256 of the bytes, lower-case hexadecimal.
std::string sha256(const std::string& bytes);

}  // namespace keyblock
