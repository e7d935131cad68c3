// Gives pages, pictures, records and differences of results.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "serve/child.hpp"
#include "serve/http/http.hpp"
#include "serve/replies.hpp"
#include "serve/served_folder.hpp"
#include "serve/study/input_copies.hpp"

namespace keyblock::serve {

/// Refers to all four.
class ServedResults {
 public:
  ServedResults(const ServedFolder& folder, const Drafts& drafts, const Program& program, const InputCopies& copies)
      : folder_(folder), drafts_(drafts), program_(program), copies_(copies) {}

  Reply picture(const Parameters& parameters) const;
  Reply page(const Parameters& parameters) const;
  Reply report(const Parameters& parameters) const;
  nlohmann::ordered_json record(const Parameters& parameters) const;
  nlohmann::ordered_json compare(const Parameters& parameters) const;

 private:
  /// Returns the page that a command writes about a result.
  Reply written_by(const std::string& command, const Parameters& parameters) const;
  Reply drawn(const std::filesystem::path& folder) const;

  const ServedFolder& folder_;
  const Drafts& drafts_;
  const Program& program_;
  const InputCopies& copies_;
};

}  // namespace keyblock::serve
