// Requests are accepted by host, origin, token and cookie; paths stay within the folder; words become no options.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/http/guard.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "base/bytes/sound_json.hpp"
#include "serve/request_words.hpp"
#include "serve/run_differences.hpp"
#include "serve/window_words.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::guard_test {
namespace {

using Json = nlohmann::ordered_json;
using serve::Guard;
using serve::Request;

constexpr const char* kHost = "127.0.0.1:8000";

std::string cookie_of(const Guard& guard, const std::string& token) {
  const auto reply = guard.answer({"GET", "/?token=" + token, kHost, "", "", "", ""});
  if (!reply || reply->status != 303) return {};
  for (const auto& [name, value] : reply->headers)
    if (name == "Set-Cookie") return value.substr(0, value.find(';'));
  return {};
}

int status_of(const Guard& guard, const Request& request) {
  const auto reply = guard.answer(request);
  return reply ? reply->status : 200;
}

TEST(Guard, the_token_gives_a_cookie_and_only_the_cookie_lets_in) {
  const std::string token = serve::random_token();
  EXPECT_EQ(token.size(), 64U);
  EXPECT_NE(token, serve::random_token());
  const Guard guard(token, 8000);
  EXPECT_EQ(guard.address(), "http://127.0.0.1:8000/?token=" + token);
  const std::string cookie = cookie_of(guard, token);
  ASSERT_FALSE(cookie.empty());
  EXPECT_EQ(cookie_of(guard, token.substr(1)), "");
  EXPECT_EQ(status_of(guard, {"GET", "/api/list", kHost, "", cookie, "", ""}), 200);
  EXPECT_EQ(status_of(guard, {"GET", "/api/list", "localhost:8000", "", "a=b; " + cookie + ";c=d", "", ""}), 200);
  EXPECT_EQ(status_of(guard, {"GET", "/api/list", kHost, "", "", "", ""}), 403);
  EXPECT_EQ(status_of(guard, {"GET", "/api/list", kHost, "", cookie + "0", "", ""}), 403);
  EXPECT_EQ(status_of(guard, {"GET", "/api/list?token=" + token, kHost, "", "", "", ""}), 403);
  EXPECT_EQ(status_of(guard, {"POST", "/?token=" + token, kHost, "http://127.0.0.1:8000", "", "", ""}), 403);
  EXPECT_EQ(status_of(Guard(token, 8000), {"GET", "/api/list", kHost, "", cookie, "", ""}), 403) << "another server";
}

TEST(Guard, foreign_hosts_and_origins_are_refused) {
  const std::string token = serve::random_token();
  const Guard guard(token, 8000);
  const std::string cookie = cookie_of(guard, token);
  const auto post = [&](const std::string& host, const std::string& origin, const std::string& type) {
    return status_of(guard, {"POST", "/api/save", host, origin, cookie, type, "{}"});
  };
  EXPECT_EQ(post(kHost, "http://127.0.0.1:8000", "application/json; charset=utf-8"), 200);
  EXPECT_EQ(post(kHost, "http://127.0.0.1:8000", "Application/JSON ;charset=utf-8"), 200);
  for (const char* type : {"text/plain", "application/jsonx", "application/json-seq", "application/json x", ""})
    EXPECT_EQ(post(kHost, "http://127.0.0.1:8000", type), 415) << type;
  EXPECT_EQ(post(kHost, "", "application/json"), 403);
  EXPECT_EQ(post(kHost, "http://127.0.0.1:80000", "application/json"), 403);
  EXPECT_EQ(post(kHost, "null", "application/json"), 403);
  EXPECT_EQ(post("evil.example:8000", "http://127.0.0.1:8000", "application/json"), 403);
  EXPECT_EQ(status_of(guard, {"DELETE", "/", kHost, "", cookie, "", ""}), 405);
}

TEST(Guard, targets_are_decoded) {
  const serve::Target target = serve::target_of("/api/read?path=a%20b%2Fc+d&numbers&x=%zz");
  EXPECT_EQ(target.path, "/api/read");
  EXPECT_EQ(target.parameters.at("path"), "a b/c d");
  EXPECT_EQ(target.parameters.at("numbers"), "");
  EXPECT_EQ(target.parameters.at("x"), "%zz");
}

TEST(ServedFolder, no_path_leads_out) {
  const std::string top = support::fresh_folder("served");
  std::filesystem::create_directories(top + "/in/side");
  std::filesystem::create_symlink(top, top + "/in/out");
  support::write_text(top + "/secret", "x");
  support::write_text(top + "/in/-o", "{}");
  const serve::ServedFolder folder(top + "/in");
  EXPECT_EQ(folder.name(folder.whole("side/new.json")), "side/new.json");
  EXPECT_EQ(serve::file_argument(folder, "-o"), "./-o");
  const std::vector<std::string> outside{"../secret", "/etc/passwd", "side/../../secret",      "out/secret", "",
                                         "side/.x",   "none/x",      std::string("side\0x", 6)};
  for (const std::string& path : outside) EXPECT_THROW(folder.whole(path), serve::NotServed) << path;
  EXPECT_THROW(serve::file_argument(folder, "side/none"), serve::NotServed);
}

TEST(ServedFolder, sweeps_are_results_and_batches_are_not) {
  const std::string top = support::fresh_folder("served_kinds");
  for (const char* folder : {"/sweep/jobs", "/batch/jobs/a/frames"}) std::filesystem::create_directories(top + folder);
  support::write_text(top + "/sweep/journal.jsonl", "{\"sweep\":1}\n");
  support::write_text(top + "/batch/journal.jsonl", "{\"batch\":1}\n");
  const Json results = serve::ServedFolder(top).list().at("results");
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].at("path"), "batch/jobs/a");
  EXPECT_EQ(results[0].at("kind"), "run");
  EXPECT_EQ(results[1].at("path"), "sweep");
  EXPECT_EQ(results[1].at("kind"), "sweep");
  EXPECT_FALSE(results[1].at("is_finished").get<bool>());
}

