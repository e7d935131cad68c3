// Builds small DXF texts for tests, and reads them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "formats/registry.hpp"

namespace keyblock::formats {

/// Returns a DXF text with these entities: pairs of lines, the last one ended. `header` is the section HEADER.
inline std::string dxf_text(const std::string& entities, const std::string& header = "") {
  return "999\nkeyblock edge-node ratio 0.01\n0\nSECTION\n2\nHEADER\n" + header +
         "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
}

/// Returns a line from (0, 0) to (1000, 2000), with more pairs.
inline std::string dxf_line(const std::string& layer, const std::string& more = "") {
  return "0\nLINE\n8\n" + layer + "\n10\n0\n20\n0\n11\n1000\n21\n2000\n" + more;
}

/// Returns a circle of radius 2 about (3, 0).
inline std::string dxf_circle(const std::string& more) {
  return "0\nCIRCLE\n8\nJOINT_1\n10\n3\n20\n0\n40\n2\n" + more;
}

inline Reading read_entities(const std::string& entities, const std::string& header = "") {
  return read({"f", dxf_text(entities, header)});
}

/// Returns the first warning of this name; empty if there is none.
inline std::string sentence(const Reading& reading, const std::string& name) {
  for (const Warning& warning : reading.warnings)
    if (warning.name == name) return to_string(warning);
  return "";
}

/// Returns one entity of every kind that is read, laid out as drawing programs do, and some that are skipped.
inline const std::string kDxfSample = dxf_text(
    "  0\nLWPOLYLINE\n  5\n2A\n100\nAcDbEntity\n  8\nBOUNDARY_1\n100\nAcDbPolyline\n 90\n4\n 70\n1\n 43\n0.0\n"
    " 10\n0.0\n 20\n0.0\n 10\n8.0\n 20\n0.0\n 10\n8.0\n 20\n6.0\n 10\n0.0\n 20\n6.0\n"
    "  0\nLINE\n  8\nJOINT_2\n 10\n0.0\n 20\n3.0\n 30\n0.0\n 11\n8.0\n 21\n3.0\n 31\n0.0\n"
    "  0\nPOLYLINE\n  8\nJOINT_3\n 66\n1\n 10\n0.0\n 20\n0.0\n 30\n0.0\n 70\n0\n"
    "  0\nVERTEX\n  8\nJOINT_3\n 10\n4.0\n 20\n3.0\n 30\n0.0\n 42\n1.0\n"
    "  0\nVERTEX\n  8\nJOINT_3\n 10\n6.0\n 20\n3.0\n 30\n0.0\n"
    "  0\nVERTEX\n  8\nJOINT_3\n 10\n8.0\n 20\n3.0\n 30\n0.0\n  0\nSEQEND\n  8\nJOINT_3\n"
    "  0\nARC\n  8\nJOINT_3\n 10\n2.0\n 20\n3.0\n 40\n1.0\n 50\n0.0\n 51\n180.0\n"
    "  0\nCIRCLE\n  8\nJOINT_3\n 10\n2.0\n 20\n1.5\n 40\n0.5\n"
    "  0\nTEXT\n  8\nNOTES\n 10\n1.0\n 20\n1.0\n 40\n0.2\n  1\na bench\n"
    "  0\nLINE\n  8\nMATERIAL_2\n 10\n5.0\n 20\n5.0\n 11\n5.5\n 21\n5.0\n"
    "  0\nLINE\n  8\nBOLT_1\n 10\n1.0\n 20\n2.0\n 11\n1.0\n 21\n5.0\n1001\nKEYBLOCK\n1040\n1e6\n1040\n2e3\n1040\n50.0\n"
    "  0\nPOINT\n  8\nFIXED\n 10\n0.5\n 20\n0.5\n  0\nPOINT\n  8\nLOAD\n 10\n7.0\n 20\n5.0\n"
    "  0\nPOINT\n  8\nMEASURED\n 10\n7.0\n 20\n4.0\n  0\nPOINT\n  8\nHOLE\n 10\n2.0\n 20\n1.5\n");

}  // namespace keyblock::formats
