// Reads the `Analysis` element of DDAML.
// SPDX-License-Identifier: GPL-3.0-or-later
//
//   Numtimesteps timesteps, Maxtimestep maxtimestep, Maxdisplacement maxdisplacement   required
//   Analysistype type       dynamic, otherwise static; default static, with a warning
//   Rotation type           linear; secondorder and exact are both exact; default linear, with a warning
//   Gravity flag            yes: Berkeley's gravity phase, which is skipped; default no, with a warning
//   Gravaccel value         length / time²; default 9.81, with a warning
//   Autotimestep flag       default no, with a warning; the same for Planestrain flag
//   Autopenalty flag, pfactor   pfactor × largest E is the starting penalty, flag only lets it change; default 50 with
//                               a warning: Berkeley's own default, 0, leaves contacts without stiffness
//   Opencloselimit or OCLimit maxopenclose   default 8
//   Saveinterval step       1 if absent, 10 if empty or 0
//   AConstants > Openclose, Opencriteria, NormSpringPen, AngleOverlap, ShearNormRatio value
//                           defaults 2e-4, 2e-7, 4e-4, 3, 2.5
//   ContactDamping value    default 0
//   Blockmaterial > Unitmass, Unitweight, Youngsmod, Poissonratio; Damping (0 with a warning);
//                           Istress, Ivelocity, Istrain: three numbers each, 0 by default. Read by name; Berkeley's
//                           program uses Ivelocity as stress gradient too and Istrain hardly at all (legacy-rules 16.1)
//   Jointproperties > Friction, Cohesion, Tensile
//   Boltproperties          stiffness, strength, pre-tension
//   Loadpointlist > Loadpoint numpoints ≥ 2   t px py; …   one curve per loading point, in order
// A rerun does not need Mintimestep, Writevertices and MinReflineFactor; they are ignored without a warning.
#pragma once

#include "formats/xml/xml_document.hpp"

namespace keyblock::formats {

struct AnalysisReading {
  Analysis analysis;
  Warnings warnings;
};

AnalysisReading read_analysis(const Element& analysis);

}  // namespace keyblock::formats
