// Computes the SHA-256 checksum of bytes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>

struct evp_md_ctx_st;

namespace keyblock {

/// SHA-256 of the bytes, lower-case hexadecimal.
std::string sha256(std::string_view bytes);

/// SHA-256 of bytes that come in parts.
class Sha256 {
 public:
  Sha256();

  void add(std::string_view bytes);
  /// Digest of all bytes so far, lower-case hexadecimal; more may follow.
  std::string text() const;

 private:
  std::unique_ptr<evp_md_ctx_st, void (*)(evp_md_ctx_st*)> state_;
};

}  // namespace keyblock
