// Declares the options; see output_options.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output_options.hpp"

#include <fmt/format.h>

#include <array>

#include "app/option_checks.hpp"
#include "job/folder/frame_tables.hpp"
#include "report/field_picture.hpp"

namespace keyblock {

std::array<CLI::Option*, 6> add_output_options(CLI::App& options, OutputOptions& chosen) {
  CLI::Option* histories =
      options
          .add_option("--history", chosen.histories,
                      "record in histories.csv: [NAME=]point:X,Y, block:N, contact:A,B, joint:N, line:X1,Y1,X2,Y2 or "
                      "bolt:N; every n-th step of runs beyond 5,000; may be repeated")
          ->take_all();
  CLI::Option* contacts = options.add_option(
      "--contacts", chosen.contacts,
      fmt::format("contacts to write: automatic (all, thinned beyond {:g} rows), all, chosen (those of histories), "
                  "none, or N (those of every N-th frame)",
                  kMostContactRows));
  CLI::Option* field =
      options
          .add_option(
              "--field", chosen.field,
              "quantity shown in field.svg: a stress component, s1 (greatest principal stress), s3 (least), von "
              "Mises stress, displacement, or crosses of principal stresses (default: the component that varies "
              "most)")
          ->check(one_word_of(std::vector<std::string>(report::kFieldWords.begin(), report::kFieldWords.end())));
  CLI::Option* frames =
      options
          .add_option(
              "--frames", chosen.frames,
              "coding of frames (.vtu, .vtp): raw (bytes), zlib (packed, slower to write), text, or automatic (raw; "
              "large frames partly packed; the default)")
          ->check(one_word_of(formats::vtk_coding_names()));
  CLI::Option* pictures =
      options.add_flag("!--no-pictures", chosen.has_pictures, "draw no pictures; `keyblock plot` draws them later");
  pictures->excludes(field);
  CLI::Option* page =
      options.add_flag("--page", chosen.has_page,
                       "also write page.html, the run as one page for a browser; `keyblock view` writes it later");
  return {histories, contacts, field, frames, pictures, page};
}

}  // namespace keyblock
