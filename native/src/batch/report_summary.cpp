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

std::string firstFinding(const std::string& summary) {
  const SummaryJson json = SummaryJson::parse(summary, nullptr, false);
  const SummaryJson::json_pointer list("/findings"), first("/findings/0/message");
  if (!json.is_object() || !json.contains(first) || !json[first].is_string()) return {};
  const std::size_t others = json[list].size() - 1;
  return json[first].get<std::string>() +
         (others > 0 ? " (and " + std::to_string(others) + " more)" : "");
}

}  // namespace abflat::cli
