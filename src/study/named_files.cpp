// One line a setting that names a file.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/named_files.hpp"

#include "formats/body_acceleration.hpp"
#include "formats/registry.hpp"

namespace keyblock::study {

Problem with_named_files(Problem problem, const std::vector<Override>& overrides, const std::filesystem::path& folder) {
  for (const auto& [name, value] : overrides) {
    if (name == "body_acceleration_file" && problem.analysis)
      problem.analysis->body_acceleration = formats::read_body_acceleration(formats::load((folder / value).string()));
  }
  return problem;
}

}  // namespace keyblock::study
