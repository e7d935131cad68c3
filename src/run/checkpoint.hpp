// A run put away between two steps, as the bytes of one file: a line of text that says what follows, then HDF5.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/archive.hpp"

namespace keyblock {

/// Byte 0: "keyblock checkpoint, layout N, sha256 S" and a line feed, zeros up to byte 512, the HDF5 file from there
/// on. Its groups and datasets are the archive's; a table is one dataset a column. Any HDF5 tool opens it.
std::string checkpoint_bytes(const Archive& archive);

/// The archive of a file's bytes, ready to restore from. Throws InputError with the name of the file where it is no
/// checkpoint, of another layout, cut off or changed: the checksum is looked at before HDF5 sees a byte.
Archive archive_of_checkpoint(const std::string& file, const std::string& bytes);

}  // namespace keyblock
