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
  /// Returns the page of a result, or its report for clients, by the path of the request.
  Reply page(const std::string& path, const Parameters& parameters) const;
  nlohmann::ordered_json record(const Parameters& parameters) const;
  nlohmann::ordered_json compare(const Parameters& parameters) const;

 private:
  Reply drawn(const std::filesystem::path& folder) const;

  const ServedFolder& folder_;
  const Drafts& drafts_;
  const Program& program_;
  const InputCopies& copies_;
};

}  // namespace keyblock::serve