TEST(ServedFolder, a_broken_record_is_a_broken_result_and_no_case) {
  const std::string top = support::fresh_folder("served_broken");
  for (const char* folder : {"/broken", "/sound", "/framed/frames", "/cases"})
    std::filesystem::create_directories(top + folder);
  support::write_text(top + "/broken/run.json", "{\"program\": \"keyblock\", \"verdi");
  support::write_text(top + "/framed/run.json", "");
  support::write_text(top + "/sound/run.json", "{\"program\": \"keyblock\"}");
  support::write_text(top + "/cases/run.json", "// a case\n{\"keyblock\": 2, oops");
  const Json list = serve::ServedFolder(top).list();
  const Json& results = list.at("results");
  ASSERT_EQ(results.size(), 3U);
  const std::vector<bool> broken{true, true, false};
  for (std::size_t i = 0; i < broken.size(); ++i) EXPECT_EQ(results[i].at("is_broken"), broken[i]) << results[i];
  ASSERT_EQ(list.at("files").size(), 1U);
  EXPECT_EQ(list.at("files")[0].at("path"), "cases/run.json");
}

TEST(RequestWords, settings_become_no_options) {
  const serve::ServedFolder folder(support::fresh_folder("served_words"));
  EXPECT_EQ(serve::setting_arguments(folder, Json::parse(R"({"profile": "standard", "set": {"steps": "-5"}})")),
            (std::vector<std::string>{"--profile", "standard", "--set", "steps=-5"}));
  for (const char* body : {R"({"profile": "--force"})", R"({"profile": 3})", R"({"set": {"-o": "1"}})",
                           R"({"set": {"steps": 5}})", R"({"set": ["steps=5"]})", R"({"set": {"": "1"}})"})
    EXPECT_THROW(serve::setting_arguments(folder, Json::parse(body)), serve::BadRequest) << body;
  EXPECT_THROW(serve::setting_arguments(folder, Json::parse(R"({"set": {"body_acceleration_file": "../x"}})")),
               serve::NotServed);
}

