// Turns requests for sweeps, element tests and fits into commands.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "serve/child.hpp"
#include "serve/served_folder.hpp"

namespace keyblock::serve {

/// Returns the arguments of a sweep behind its case, "paths": "over" is a list of KEY=VALUES, "out" a list of results,
/// "zip" a flag. Throws BadRequest, and NotServed for values that name files outside of the folder.
std::vector<std::string> sweep_arguments(const ServedFolder& folder, const nlohmann::ordered_json& body);

/// Answers an element test ("path", "kind", "to", "material"?, "confining"?, "cycles"?, "steps"?) or a fit ("path",
/// "kind": curve, triaxial, chevron_bend, notched_disc or semicircular_bend, "friction"?): exit_code, record, svg,
/// table, messages. Throws BadRequest, NotServed.
nlohmann::ordered_json element_test(const ServedFolder& folder, const Drafts& drafts, const Program& program,
                                    const nlohmann::ordered_json& body);
nlohmann::ordered_json fitted_curve(const ServedFolder& folder, const Drafts& drafts, const Program& program,
                                    const nlohmann::ordered_json& body);

}  // namespace keyblock::serve
