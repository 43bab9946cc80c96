#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "abflat/version.h"
#include "reports/verify_reports.h"
#include "terminal/markup.h"
#include "terminal/terminal.h"

namespace abflat::cli {
namespace {

/// All of them, in their order.
std::vector<VerifyRule> allRules() {
  std::vector<VerifyRule> out(kVerifyRuleCount);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<VerifyRule>(i);
  return out;
}

/// XML has no other control characters.
std::string inXml(std::string text) {
  text.erase(std::remove_if(text.begin(), text.end(),
                            [](unsigned char c) { return c < 0x20 && c != '\n'; }),
             text.end());
  return escapedMarkup(text);
}

/// As XML and JSON need it: what is no UTF-8 becomes U+FFFD.
std::string asUtf8(const std::string& text) {
  using nlohmann::json;
  const std::string quoted = json(text).dump(-1, ' ', false, json::error_handler_t::replace);
  return json::parse(quoted, nullptr, false).get<std::string>();
}

}  // namespace

std::string verifyJunit(const VerifyReport& report, const std::string& inputName) {
  std::map<VerifyRule, std::vector<const VerifyFinding*>> found;
  for (const VerifyFinding& each : report.findings) found[each.rule].push_back(&each);
  const std::vector<VerifyRule> rules = allRules();
  const std::string name = inXml(asUtf8(inputName));
  const std::string counts = "tests=\"" + std::to_string(rules.size()) + "\" failures=\"" +
                             std::to_string(found.size()) + "\" time=\"" +
                             std::to_string(report.timings.total) + "\"";
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites " + counts +
                    ">\n  <testsuite name=\"" + name + "\" " + counts + ">\n";
  for (const VerifyRule rule : rules) {
    out += "    <testcase classname=\"" + name + "\" name=\"" + nameOf(rule) + "\"";
    const auto at = found.find(rule);
    if (at == found.end()) {
      out += "/>\n";
      continue;
    }
    out += ">\n      <failure message=\"" + inXml(asUtf8(at->second.front()->message)) + "\">";
    for (const VerifyFinding* each : at->second) out += inXml(asUtf8(each->message)) + "\n";
    out += "</failure>\n    </testcase>\n";
  }
  return out + "  </testsuite>\n</testsuites>\n";
}

std::string verifySarif(const VerifyReport& report, const std::string& inputName) {
  using nlohmann::ordered_json;
  ordered_json rules = ordered_json::array(), results = ordered_json::array();
  for (const VerifyRule rule : allRules())
    rules.push_back(
        {{"id", nameOf(rule)}, {"shortDescription", {{"text", sentence(textOf(rule))}}}});
  for (const VerifyFinding& found : report.findings)
    results.push_back(
        {{"ruleId", nameOf(found.rule)},
         {"level", "error"},
         {"message", {{"text", sentence(found.message)}}},
         {"locations", {{{"physicalLocation", {{"artifactLocation", {{"uri", inputName}}}}}}}},
         {"properties", {{"faces", found.faces}, {"islands", found.islands}}}});
  const ordered_json driver = {{"name", "abflat"}, {"version", ABFLAT_VERSION}, {"rules", rules}};
  const ordered_json log = {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                            {"version", "2.1.0"},
                            {"runs", {{{"tool", {{"driver", driver}}}, {"results", results}}}}};
  return log.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace abflat::cli
