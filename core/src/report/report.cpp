#include "abflat/bake.h"
#include "abflat/compare.h"
#include "abflat/flatten.h"
#include "abflat/inspect.h"
#include "abflat/pack_layout.h"
#include "abflat/unwrap.h"
#include "abflat/verify.h"
#include "abflat/version.h"
#include "report/field_writer.h"

namespace abflat {
namespace {

template <class Report>
std::string jsonOf(const Report& report) {
  FieldWriter json;
  json.field("version", std::string(ABFLAT_VERSION));
  visitFields(report, json);
  return json.take();
}

}  // namespace

std::string reportJson(const Report& report) { return jsonOf(report); }

std::string unwrapReportJson(const UnwrapReport& report) { return jsonOf(report); }

std::string packReportJson(const PackReport& report) { return jsonOf(report); }

std::string bakeReportJson(const BakeReport& report) { return jsonOf(report); }

std::string verifyReportJson(const VerifyReport& report) { return jsonOf(report); }

std::string inspectJson(const MeshSummary& summary, const std::string& path) {
  FieldWriter json;
  json.field("path", path);
  visitFields(summary, json);
  return json.take();
}

std::string compareJson(const Comparison& comparison, const std::string& path) {
  FieldWriter json;
  json.field("version", std::string(ABFLAT_VERSION));
  json.begin("input");
  json.field("path", path);
  visitFields(comparison.input, json);
  json.end();
  json.field("methods", comparison.methods);
  return json.take();
}

}  // namespace abflat
