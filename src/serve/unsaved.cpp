// Writes each text into a draft and runs the program on it; see unsaved.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/unsaved.hpp"

#include <algorithm>

#include "base/bytes/file_bytes.hpp"
#include "base/bytes/sound_json.hpp"
#include "base/error.hpp"
#include "base/words/replace_all.hpp"
#include "formats/registry.hpp"
#include "job/files.hpp"
#include "serve/replies.hpp"
#include "serve/request_words.hpp"

namespace keyblock::serve {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Removes a draft at the end of a scope.
class Removed {
 public:
  explicit Removed(fs::path file) : file_(std::move(file)) {}
  Removed(const Removed&) = delete;
  Removed& operator=(const Removed&) = delete;
  ~Removed() {
    std::error_code error;
    fs::remove(file_, error);
  }

 private:
  fs::path file_;
};

Json point_json(Point p) {
  return Json::array({p.x, p.y});
}

Json loop_json(const std::vector<Point>& loop) {
  Json json = Json::array();
  for (const Point p : loop) json.push_back(point_json(p));
  return json;
}

template <class Points>
Json points_json(const Points& points) {
  Json json = Json::array();
  for (const auto& point : points) json.push_back(point_json(point.position));
  return json;
}

template <class Scene>
void add_points(Json& json, const Scene& scene) {
  json["fixed"] = points_json(scene.fixed_points);
  json["loading"] = points_json(scene.loading_points);
  json["measured"] = points_json(scene.measured_points);
}

Json scene_json(const formats::Content& content) {
  Json json{{"blocks", Json::array()}};
  if (content.blocks) {
    for (const BlockPolygon& block : content.blocks->blocks) {
      Json loops = Json::array({loop_json(points_of(block.outer))});
      for (const BlockLoop& hole : block.holes) loops.push_back(loop_json(points_of(hole)));
      json["blocks"].push_back({{"material", block.material + 1}, {"loops", loops}});
    }
    add_points(json, *content.blocks);
  } else if (content.cover) {
    for (const CoverElement& element : content.cover->elements) {
      const auto corners = content.cover->polygon(element);
      json["blocks"].push_back(
          {{"material", element.material + 1}, {"loops", Json::array({loop_json({corners.begin(), corners.end()})})}});
    }
    add_points(json, *content.cover);
  }
  return json;
}

}  // namespace

fs::path Unsaved::draft_of(const Json& body) const {
  const std::string path = text(body, "path"), bytes = text(body, "text");
  if (bytes.size() > kMostText) throw BadRequest("the text is too long");
  std::string ending = fs::path(path).extension().string();
  if (ending.size() < 2 || ending.size() > 10 || !is_plain_word(ending.substr(1))) ending = ".txt";
  const fs::path draft = drafts_.file(ending);
  write_file(draft, bytes, Overwrite::no);
  return draft;
}

Json Unsaved::blocks(const Json& body) const {
  const fs::path draft = draft_of(body), cut = drafts_.file(".blk");
  const Removed no_draft(draft), no_cut(cut);
  try {
    const formats::Content content = formats::read(formats::load_text(draft.string())).content;
    if (content.blocks || content.cover) return scene_json(content);
  } catch (const InputError& error) {
    std::string words = std::string(error.what());
    replace_all(words, draft.string(), text(body, "path"));
    return {{"errors", errors_in(words)}};
  }
  Answer answer = program_({"cut", draft.string(), "-o", cut.string()});
  std::error_code error;
  if (!fs::is_regular_file(cut, error)) {
    replace_all(answer.messages, draft.string(), text(body, "path"));
    return {{"errors", errors_in(answer.messages)}};
  }
  return scene_json(formats::read(formats::load_text(cut.string())).content);
}

Json Unsaved::joints(const Json& body) const {
  const auto spec = body.find("spec");
  if (spec == body.end() || !spec->is_object()) throw BadRequest("expected an object in \"spec\"");
  const fs::path draft = drafts_.file(".json"), drawn = drafts_.file(".json");
  const Removed no_draft(draft), no_drawn(drawn);
  write_file(draft, spec->dump(-1, ' ', false, Json::error_handler_t::replace), Overwrite::no);
  Answer answer = program_({"joints", draft.string(), "-o", drawn.string()});
  std::error_code error;
  if (!fs::is_regular_file(drawn, error)) {
    replace_all(answer.messages, draft.string(), "joints");
    return {{"errors", errors_in(answer.messages)}};
  }
  const Json scene = sound_json(file_bytes(drawn.string()));
  return scene.value("drawing", Json::object());
}

Answer Unsaved::check(const Json& body, const std::vector<std::string>& arguments) const {
  const fs::path draft = draft_of(body);
  const Removed no_draft(draft);
  std::vector<std::string> words{"check", draft.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  Answer answer = program_(words);
  const std::string path = Json(text(body, "path")).dump(-1, ' ', false, Json::error_handler_t::replace);
  replace_all(answer.output, draft.string(), path.substr(1, path.size() - 2));
  replace_all(answer.messages, draft.string(), text(body, "path"));
  return answer;
}

}  // namespace keyblock::serve
