// Reads the `Geometry` element of DDAML.
// SPDX-License-Identifier: GPL-3.0-or-later
//
//   Edgenodedist distance                     required
//   Jointlist > Joint type       x1 y1 x2 y2  type: joint material from 1, required
//   Boundlist > Line             x1 y1 x2 y2  boundary lines: placed first (Berkeley's reader drops them); joint
//                                             material 1, or that of an attribute type, an extension of Keyblock
//   Fixedpointlist > Line, Point              4 or 2 numbers
//   Loadpointlist, Measuredpointlist, Holepointlist > Point   x y
//   Boltlist > Bolt type         x1 y1 x2 y2  type: bolt properties of the analysis from 1, default 1
//   Matlinelist > Line type      x1 y1 x2 y2  type: block material from 1; or a fifth number instead
// Lists may be absent, repeated and in any order. Seismic points and pipe flow are skipped with a warning.
#pragma once

#include "formats/xml/xml_document.hpp"

namespace keyblock::formats {

struct GeometryReading {
  Drawing drawing;
  Warnings warnings;
};

GeometryReading read_geometry(const Element& geometry);

}  // namespace keyblock::formats
