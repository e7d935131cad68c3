// Writes a document of sections, tables and pictures as one HTML page, which needs no other file and prints on A4.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace keyblock::report {

/// Each row has as many cells as there are columns. A column of numbers aligns to the right.
struct DocumentTable {
  std::vector<std::string> columns;  ///< empty headings if all are empty
  std::vector<std::vector<std::string>> rows;
};

struct DocumentPicture {
  std::string svg;
  std::string caption;
};

struct DocumentSection {
  std::string heading;
  std::vector<std::string> paragraphs = {};
  std::vector<DocumentPicture> pictures = {};
  std::vector<DocumentTable> tables = {};
  std::string anchor = {};  ///< of links; empty: none
};

enum class Verdict { good, doubtful, bad };

/// Link to a file beside the page; `path` is one of its folder, as it stands on the disk.
struct DocumentLink {
  std::string words;
  std::string path;
  bool is_picture = false;  ///< shown as a picture with the words below it
};

/// Summary of one result among many: a small picture and a few lines, with a link to a section.
struct DocumentCard {
  std::string title;
  std::string anchor;
  std::string svg;  ///< small picture; empty: none
  Verdict verdict = Verdict::good;
  std::string state;  ///< verdict in words; the filter offers those of all cards
  std::vector<std::string> lines;
  std::vector<DocumentLink> links = {};
};

struct Document {
  std::string title;
  std::string subtitle;  ///< kind of report
  Verdict verdict = Verdict::good;
  std::string verdict_in_words;
  std::vector<DocumentSection> sections;
  std::vector<std::pair<std::string, std::string>> facts = {};  ///< project, program, dates
  std::vector<DocumentCard> cards =
      {};  ///< stand before the sections, with a filter; without any, links to sections do
};

/// Returns the page. Texts may hold any characters; pictures are embedded as images, so that no script of theirs runs.
std::string document_page(const Document& document);

}  // namespace keyblock::report
