// Reads case.json, key by key.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "api/case_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "api/named_files.hpp"
#include "formats/registry.hpp"
#include "run/settings_file.hpp"
#include "settings/profile.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kNotRun = "not run: ";

/// Value of the file and its key, for messages.
struct CaseValue {
  const CaseFolder& folder;
  const std::string& file;
  std::string key;
  const Json& json;

  [[noreturn]] void refuse(const std::string& expected) const {
    constexpr std::size_t kMost = 200;
    std::string found = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (found.size() > kMost) {
      std::size_t end = kMost;  // end of a whole character
      while (end > 0 && (static_cast<unsigned char>(found[end]) & 0xC0) == 0x80) --end;
      found = found.substr(0, end) + " …";
    }
    throw InputError({file, 0, 0},
                     fmt::format("key {}: expected {}, found {}", key.empty() ? "(top)" : key, expected, found));
  }
  CaseValue at(const std::string& name) const {
    return {folder, file, key.empty() ? name : key + "." + name, json.at(name)};
  }
  void require_object() const {
    if (!json.is_object()) refuse("an object");
  }
  void require_keys(const std::vector<std::string>& known) const {
    require_object();
    for (const auto& [name, value] : json.items())
      if (std::ranges::find(known, name) == known.end())
        throw InputError({file, 0, 0}, fmt::format("expected one of the keys {}, found \"{}\"", fmt::join(known, ", "),
                                                   key.empty() ? name : key + "." + name));
  }
  std::string text() const {
    if (!json.is_string() || json.get<std::string>().empty()) refuse("text in quotes");
    return json.get<std::string>();
  }
  bool flag() const {
    if (!json.is_boolean()) refuse("true or false");
    return json.get<bool>();
  }
};

