#include "batch/report_summary.h"

#include <nlohmann/json.hpp>

namespace abflat::cli {
namespace {

using SummaryJson = nlohmann::ordered_json;

/// Copies a value of a report if it has that.
void copy(const SummaryJson& report, const char* place, SummaryJson& out, const char* key) {
  const SummaryJson::json_pointer at(place);
  if (report.contains(at) && report[at].is_primitive() && !report[at].is_null())
    out[key] = report[at];
}

/// Of verify: what was found, without the lists of faces.
SummaryJson shortFindings(const SummaryJson& findings) {
  SummaryJson out = SummaryJson::array();
  for (const SummaryJson& finding : findings) {
    SummaryJson& each = out.emplace_back(SummaryJson::object());
    copy(finding, "/rule", each, "rule");
    copy(finding, "/message", each, "message");
  }
  return out;
}

}  // namespace

std::string reportSummary(const std::string& report) {
  const SummaryJson json = SummaryJson::parse(report, nullptr, false);
  if (!json.is_object()) return {};
  SummaryJson out = SummaryJson::object();
  copy(json, "/valid", out, "valid");
  copy(json, "/input/faces", out, "faces");
  if (json.contains("charts") && json["charts"].is_array()) out["charts"] = json["charts"].size();
  copy(json, "/islands", out, "charts");
  copy(json, "/atlas/utilization", out, "utilization");
  copy(json, "/utilization", out, "utilization");
  copy(json, "/charts/0/symmetricDirichlet", out, "stretch");
  copy(json, "/symmetricDirichlet", out, "stretch");
  copy(json, "/atlas/texelDensity", out, "texelDensity");
  copy(json, "/texelDensity", out, "texelDensity");
  copy(json, "/seams/relativeLength", out, "seamLength");
  if (json.contains("findings") && json["findings"].is_array())
    out["findings"] = shortFindings(json["findings"]);
  return out.dump(-1, ' ', false, SummaryJson::error_handler_t::replace);
}

}  // namespace abflat::cli
