// Applies one rule of pairing after another, folder by folder, to the files left by earlier rules.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/batch/batch_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

namespace keyblock::study {
namespace {

using Files = std::vector<const BatchFile*>;

struct Pair {
  const BatchFile* geometry;
  const BatchFile* analysis;
  std::string reason;
};

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string folder_of(const BatchFile& file) {
  return std::filesystem::path(file.path).parent_path().generic_string();
}

std::string stem_of(const BatchFile& file) {
  return lower(std::filesystem::path(file.path).stem().string());
}

// Prefixes that users of Shi's programs gave their files.
std::string without_beginning(const BatchFile& file) {
  constexpr std::array<std::string_view, 9> kBeginnings{"blck", "blk", "geo", "ana", "cv", "mf", "df", "dc", "dl"};
  const std::string stem = stem_of(file);
  for (const std::string_view beginning : kBeginnings)
    if (stem.starts_with(beginning) && stem.size() > beginning.size()) return stem.substr(beginning.size());
  return {};
}

std::string numbers_in(const BatchFile& file) {
  std::string numbers;
  for (const char c : stem_of(file)) {
    const bool is_digit = std::isdigit(static_cast<unsigned char>(c)) != 0;
    if (is_digit) numbers += c;
    if (!is_digit && !numbers.empty() && numbers.back() != ' ') numbers += ' ';
  }
  while (numbers.ends_with(' ')) numbers.pop_back();
  return numbers;
}

bool contradict(const BatchFile& geometry, const BatchFile& analysis) {
  return geometry.counts && analysis.counts && geometry.counts->is_manifold != analysis.counts->is_manifold;
}

/// Files in one folder that are not paired yet.
struct Folder {
  Files geometries;
  Files analyses;
  Files unreadable;
  std::vector<Pair> pairs;

  void take(const BatchFile* geometry, const BatchFile* analysis, const std::string& reason) {
    pairs.push_back({geometry, analysis, reason});
  }