bool takes(const std::string& name, const std::string& value) {
  try {
    require_setting(name, value);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

// A setting that takes off or on may be false or true.
std::string setting_text(const CaseValue& object, const std::string& name) {
  const Json& value = object.json.at(name);
  if (value.is_number()) return value.dump();
  if (value.is_boolean())
    if (const std::string word = value.get<bool>() ? "on" : "off"; takes(name, word) && !takes(name, value.dump()))
      return word;
  return object.at(name).text();
}

std::vector<Override> overrides_of(const CaseValue& object) {
  object.require_object();
  std::vector<Override> overrides;
  for (const auto& [name, value] : object.json.items())
    overrides.emplace_back(name, from_folder(object.folder.folder, name, setting_text(object, name)));
  return overrides;
}

// Wrong settings are reported here, with their key. Those of a variant are reported when it runs: the other runs
// remain.
std::vector<Override> checked(const CaseValue& object) {
  std::vector<Override> overrides = overrides_of(object);
  for (const auto& [name, value] : overrides) {
    try {
      require_setting(name, value);
    } catch (const std::invalid_argument& error) {
      throw InputError({object.file, 0, 0}, fmt::format("key {}.{}: {}", object.key, name, error.what()));
    }
  }
  return overrides;
}

void append(std::vector<Override>& list, const std::vector<Override>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

std::map<std::string, std::vector<Override>> sets_of(const CaseValue& set) {
  std::vector<std::string> known = rule_names();
  known.insert(known.begin(), "both");
  set.require_keys(known);
  std::map<std::string, std::vector<Override>> sets;
  for (const std::string& profile : rule_names())
    for (const std::string& key : {std::string("both"), profile})
      if (set.json.contains(key)) append(sets[profile], checked(set.at(key)));
  return sets;
}

double positive(const CaseValue& node) {
  const double value = node.json.is_number() ? node.json.get<double>() : 0;
  if (!std::isfinite(value) || value <= 0) node.refuse("a number greater than 0");
  return value;
}

Variant variant_of(const CaseValue& node) {
  node.require_keys({"name", "profile", "set", "tolerance", "reason"});
  for (const char* key : {"name", "profile", "set"})
    if (!node.json.contains(key)) node.refuse(fmt::format("the key \"{}\" in it", key));
  Variant variant{node.at("name").text(), node.at("profile").text(), overrides_of(node.at("set")), {}, {}};
  const std::vector<std::string> profiles = rule_names();
  if (std::ranges::find(profiles, variant.profile) == profiles.end())
    node.at("profile").refuse(fmt::format("one of {}", fmt::join(profiles, ", ")));
  if (node.json.contains("tolerance") != node.json.contains("reason"))
    node.refuse("\"tolerance\" and its \"reason\" together");
  if (!node.json.contains("tolerance")) return variant;
  variant.tolerance = positive(node.at("tolerance"));
  variant.reason = node.at("reason").text();
  return variant;
}

std::vector<std::string> exempt_words(const CaseValue& list) {
  if (!list.json.is_array()) list.refuse("a list of texts");
  std::vector<std::string> words;
  for (const Json& word : list.json) words.push_back(CaseValue{list.folder, list.file, list.key, word}.text());
  try {
    exempt_of(words);
  } catch (const std::invalid_argument& error) {
    throw InputError({list.file, 0, 0}, error.what());
  }
  return words;
}

ReductionAsked reduction_of(const CaseValue& node) {
  node.require_keys({"what", "from", "to", "to_within", "exempt"});
  if (!node.json.contains("what")) node.refuse("the key \"what\" in it");
  ReductionAsked asked;
  try {
    asked.what = reduced_of(node.at("what").text());
  } catch (const std::invalid_argument&) {
    node.at("what").refuse("joints, rock or both");
  }
  if (node.json.contains("from")) asked.from = positive(node.at("from"));
  if (node.json.contains("to")) asked.to = positive(node.at("to"));
  if (asked.to && *asked.to <= asked.from.value_or(1)) node.at("to").refuse("a number greater than that of \"from\"");
  if (node.json.contains("to_within")) asked.within = positive(node.at("to_within"));
  if (node.json.contains("exempt")) asked.exempt = exempt_words(node.at("exempt"));
  return asked;
}

// At the top.
std::vector<std::string> known_keys() {
  std::vector<std::string> known{"about", "slow", "set", "variants", "reduce_strength"};
  for (const std::string& profile : rule_names()) known.push_back(profile);
  return known;
}

Json parsed(const std::string& path) {
  constexpr int kDeepest = 12;  // levels, as in a case file
  const auto require_flat = [&](int depth, Json::parse_event_t, const Json&) {
    if (depth > kDeepest) throw InputError({path, 0, 0}, fmt::format("expected at most {} levels", kDeepest));
    return true;
  };
  try {
    return Json::parse(formats::load(path).text, require_flat);
  } catch (const Json::exception& error) {
    throw InputError({path, 0, 0}, fmt::format("expected JSON: {}", error.what()));
  }
}

// A name in the list includes the list of that file. `outer`: the files that include this one.
std::vector<Variant> variants_of(const CaseValue& list, std::vector<std::string> outer = {}) {
  if (!list.json.is_array()) list.refuse("a list");
  std::vector<Variant> variants;
  for (std::size_t i = 0; i < list.json.size(); ++i) {
    const CaseValue node{list.folder, list.file, fmt::format("{}[{}]", list.key, i), list.json[i]};
    if (!node.json.is_string()) {
      variants.push_back(variant_of(node));
      continue;
    }
    const std::string path = (list.folder.folder / node.text()).lexically_normal().string();
    outer.push_back(list.file);
    if (std::ranges::find(outer, path) != outer.end()) node.refuse("a list that does not lead back to itself");
    const Json shared = parsed(path);
    for (Variant& variant : variants_of({list.folder, path, "", shared}, outer)) variants.push_back(std::move(variant));
  }
  return variants;
}

std::string reason_of(const CaseValue& node) {
  const std::string text = node.text();
  if (!text.starts_with(kNotRun) || text.size() == kNotRun.size()) node.refuse("\"not run: REASON\"");
  return text.substr(kNotRun.size());
}

}  // namespace

std::vector<Override> CaseFile::overrides(const std::string& profile) const {
  const auto found = set.find(rules_of(profile));
  return found == set.end() ? std::vector<Override>{} : found->second;
}

bool is_case_notes(const std::filesystem::path& file) {
  if (file.filename() != "case.json") return false;
  std::ifstream stream(file, std::ios::binary);
  const Json json = Json::parse(stream, nullptr, false);
  if (!json.is_object() || json.empty()) return false;
  const std::vector<std::string> known = known_keys();
  return std::ranges::all_of(json.items(),
                             [&](const auto& item) { return std::ranges::find(known, item.key()) != known.end(); });
}

CaseFile read_case_file(const CaseFolder& folder) {
  CaseFile file;
  file.path = (folder.folder / "case.json").string();
  if (!std::filesystem::exists(std::filesystem::symlink_status(file.path)))
    return file;  // a link to nothing exists, and cannot be read below
  const Json json = parsed(file.path);
  const CaseValue top{folder, file.path, "", json};
  top.require_keys(known_keys());
  if (json.contains("about")) file.about = top.at("about").text();
  if (json.contains("slow")) file.is_slow = top.at("slow").flag();
  if (json.contains("set")) file.set = sets_of(top.at("set"));
  if (json.contains("reduce_strength")) file.reduction = reduction_of(top.at("reduce_strength"));
  if (json.contains("variants")) file.variants = variants_of(top.at("variants"));
  for (const std::string& profile : rule_names())
    if (json.contains(profile)) file.not_run[profile] = reason_of(top.at(profile));
  return file;
}

}  // namespace keyblock
