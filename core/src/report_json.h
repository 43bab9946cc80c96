#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "abflat/flatten.h"
#include "abflat/inspect.h"
#include "abflat/status.h"

namespace abflat {

using Json = nlohmann::ordered_json;

// Paths need not be UTF-8: what is not becomes U+FFFD.
inline std::string jsonText(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// Counts are null when `error` says that the input is not known.
inline Json inputJson(const MeshSummary& in, const std::string& path, StatusCode error) {
  const bool isKnown = exitCodeOf(error) != static_cast<int>(ExitCode::Unreadable) &&
                       error != StatusCode::OutOfMemory;
  const auto count = [&](auto value) { return isKnown ? Json(value) : Json(); };
  return {
      {"path", path},
      {"vertices", count(in.vertices)},
      {"faces", count(in.faces)},
      {"triangles", count(in.triangles)},
      {"components", count(in.components)},
      {"boundaryLoops", count(in.boundaryLoops)},
      {"boundaryEdges", count(in.boundaryEdges)},
      {"genus", count(in.genus)},
  };
}

/// Of any set of options.
template <class Values>
Json optionsJson(const Values& options) {
  Json out = Json::object();
  forEachOption(options, [&](const char* name, const auto& value) { out[name] = value; });
  return out;
}

/// Null without pins.
inline Json pinsJson(const std::optional<PinReport>& pins) {
  if (!pins) return {};
  return {{"count", pins->count}, {"deviation", pins->deviation}};
}

/// Null where nothing is refined.
inline Json refinedJson(const std::optional<RefineReport>& refined) {
  if (!refined) return {};
  return {{"energyBefore", refined->energyBefore},
          {"energy", refined->energy},
          {"steps", refined->steps},
          {"limit", refined->limit}};
}

/// Null where nothing is to be straight.
inline Json straightJson(const std::optional<StraightReport>& straight) {
  if (!straight) return {};
  return {{"runs", straight->runs},
          {"vertices", straight->vertices},
          {"released", straight->released},
          {"deviation", straight->deviation}};
}

inline Json errorJson(const Status& error) {
  return {{"code", statusName(error.code)}, {"message", error.message}};
}

}  // namespace abflat
