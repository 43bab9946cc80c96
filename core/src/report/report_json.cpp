#include "report/report_json.h"

namespace abflat {

void writeInput(JsonWriter& json, const MeshSummary& in, const std::string& path,
                StatusCode error) {
  const bool isKnown = exitCodeOf(error) != static_cast<int>(ExitCode::Unreadable) &&
                       error != StatusCode::OutOfMemory;
  const auto count = [&](const char* name, auto value) {
    if (isKnown)
      json.field(name, value);
    else
      json.null(name);
  };
  json.object("input");
  json.field("path", path);
  count("vertices", in.vertices);
  count("faces", in.faces);
  count("triangles", in.triangles);
  count("components", in.components);
  count("boundaryLoops", in.boundaryLoops);
  count("boundaryEdges", in.boundaryEdges);
  count("genus", in.genus);
  json.end();
}

void writePins(JsonWriter& json, const std::optional<PinReport>& pins) {
  if (!pins) return json.null("pins");
  json.object("pins");
  json.field("count", pins->count);
  json.field("deviation", pins->deviation);
  json.end();
}

void writeRefined(JsonWriter& json, const std::optional<RefineReport>& refined) {
  if (!refined) return json.null("refined");
  json.object("refined");
  json.field("energyBefore", refined->energyBefore);
  json.field("energy", refined->energy);
  json.field("steps", refined->steps);
  json.field("limit", refined->limit);
  json.end();
}

void writeStraight(JsonWriter& json, const std::optional<StraightReport>& straight) {
  if (!straight) return json.null("straight");
  json.object("straight");
  json.field("runs", straight->runs);
  json.field("vertices", straight->vertices);
  json.field("released", straight->released);
  json.field("deviation", straight->deviation);
  json.end();
}

void writeQuasiConformal(JsonWriter& json, double mean, double max) {
  json.object("quasiConformal");
  json.field("mean", mean);
  json.field("max", max);
  json.end();
}

void writeError(JsonWriter& json, const Status& error) {
  if (error.ok()) return;
  json.object("error");
  json.field("code", statusName(error.code));
  json.field("message", error.message);
  json.end();
}

}  // namespace abflat
