// Encodes an image as PNG with a palette, and bytes as base64 (W3C PNG specification, third edition; RFC 4648).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock::report {

/// Pixels row by row from the top left corner: 0xAARRGGBB, the opacity first; 0 is transparent.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> pixels;
};

/// Returns the bytes of a PNG file. Above 256 colours similar ones share an entry of the palette. Throws
/// std::runtime_error if zlib fails.
std::string png_of(const Image& image);

/// Returns the image at half of its resolution: one pixel of four.
Image halved(const Image& image);

std::string base64(std::string_view bytes);

}  // namespace keyblock::report
