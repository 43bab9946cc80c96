#pragma once

#include <optional>
#include <string>
#include <utility>

#include "abflat/flatten.h"
#include "abflat/inspect.h"
#include "abflat/status.h"
#include "base/json_writer.h"

namespace abflat {

/// Counts are null when `error` says that the input is not known.
void writeInput(JsonWriter& json, const MeshSummary& in, const std::string& path, StatusCode error);
/// Null without pins.
void writePins(JsonWriter& json, const std::optional<PinReport>& pins);
/// Null where nothing is refined.
void writeRefined(JsonWriter& json, const std::optional<RefineReport>& refined);
/// Null where nothing is to be straight.
void writeStraight(JsonWriter& json, const std::optional<StraightReport>& straight);
void writeQuasiConformal(JsonWriter& json, double mean, double max);
/// Nothing where there is none.
void writeError(JsonWriter& json, const Status& error);

/// Of any set of options.
template <class Values>
void writeOptions(JsonWriter& json, const Values& options) {
  json.object("options");
  forEachOption(options, [&](const char* name, const auto& value) { json.field(name, value); });
  json.end();
}

}  // namespace abflat
