// Stores a run between two steps as the bytes of one file: a line of text with the layout, then HDF5.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/archive.hpp"

namespace keyblock {

/// Returns the bytes of the file. At byte 0 stands "keyblock checkpoint, layout N, sha256 S" and a line feed, then
/// zeros up to byte 512, then the HDF5 file. Its groups and datasets are those of the archive; a table has one dataset
/// per column. Any HDF5 tool opens it.
std::string checkpoint_bytes(const Archive& archive);

/// Returns the archive in a file's bytes, ready to restore. Throws InputError with the name of the file if it is not a
/// checkpoint, has another layout, or is truncated or changed. The checksum is verified before HDF5 reads a byte.
Archive archive_of_checkpoint(const std::string& file, const std::string& bytes);

}  // namespace keyblock
