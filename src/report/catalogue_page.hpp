// Writes the catalogue of an archive, one row per job, as a page.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace keyblock::report {

struct CatalogueFile {
  std::string path;    ///< below the folder of the archive
  std::string format;  ///< empty if none fits
  std::string sha256;  ///< empty if the file was too large to be read
};

/// Outcome of a job: a word by which jobs are counted, and the reason.
struct CatalogueVerdict {
  std::string word;
  std::string why = {};
};

/// Extremes of a run over all its elements, at its end.
struct CatalogueMeasures {
  double displacement = 0;     ///< greatest of a vertex since the start
  double least_stress = 0;     ///< principal, tension positive
  double greatest_stress = 0;  ///< the same
  int contacts = 0;            ///< most in a step
  bool is_static = false;      ///< with a share of the way to equilibrium, or without any sign of one
  std::optional<double> equilibrium_share;
  int displaced_element = 0;  ///< number, from 1, of the element of that vertex; 0: not known
};

/// End of a run.
struct CatalogueAnswer {
  std::string profile;
  std::string end;      ///< "finished", or the reason of an early end
  int steps = 0;        ///< accepted
  double time = 0;      ///< reached
  std::string of_what;  ///< "measured point 2", "centroid of block 3"; empty where nothing was reached
  double dx = 0;        ///< its displacement since the start, in the file's unit
  double dy = 0;
  std::optional<CatalogueMeasures> measures;
  std::string doubt = {};  ///< why a finished run is unreliable; empty if it is not
  /// Why it ended before, as `outcome.failure` of run.json: "no_equilibrium", "undecided", …; empty where not known.
  std::string failure = {};
  std::string reason = {};  ///< of the failure
  bool has_result = true;   ///< false if the run wrote none
};

struct CatalogueRow {
  std::string name;
  std::vector<CatalogueFile> files;  ///< geometry first
  std::string paired_by;
  std::optional<int> blocks;    ///< as given or as cut
  std::optional<int> elements;  ///< of a cover
  std::optional<int> steps;     ///< of the analysis
  std::string scene;            ///< the scene in words; empty if geometry or analysis is missing
  std::string outcome;          ///< "ok", "warnings", "failed" or "listed": whether anything was wrong
  CatalogueVerdict verdict = {};
  int warnings = 0;
  std::string message;  ///< the first error, else the first warning
  std::vector<CatalogueAnswer> answers;
  std::optional<double> difference;  ///< distance of the last answer from the first
  std::string expected;              ///< verdict over the values of expected.csv beside the files; empty without any
  std::vector<std::string> outputs;  ///< files written, below the results' folder; of runs a folder an answer
  std::string thumbnail;             ///< an SVG element; empty where there is no geometry

  std::string formats() const;  ///< of all files, joined by " + "
};

/// Returns a displacement as text: its components and its length.
std::string text_of(const CatalogueAnswer& answer);

/// Returns "26 jobs: 8 ran (31 %), 4 differ (15 %), 1 without equilibrium (4 %), 13 read (50 %)".
std::string summary_of(const std::vector<CatalogueRow>& rows);

/// Returns the document of the catalogue: a card per job, a table that a click on a heading sorts, a section per job.
/// Cards have the small picture, the pictures of runs that `outputs` names, and links to their records and logs.
std::string catalogue_page(const std::string& title, const std::vector<CatalogueRow>& rows);

}  // namespace keyblock::report