TEST(RequestWords, errors_have_their_place) {
  const Json errors = serve::errors_in(
      "note\na b.json:12:3: error: expected x, found \"y: error: z\"\nc.geo:7: error: one\nkeyblock: error: two\n");
  ASSERT_EQ(errors.size(), 3U);
  EXPECT_EQ(errors[0], Json::parse(R"({"file": "a b.json", "line": 12, "column": 3,
                                       "sentence": "expected x, found \"y: error: z\""})"));
  EXPECT_EQ(errors[1], Json::parse(R"({"file": "c.geo", "line": 7, "sentence": "one"})"));
  EXPECT_EQ(errors[2], Json::parse(R"({"file": "keyblock", "sentence": "two"})"));
}

TEST(RequestWords, members_of_a_wrong_kind_are_refused) {
  EXPECT_TRUE(serve::flag(Json::parse(R"({"overwrite": true})"), "overwrite"));
  EXPECT_FALSE(serve::flag(Json::parse("{}"), "overwrite"));
  for (const char* body : {R"({"overwrite": 1})", R"({"overwrite": "true"})", R"({"overwrite": null})"})
    EXPECT_THROW(serve::flag(Json::parse(body), "overwrite"), serve::BadRequest) << body;
  EXPECT_EQ(serve::histories_in(Json::parse(R"({"histories": ["crest=point:12,20"]})")).size(), 1U);
  for (const char* body : {R"({"histories": ["crest=punkt:12,20"]})", R"({"histories": "point:1,2"})",
                           R"({"histories": [3]})", R"({"histories": ["point:1"]})"})
    EXPECT_THROW(serve::histories_in(Json::parse(body)), serve::BadRequest) << body;
}

TEST(WindowWords, options_of_the_command_line_become_words) {
  EXPECT_EQ(serve::window_words("--set slivers=glue joins them"), "Setting slivers = glue joins them");
  EXPECT_EQ(serve::window_words("else --set stiffness_damping=TIME."), "else setting stiffness_damping = TIME.");
  EXPECT_EQ(serve::window_words("use --profile standard"), "use profile standard");
  EXPECT_EQ(serve::window_words("x exists; give another name, or --force to overwrite it"),
            "x exists; give another name");
  EXPECT_EQ(serve::window_words("Give the unit by --unit."), "Give the unit by option unit of the command line.");
  EXPECT_EQ(serve::window_words("a - b, -3 -- 4"), "a - b, -3 -- 4");
  for (const char* kept : {"./--force/run.json: error", "--force/run.json", "--rf.json"})
    EXPECT_EQ(serve::window_words(kept), kept);
}

TEST(RequestWords, warnings_of_a_report_get_their_level_and_remedy) {
  Json report = Json::parse(R"({"case": {"warnings": [{"name": "slivers", "sentence": "x"}], "errors": ["y"]}})");
  serve::add_levels(report);
  const Json& warning = report["case"]["warnings"][0];
  EXPECT_EQ(warning.at("level"), "warning");
  const std::string remedy = warning.at("remedy");
  EXPECT_TRUE(remedy.starts_with("Setting slivers = glue")) << remedy;
}

TEST(WindowWords, buttons_and_forms_have_their_names) {
  EXPECT_EQ(serve::window_words("`keyblock run --resume out` goes on"), "the button Go on goes on");
  EXPECT_EQ(serve::window_words("give these settings by --set, to keep them"),
            "give these settings in the form Run, to keep them");
}

