// Declares the type of fields, and the ranges and words that several of them permit.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <type_traits>

#include "formats/format.hpp"
#include "formats/text/demands.hpp"

namespace keyblock::formats {

/// Type that a visitor F receives: const if it writes. Functions of a visitor for values: `real`, `integer` (with the
/// condition on the value), `index` (from 1 in the file, from 0 inside), `formula` (a number or a text). Also `flag`,
/// `word` (of an enumeration), `text`, `mass_by` (units that may replace a unit of mass), `optional_real`,
/// `optional_integer`. For structs: `row` (a struct as an array), `object`, `optional_object`, `optional_row`. For
/// vectors: `rows`, `objects` and `lists` (of rows), with their least size if the list is required. For curves:
/// `curve`, `curves` (rows of time and value); for words: `pairs` (an object of words).
template <class F, class T>
using In = std::conditional_t<F::is_writing, const T, T>;

inline constexpr Demand kAny{{}, "a number"};
inline constexpr Demand kWhole{{0}, "a whole number, 0 or more", true};

inline constexpr Demand kHalfRows{{0, false, 1000}, "a whole number from 0 to 1000", true};
inline constexpr Demand kMeshError{kMeshErrorRange, "at least 0 and below 1"};
inline constexpr Demand kMostUnknowns{kMeshLimitRange, kMeshLimitExpected, true};
inline constexpr Demand kStageSteps{{0, false, 1e9}, "a whole number from 0 to 1000000000", true};
inline constexpr Demand kStep{{}, "a whole number", true};

inline constexpr std::array<std::string_view, 4> kDialects{"berkeley", "shi", "ddaml", "manifold"};
inline constexpr std::array<std::string_view, 4> kCoverFunctions{"constant", "derived", "linear", "quadratic"};
inline constexpr std::array<std::string_view, 2> kCoverContacts{"felt", "ignored"};
inline constexpr std::array<std::string_view, 4> kHeld{"both", "normal", "x", "y"};
inline constexpr std::array<std::string_view, 2> kMeshKinds{"regular", "unstructured"};
inline constexpr std::array<std::string_view, 2> kMeshShapes{"equilateral", "old"};
inline constexpr std::array<std::string_view, 2> kMeshPlacements{"free", "aligned"};
inline constexpr std::array<std::string_view, 2> kTipFunctions{"none", "williams"};
inline constexpr std::array<std::string_view, 4> kYieldSurfaces{"tresca", "von_mises", "mohr_coulomb",
                                                                "drucker_prager"};
inline constexpr std::array<std::string_view, 3> kConeMatchings{"compression", "extension", "plane_strain"};
inline constexpr std::array<std::string_view, 3> kGrowthCriteria{"hoop_stress", "strain_energy", "energy_release"};
inline constexpr std::array<std::string_view, 3> kGrowthLoads{"automatic", "scaled", "given"};
inline constexpr std::array<std::string_view, 4> kContactTables{"automatic", "all", "chosen", "none"};
inline constexpr std::array<std::string_view, 2> kRotations{"first_order", "exact"};

inline constexpr double kDefaultEdgeNodeRatio = 0.001;  // as in DXF files and joint sets

}  // namespace keyblock::formats
