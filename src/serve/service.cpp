// Turns each request into files to read or commands to run; see service.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/service.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/bytes/file_bytes.hpp"
#include "base/bytes/sha256.hpp"
#include "base/bytes/sound_json.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"
#include "job/files.hpp"
#include "run/follow/stop_criterion.hpp"
#include "serve/pictures.hpp"
#include "serve/replies.hpp"
#include "serve/request_words.hpp"
#include "serve/start_page.hpp"
#include "serve/study/study_requests.hpp"
#include "serve/window_words.hpp"

namespace keyblock::serve {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Returns the criterion at which a run stops, if it has the form of one.
std::string criterion_in(const Json& body) {
  const std::string words = text(body, "stop_when");
  try {
    stop_criterion_of(words, {"m", "kg", "s"});  // any units: the program knows those of the case
  } catch (const std::invalid_argument& error) {
    throw BadRequest(fmt::format("criterion to stop at: {}", error.what()));
  }
  return words;
}

/// Returns the words of the command whose output is the reply; empty for other addresses.
std::vector<std::string> printing(std::string_view path) {
  if (path == "/api/schema") return {"formats", "--schema"};
  if (path == "/api/joint_schema") return {"formats", "--joint-schema"};
  if (path == "/api/materials") return {"formats", "--materials", "--json"};
  return {};
}

/// Returns the words of an error, with paths from the served folder on and without options of the command line.
std::string sentence_of(const std::exception& error, const ServedFolder& folder) {
  std::string words = error.what();
  const std::string root = folder.root().string() + "/";
  for (std::size_t at = words.find(root); at != std::string::npos; at = words.find(root)) words.erase(at, root.size());
  return window_words(words);
}

/// Returns what `work` returns, or the refusal that an error of it means.
template <class Work>
auto caught(const ServedFolder& folder, const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const BadRequest& error) {
    return refusal(400, error.what());
  } catch (const NotServed& error) {
    return refusal(404, error.what());
  } catch (const UsageError& error) {  // a file that may not be overwritten
    return refusal(409, sentence_of(error, folder));
  } catch (const InputError& error) {
    return refusal(422, sentence_of(error, folder));
  } catch (const std::exception& error) {
    return refusal(500, sentence_of(error, folder));
  }
}

}  // namespace

Service::Service(const ServedFolder& folder, const Drafts& drafts, Jobs& jobs, std::function<void()> wake)
    : folder_(folder),
      drafts_(drafts),
      jobs_(jobs),
      program_(folder.root(), drafts),
      copies_(folder, drafts),
      results_(folder, drafts, program_, copies_),
      live_(folder, std::move(wake)),
      unsaved_(drafts, program_) {}

Reply Service::answer(const Request& request) {
  Reply reply = caught(folder_, [&] {
    const Target target = target_of(request.target);
    if (request.method == "GET") return get(target);
    const Json body = sound_json(request.body);
    if (!body.is_object()) throw BadRequest("expected a JSON object");
    return post(target.path, body);
  });
  if (reply.later) reply.later = [this, later = std::move(reply.later)] { return caught(folder_, later); };
  return reply;
}

Reply Service::get(const Target& target) {
  const auto& [path, parameters] = target;
  if (path == "/api/list") return json_reply(folder_.list());
  if (path == "/api/read") return json_reply(read(parameters));
  if (path == "/api/drawing") return drawing(parameters);
  if (path == "/api/thumbnail") return thumbnail(parameters);
  if (path == "/api/picture") return results_.picture(parameters);
  if (path == "/api/record") return json_reply(results_.record(parameters));
  if (path == "/api/live") return live_.answer(parameters);
  if (path == "/api/compare") return json_reply(results_.compare(parameters));
  if (path == "/api/jobs") return json_reply({{"jobs", jobs_.list()}});
  if (const std::vector<std::string> words = printing(path); !words.empty()) return printed(words);
  if (path == "/page" || path == "/report") return results_.page(path, parameters);
  if (path == "/") return {200, "text/html; charset=utf-8", std::string(start_page()), page_headers()};
  return refusal(404, "there is no such address");
}