TEST(RequestWords, lists_and_settings_are_bounded) {
  Json many = Json::object();
  for (int i = 0; i < 1000; ++i) many["set"]["name" + std::to_string(i)] = "1";
  const std::string top = keyblock::support::fresh_folder("bounded_requests");
  EXPECT_THROW(serve::setting_arguments(serve::ServedFolder(top), many), serve::BadRequest);
  const Json files = {{"paths", std::vector<std::string>(1000, "a.json")}};
  EXPECT_THROW(serve::texts(files, "paths"), serve::BadRequest);
  EXPECT_THROW(serve::texts(Json{{"paths", {std::string(100'000, 'a')}}}, "paths"), serve::BadRequest);
}

TEST(SoundJson, deep_values_are_discarded_and_others_read) {
  const auto nested = [](int levels) { return std::string(levels, '[') + "1" + std::string(levels, ']'); };
  EXPECT_FALSE(sound_json(nested(kMostJsonLevels)).is_discarded());
  for (const int levels : {kMostJsonLevels + 2, 200'000})
    EXPECT_TRUE(sound_json(nested(levels)).is_discarded()) << levels;
  EXPECT_TRUE(sound_json("{").is_discarded());
  EXPECT_EQ(sound_json(R"({"b": 1, "a": [2]} // x)", true).dump(), R"({"b":1,"a":[2]})");
}

TEST(ServedFolder, old_files_without_endings_are_listed) {
  const std::string top = keyblock::support::fresh_folder("old_names");
  for (const char* name : {"cv15", "mf15", "dc01", "df01", "a.mf", "readme", "notes.pdf"})
    keyblock::support::write_text(top + "/" + name, "1\n");
  Json names = Json::array();
  const Json files = serve::ServedFolder(top).list().at("files");
  for (const Json& file : files) names.push_back(file.at("path"));
  EXPECT_EQ(names, Json({"a.mf", "cv15", "dc01", "df01", "mf15"}));
}

TEST(RunDifferences, numbers_of_other_units_are_compared_in_si) {
  const Json first = Json::parse(R"({"a": 2, "b": [5], "c": 3, "unit_of": {"a": "m", "b[]": "kPa", "c": "m"}})");
  const Json second =
      Json::parse(R"({"a": 2000, "b": [5], "c": 6000, "unit_of": {"a": "mm", "b[]": "Pa", "c": "mm"}})");
  const Json found = serve::run_differences(first, second);
  ASSERT_EQ(found.size(), 2U) << found.dump();
  EXPECT_EQ(found[0]["path"], "b[1]");
  EXPECT_NEAR(found[0]["relative"].get<double>(), 0.999, 1e-12);
  EXPECT_EQ(found[1],
            Json::parse(R"({"path": "c", "first": 3, "second": 6000, "relative": 0.5, "units": ["m", "mm"]})"));
}

TEST(RunDifferences, names_with_very_many_digits_are_compared) {
  const std::string name = "[" + std::string(1'000'000, '1');
  EXPECT_EQ(serve::run_differences(Json{{name, 1}}, Json{{name, 2}}).size(), 1U);
}

TEST(RunDifferences, values_that_differ_are_listed_with_their_paths) {
  const Json first = Json::parse(R"({"a": 1, "b": {"c": [1, 2], "d": "x"}, "seconds": {"run": 1}, "e": 4})");
  const Json second = Json::parse(R"({"a": 1, "b": {"c": [1, 4], "d": "y"}, "seconds": {"run": 2}, "f": 5})");
  const Json found = serve::run_differences(first, second);
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(found[0], Json::parse(R"({"path": "b.c[2]", "first": 2, "second": 4, "relative": 0.5})"));
  EXPECT_EQ(found[1], Json::parse(R"({"path": "b.d", "first": "x", "second": "y"})"));
  EXPECT_EQ(found[2], Json::parse(R"({"path": "e", "first": 4, "second": null})"));
  EXPECT_EQ(found[3], Json::parse(R"({"path": "f", "first": null, "second": 5})"));
}

}  // namespace
}  // namespace keyblock::guard_test
