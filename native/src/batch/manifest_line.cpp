#include "batch/manifest_line.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace abflat::cli {
namespace {

using LineJson = nlohmann::ordered_json;

constexpr std::array kStatusWords = {"done",           "notValid",    "usage",       "unreadable",
                                     "notFlattenable", "cannotWrite", "outOfMemory", "timeLimit",
                                     "memoryLimit",    "crashed"};

std::optional<MeshStatus> statusOfWord(const std::string& word) {
  for (std::size_t i = 0; i < kStatusWords.size(); ++i)
    if (word == kStatusWords[i]) return static_cast<MeshStatus>(i);
  return {};
}

std::string textAt(const LineJson& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

double numberAt(const LineJson& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? found->get<double>() : 0;
}

LineJson orNull(const std::string& text) { return text.empty() ? LineJson() : LineJson(text); }

/// Measured values need no more digits.
double rounded(double x) {
  constexpr double kSteps = 1000;
  return std::round(x * kSteps) / kSteps;
}

}  // namespace

const char* wordFor(MeshStatus status) { return kStatusWords[static_cast<std::size_t>(status)]; }

std::string manifestText(const ManifestLine& line) {
  LineJson files = LineJson::array();
  for (const WrittenFile& file : line.files)
    files.push_back(LineJson{{"path", file.path}, {"hash", file.hash}});
  LineJson out;
  out["name"] = line.name;
  out["isAtlas"] = line.isAtlas;
  out["inputs"] = line.inputs;
  out["status"] = wordFor(line.status);
  out["message"] = line.message;
  out["inputHash"] = line.inputHash;
  out["optionsHash"] = line.optionsHash;
  out["version"] = line.version;
  out["files"] = std::move(files);
  out["layout"] = orNull(line.layout);
  out["summary"] =
      line.summary.empty() ? LineJson() : LineJson::parse(line.summary, nullptr, false);
  out["limit"] = line.limit > 0 ? LineJson(line.limit) : LineJson();
  out["seconds"] = rounded(line.seconds);
  out["peakMemory"] = rounded(line.peakMemory);
  // Messages may quote a file that is not UTF-8.
  return out.dump(-1, ' ', false, LineJson::error_handler_t::replace) + "\n";
}

std::optional<ManifestLine> parseManifestLine(const std::string& text) {
  const LineJson json = LineJson::parse(text, nullptr, false);
  if (!json.is_object()) return {};
  const std::optional<MeshStatus> status = statusOfWord(textAt(json, "status"));
  ManifestLine out;
  out.name = textAt(json, "name");
  out.isAtlas = json.contains("isAtlas") && json["isAtlas"] == true;
  if (json.contains("inputs") && json["inputs"].is_array())
    for (const LineJson& input : json["inputs"])
      if (input.is_string()) out.inputs.push_back(input.get<std::string>());
  if (!status || out.name.empty() || out.inputs.empty()) return {};
  out.status = *status;
  out.message = textAt(json, "message");
  out.inputHash = textAt(json, "inputHash");
  out.optionsHash = textAt(json, "optionsHash");
  out.version = textAt(json, "version");
  out.layout = textAt(json, "layout");
  if (json.contains("files") && json["files"].is_array())
    for (const LineJson& file : json["files"])
      out.files.push_back({textAt(file, "path"), textAt(file, "hash")});
  if (json.contains("summary") && json["summary"].is_object()) out.summary = json["summary"].dump();
  out.limit = numberAt(json, "limit");
  out.seconds = numberAt(json, "seconds");
  out.peakMemory = numberAt(json, "peakMemory");
  return out;
}

}  // namespace abflat::cli