Reply Service::post(const std::string& path, const Json& body) {
  if (path == "/api/check") return json_reply(check(body));
  if (path == "/api/blocks") return json_reply(unsaved_.blocks(body));
  if (path == "/api/joints") return json_reply(unsaved_.joints(body));
  if (path == "/api/save") return json_reply(save(body));
  if (path == "/api/run") return json_reply(run(body));
  if (path == "/api/resume") return json_reply(resume(body));
  if (path == "/api/fos") return json_reply(fos(body));
  if (path == "/api/sweep") return json_reply(sweep(body));
  if (path == "/api/element") return json_reply(element_test(folder_, drafts_, program_, body));
  if (path == "/api/fit") return json_reply(fitted_curve(folder_, drafts_, program_, body));
  if (path == "/api/convert") return json_reply(convert(body));
  if (path == "/api/stop") return json_reply(stop(body));
  return refusal(404, "there is no such address");
}

Json Service::read(const Parameters& parameters) const {
  const fs::path file = folder_.whole(parameter(parameters, "path"));
  const std::string bytes = bytes_of(file, kMostText);
  const bool is_text = bytes.find('\0') == std::string::npos && valid_utf8(bytes) == bytes;
  Json json{{"path", folder_.name(file)}, {"is_text", is_text}, {"sha256", sha256(bytes)}};
  if (is_text) json["text"] = bytes;
  return json;
}

Reply Service::drawing(const Parameters& parameters) const {
  const std::string file = file_argument(folder_, parameter(parameters, "path"));
  const fs::path whole = folder_.whole(parameter(parameters, "path"));
  require_file(whole, kMostText);
  if (std::string blocks = blocks_picture_of(whole, parameters.contains("numbers")); !blocks.empty())
    return svg_reply(std::move(blocks));
  const fs::path svg = drafts_.file(".svg"), blocks = drafts_.file(".blk");
  std::vector<std::string> words{"cut", file, "-o", blocks.string(), "--svg", svg.string()};
  if (parameters.contains("numbers")) words.emplace_back("--numbers");
  const Answer answer = program_(words);
  std::error_code error;
  fs::remove(blocks, error);
  if (!fs::is_regular_file(svg, error)) return refusal(422, words_of(answer));
  Reply reply = svg_reply(file_bytes(svg.string()));
  fs::remove(svg, error);
  return reply;
}

Reply Service::thumbnail(const Parameters& parameters) const {
  const fs::path file = folder_.whole(parameter(parameters, "path"));
  require_file(file, kMostText);
  std::string svg = thumbnail_of(file);
  return svg.empty() ? refusal(404, "the file has no geometry of its own") : svg_reply(std::move(svg));
}

Reply Service::printed(const std::vector<std::string>& words) const {
  Answer answer = program_(words);
  return {200, "application/json", std::move(answer.output)};
}

std::vector<std::string> Service::case_arguments(const Json& body) const {
  std::vector<std::string> words;
  for (const std::string& path : texts(body, "paths")) words.push_back(file_argument(folder_, path));
  if (words.empty()) throw BadRequest("expected the files of a case in \"paths\"");
  for (const std::string& word : setting_arguments(folder_, body)) words.push_back(word);
  return words;
}

Json Service::check(const Json& body) const {
  const std::vector<std::string> last{"--json", "--trial", flag(body, "trial") ? "2" : "0"};
  std::vector<std::string> words = body.contains("text") ? setting_arguments(folder_, body) : case_arguments(body);
  words.insert(words.end(), last.begin(), last.end());
  if (!body.contains("text")) words.insert(words.begin(), "check");
  const Answer answer = body.contains("text") ? unsaved_.check(body, words) : program_(words);
  Json report = sound_json(answer.output);
  if (!report.is_object()) report = Json::object();
  report["exit_code"] = answer.exit_code;
  report["errors"] = errors_in(answer.messages);
  if (answer.ran_out_of_time) report["errors"].push_back({{"sentence", words_of(answer)}});
  add_levels(report);
  return report;
}

Json Service::save(const Json& body) {
  const fs::path file = folder_.whole(text(body, "path"));
  const std::string bytes = text(body, "text");
  const std::string known = body.contains("sha256") ? text(body, "sha256") : std::string();
  std::error_code error;
  const std::lock_guard lock(saving_);
  const bool replaces = fs::exists(file, error);
  if (replaces && !fs::is_regular_file(file, error)) throw BadRequest("this is no file");
  if (replaces && known.empty()) throw UsageError(fmt::format("{} exists already", folder_.name(file)));
  if (replaces && sha256(bytes_of(file, kMostText)) != known)
    throw UsageError("the file has changed since it was read");
  write_file(file, bytes, overwrite_if(replaces));
  return {{"path", folder_.name(file)}, {"sha256", sha256(bytes)}};
}