  /// Removes files that are in a pair.
  void drop_paired() {
    for (Files* list : {&geometries, &analyses, &unreadable})
      std::erase_if(*list, [&](const BatchFile* file) {
        return std::ranges::any_of(pairs, [&](const Pair& p) { return p.geometry == file || p.analysis == file; });
      });
  }
};

using Key = std::string (*)(const BatchFile&);

std::map<std::string, Files> by_key(const Files& files, Key key) {
  std::map<std::string, Files> groups;
  for (const BatchFile* file : files)
    if (std::string text = key(*file); !text.empty()) groups[std::move(text)].push_back(file);
  return groups;
}

// Pairs every drawing and block file of a name with every analysis of that name.
void pair_by_stem(Folder& folder) {
  const auto geometries = by_key(folder.geometries, stem_of);
  const auto analyses = by_key(folder.analyses, stem_of);
  const auto unreadable = by_key(folder.unreadable, stem_of);
  const auto of = [](const std::map<std::string, Files>& groups, const std::string& stem) {
    const auto found = groups.find(stem);
    return found == groups.end() ? Files{} : found->second;
  };
  for (const auto& [stem, group] : geometries)
    for (const BatchFile* geometry : group)
      for (const BatchFile* analysis : of(analyses, stem))
        if (!contradict(*geometry, *analysis)) folder.take(geometry, analysis, "the same name");
  const std::string guessed = "the same name, though one file is unreadable";
  for (const auto& [stem, group] : unreadable) {
    const Files known_geometries = of(geometries, stem);
    const Files known_analyses = of(analyses, stem);
    if (group.size() != 1 || known_geometries.size() + known_analyses.size() != 1) continue;
    if (known_geometries.empty()) folder.take(group.front(), known_analyses.front(), guessed);
    if (known_analyses.empty()) folder.take(known_geometries.front(), group.front(), guessed);
  }
  folder.drop_paired();
}

// Pairs only if a key names exactly one geometry and one analysis.
void pair_by_key(Folder& folder, Key key, std::string_view reason) {
  const auto analyses = by_key(folder.analyses, key);
  for (const auto& [text, group] : by_key(folder.geometries, key)) {
    const auto found = analyses.find(text);
    if (found == analyses.end() || group.size() != 1 || found->second.size() != 1) continue;
    if (contradict(*group.front(), *found->second.front())) continue;
    folder.take(group.front(), found->second.front(), fmt::format("{} ({})", reason, text));
  }
  folder.drop_paired();
}

void pair_the_only(Folder& folder) {
  if (folder.geometries.size() != 1 || folder.analyses.size() != 1) return;
  if (contradict(*folder.geometries.front(), *folder.analyses.front())) return;
  folder.take(folder.geometries.front(), folder.analyses.front(), "the only geometry and analysis left in the folder");
  folder.drop_paired();
}

std::string counted_reason(const FitCounts& counts) {
  return fmt::format("counts that fit nothing else: {} block materials, {} joint materials, {} loading points",
                     counts.block_materials, counts.joint_materials, counts.loading_points);
}

void pair_by_counts(Folder& folder, const FitsTogether& fits) {
  std::size_t trials = 0;
  const auto fit = [&](const BatchFile& geometry, const BatchFile& analysis) {
    if (!geometry.counts) return false;
    if (analysis.counts) return *geometry.counts == *analysis.counts;
    return ++trials <= kMostTrials && fits(geometry, analysis);
  };
  std::map<const BatchFile*, Files> partners;
  for (const BatchFile* geometry : folder.geometries)
    for (const BatchFile* analysis : folder.analyses)
      if (fit(*geometry, *analysis)) {
        partners[geometry].push_back(analysis);
        partners[analysis].push_back(geometry);
      }
  if (trials > kMostTrials) return;
  for (const BatchFile* analysis : folder.analyses)
    if (partners[analysis].size() == 1) {
      const BatchFile* geometry = partners[analysis].front();
      folder.take(geometry, analysis, counted_reason(*geometry->counts));
    }
  folder.drop_paired();
}

// For one scene analysed in several ways: analyses that no other rule paired go with the only geometry.
void pair_with_the_one(Folder& folder, const Files& geometries) {
  if (geometries.size() != 1) return;
  for (const BatchFile* analysis : folder.analyses)
    if (!contradict(*geometries.front(), *analysis))
      folder.take(geometries.front(), analysis, "the only geometry in the folder");
  folder.drop_paired();
}

std::string file_name(const BatchFile& file) {
  return std::filesystem::path(file.path).filename().string();
}

void add_pairs(const Folder& folder, std::vector<BatchJob>& jobs) {
  for (const Pair& pair : folder.pairs) {
    const auto has_this = [&](const Pair& other) { return other.geometry == pair.geometry; };
    const bool is_one_of_several = std::ranges::count_if(folder.pairs, has_this) > 1;
    const std::string& path = pair.geometry->path;
    jobs.push_back({is_one_of_several ? path + "+" + file_name(*pair.analysis) : path,
                    {path, pair.analysis->path},
                    JobKind::whole,
                    pair.reason});
  }
}

void add_alone(const Files& files, std::string_view reason, JobKind kind, std::vector<BatchJob>& jobs) {
  for (const BatchFile* file : files) jobs.push_back({file->path, {file->path}, kind, std::string(reason)});
}

}  // namespace

std::vector<BatchJob> pair_files(const std::vector<BatchFile>& files, const FitsTogether& fits) {
  std::map<std::string, Folder> folders;
  std::vector<BatchJob> jobs;
  for (const BatchFile& file : files) {
    Folder& folder = folders[folder_of(file)];
    switch (file.role) {
      case FileRole::geometry:
        folder.geometries.push_back(&file);
        break;
      case FileRole::analysis:
        folder.analyses.push_back(&file);
        break;
      case FileRole::unreadable:
        folder.unreadable.push_back(&file);
        break;
      case FileRole::whole_case:
        add_alone({&file}, "geometry and analysis in one file", JobKind::whole, jobs);
        break;
      case FileRole::side_file:
      case FileRole::foreign:
        add_alone({&file}, name_of(file.role), JobKind::listed, jobs);
        break;
    }
  }
  for (auto& [path, folder] : folders) {
    const Files geometries = folder.geometries;
    pair_by_stem(folder);
    pair_by_key(folder, without_beginning, "the same name after its beginning");
    pair_by_key(folder, numbers_in, "the same numbers in the names");
    pair_the_only(folder);
    pair_by_counts(folder, fits);
    pair_with_the_one(folder, geometries);
    add_pairs(folder, jobs);
    add_alone(folder.geometries, "a geometry alone", JobKind::part, jobs);
    add_alone(folder.analyses, "an analysis alone", JobKind::part, jobs);
    add_alone(folder.unreadable, "unreadable", JobKind::part, jobs);
  }
  std::ranges::sort(jobs, {}, &BatchJob::name);
  return jobs;
}

}  // namespace keyblock::study
