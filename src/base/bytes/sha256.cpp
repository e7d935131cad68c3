// OpenSSL's digest as text.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/bytes/sha256.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>

namespace keyblock {
namespace {

auto new_state() {
  return std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)>(EVP_MD_CTX_new(), EVP_MD_CTX_free);
}

}  // namespace

Sha256::Sha256() : state_(new_state()) {
  EVP_DigestInit_ex(state_.get(), EVP_sha256(), nullptr);
}

void Sha256::add(std::string_view bytes) {
  EVP_DigestUpdate(state_.get(), bytes.data(), bytes.size());
}

std::string Sha256::text() const {
  const auto copy = new_state();  // finishing ends the state
  EVP_MD_CTX_copy_ex(copy.get(), state_.get());
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  EVP_DigestFinal_ex(copy.get(), digest.data(), &size);
  std::string text;
  for (unsigned int i = 0; i < size; ++i) text += fmt::format("{:02x}", digest[i]);
  return text;
}

std::string sha256(std::string_view bytes) {
  Sha256 digest;
  digest.add(bytes);
  return digest.text();
}

}  // namespace keyblock
