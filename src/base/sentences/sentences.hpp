// Makes the sentences of findings: one table of texts with places for values.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "base/sentences/sentences.hpp"
#include "base/words/finding.hpp"

namespace keyblock {

/// A row of the table. `text` has values in braces, `{name}` or `{name:format}`: a number or text of that name. `x` and
/// `y` are the first point, `x2` and `y2` the second, `element` and `other` the first two elements. Formats are those
/// of fmt; none: as people write it; `pN`: the same with N digits; `r`: all digits; `#noun`: count and noun; `?`:
/// nothing. `{elements}`: list of all elements. A part in brackets is left out if it has a value that is not there.
struct Sentence {
  std::string_view form;
  std::string_view text;
};

/// All rows, each part sorted by form.
std::span<const Sentence> sentences_ahead();
std::span<const Sentence> sentences_of_cases();
std::span<const Sentence> sentences_of_cuts();
std::span<const Sentence> sentences_of_readers();
std::span<const Sentence> sentences_of_runs();
std::span<const Sentence> sentences_of_steps();

/// Returns the sentence. Throws std::logic_error if the table has no such form or lacks a value.
std::string sentence_of(const Finding& finding);

/// Returns the sentence of the form `frame`, with `values`, in which {why} is the sentence of the finding.
std::string framed(std::string_view frame, const Facts& values, const Finding& why);

/// Returns the warning with its sentence.
Warning warning_of(Finding finding, const Place& place);

}  // namespace keyblock