std::string Service::new_result(const Json& body) const {
  const std::string result = folder_.name(folder_.whole(text(body, "result")));
  std::error_code error;
  if (fs::exists(folder_.root() / result, error)) throw UsageError(fmt::format("{} exists already", result));
  return result;
}

Json Service::started(Order order) {
  return {{"id", jobs_.add(std::move(order))}};
}

Json Service::run(const Json& body) {
  const std::string result = new_result(body);
  std::vector<std::string> words{"run"};
  for (const std::string& word : case_arguments(body)) words.push_back(word);
  words.insert(words.end(), {"-o", as_argument(result)});
  for (const std::string& history : histories_in(body)) words.push_back("--history=" + history);
  if (body.contains("record_every"))
    words.insert(words.end(), {"--record-every", fmt::format("{}", whole_number(body, "record_every"))});
  if (body.contains("stop_when")) words.push_back("--stop-when=" + criterion_in(body));
  const bool has_both = flag(body, "both");
  if (has_both && (body.contains("profile") || body.contains("stop_when")))
    throw BadRequest("runs by both profiles have neither \"profile\" nor \"stop_when\"");
  if (has_both) words.emplace_back("--both");
  keep_inputs(body);
  return started({has_both ? "both" : "run", texts(body, "paths").front(), result, std::move(words)});
}

void Service::keep_inputs(const Json& body) const {
  for (const std::string& path : texts(body, "paths")) copies_.keep(folder_.whole(path));
}

Json Service::sweep(const Json& body) {
  const std::string result = new_result(body);
  std::vector<std::string> words{"sweep"};
  for (const std::string& word : case_arguments(body)) words.push_back(word);
  for (const std::string& word : sweep_arguments(folder_, body)) words.push_back(word);
  words.insert(words.end(), {"-o", as_argument(result)});
  return started({"sweep", texts(body, "paths").front(), result, std::move(words)});
}

Json Service::resume(const Json& body) {
  const std::string result = folder_.name(folder_.whole(text(body, "result")));
  std::error_code error;
  if (!fs::is_regular_file(folder_.root() / result / "checkpoint.h5", error))
    throw NotServed(fmt::format("{} has no checkpoint to resume from", result));
  return started({"resume", result, result, {"run", "--resume", as_argument(result)}});
}

Json Service::fos(const Json& body) {
  const std::string result = new_result(body);
  std::vector<std::string> words{"fos"};
  for (const std::string& word : case_arguments(body)) words.push_back(word);
  words.insert(words.end(), {"-o", as_argument(result), "--json"});
  require_one_of(body, "reduce", {"joints", "rock", "both"});
  if (body.contains("reduce")) words.push_back("--reduce=" + text(body, "reduce"));
  return started({"fos", texts(body, "paths").front(), result, std::move(words)});
}

Json Service::convert(const Json& body) const {
  const fs::path target = folder_.whole(text(body, "target"));
  std::error_code error;
  if (fs::exists(target, error)) throw UsageError(fmt::format("{} exists already", folder_.name(target)));
  std::vector<std::string> words{"convert"};
  for (const std::string& path : texts(body, "paths")) words.push_back(file_argument(folder_, path));
  words.insert(words.end(), {"-o", as_argument(folder_.name(target)), "--json"});
  if (body.contains("to")) {
    if (!is_plain_word(text(body, "to"))) throw BadRequest("expected the name of a format in \"to\"");
    words.push_back("--to=" + text(body, "to"));
  }
  const Answer answer = program_(words);
  if (answer.ran_out_of_time) remove_drafts(target.parent_path(), answer.process);
  const Json said = sound_json(valid_utf8(answer.output));
  Json files = Json::array(), changes = Json::array();
  if (said.is_object()) {
    for (const Json& file : said["outputs"]) files.push_back(folder_.name(folder_.root() / file.get<std::string>()));
    changes = said["not_written"];
    for (const Json& loss : said["losses"]) changes.push_back(loss["sentence"]);
  }
  return {{"files", files}, {"changes", changes}, {"exit_code", answer.exit_code}, {"messages", words_of(answer)}};
}

Json Service::stop(const Json& body) {
  if (!jobs_.stop(whole_number(body, "id"))) throw NotServed("there is no such job");
  return {{"jobs", jobs_.list()}};
}

}  // namespace keyblock::serve
