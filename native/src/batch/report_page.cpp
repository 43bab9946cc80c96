#include "batch/report_page.h"

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string_view>

#include "abflat/version.h"
#include "batch/batch_progress.h"
#include "batch/report_style.h"
#include "terminal/markup.h"

namespace abflat::cli {
namespace {

namespace fs = std::filesystem;

/// A column of numbers.
struct NumberColumn {
  const char* title;
  int digits;
  double factor;
  std::optional<double> (*value)(const ManifestLine& line, const nlohmann::json& summary);
};

std::optional<double> summaryNumber(const nlohmann::json& summary, const char* key) {
  const auto found = summary.find(key);
  if (found == summary.end() || !found->is_number()) return {};
  return found->get<double>();
}

constexpr double kPercent = 100;

constexpr NumberColumn kNumberColumns[] = {
    {"Faces", 0, 1,
     [](const ManifestLine&, const nlohmann::json& s) { return summaryNumber(s, "faces"); }},
    {"Charts", 0, 1,
     [](const ManifestLine&, const nlohmann::json& s) { return summaryNumber(s, "charts"); }},
    {"Used %", 1, kPercent,
     [](const ManifestLine&, const nlohmann::json& s) { return summaryNumber(s, "utilization"); }},
    {"Stretch", 3, 1,
     [](const ManifestLine&, const nlohmann::json& s) { return summaryNumber(s, "stretch"); }},
    {"Seconds", 2, 1,
     [](const ManifestLine& l, const nlohmann::json&) { return std::optional(l.seconds); }},
    {"Peak MB", 0, 1,
     [](const ManifestLine& l, const nlohmann::json&) { return std::optional(l.peakMemory); }},
};

std::string fixedText(double x, int digits) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(digits) << x;
  return out.str();
}

/// A path as an address: other characters than these are encoded, also those that would make it
/// begin with a scheme.
std::string addressOf(const std::string& path) {
  constexpr std::string_view kKept =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
  std::string out;
  for (const char c : path) {
    if (kKept.find(c) != std::string_view::npos) {
      out += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    out += '%';
    out += "0123456789ABCDEF"[byte >> 4];
    out += "0123456789ABCDEF"[byte & 15];
  }
  return out;
}

std::string linkTo(const std::string& path, const std::string& text) {
  return "<a href=\"" + addressOf(path) + "\">" + escapedMarkup(text) + "</a>";
}

/// The path of the mesh from the folder of results.
std::string pathFrom(const std::string& folder, const std::string& path) {
  std::error_code ignored;  // then it stays as it is
  const std::string out = fs::relative(path, folder, ignored).generic_string();
  return out.empty() ? path : out;
}

std::string pictureCell(const ManifestLine& line) {
  if (line.layout.empty()) return "<td class=\"picture\"></td>";
  const std::string address = addressOf(line.layout);
  return "<td class=\"picture\"><a href=\"" + address + "\"><img loading=\"lazy\" src=\"" +
         address + "\" alt=\"layout of " + escapedMarkup(line.name) + "\"></a></td>";
}

/// What an atlas is of: links to the results, or to the meshes if there are none.
std::string atlasCell(const ManifestLine& line, const std::string& out) {
  constexpr std::size_t kShown = 8;
  std::string links;
  const std::size_t count = line.files.empty() ? line.inputs.size() : line.files.size();
  for (std::size_t i = 0; i < std::min(count, kShown); ++i) {
    links += i > 0 ? ", " : "";
    links += line.files.empty() ? linkTo(pathFrom(out, line.inputs[i]), line.inputs[i])
                                : linkTo(line.files[i].path, line.files[i].path);
  }
  if (count > kShown) links += " and " + std::to_string(count - kShown) + " more";
  return "<td class=\"wide\">" + escapedMarkup(line.name) + "<span class=\"from\">" + links +
         "</span></td>";
}

std::string nameCell(const ManifestLine& line, const std::string& out) {
  if (line.isAtlas) return atlasCell(line, out);
  const std::string& from = line.inputs.front();
  const std::string input = linkTo(pathFrom(out, from), from);
  if (line.files.empty()) return "<td class=\"wide\">" + input + "</td>";
  const std::string& result = line.files.front().path;
  return "<td class=\"wide\">" + linkTo(result, result) + "<span class=\"from\">from " + input +
         "</span></td>";
}

/// What verify has found, or why a mesh has failed.
std::string reasonsIn(const ManifestLine& line, const nlohmann::json& summary) {
  std::string out;
  const auto add = [&](const std::string& text) {
    if (!text.empty()) out += "<span class=\"why\">" + escapedMarkup(text) + "</span>";
  };
  const auto found = summary.find("findings");
  if (found == summary.end() || !found->is_array() || found->empty()) {
    add(line.message);
    return out;
  }
  constexpr std::size_t kShown = 3;
  for (std::size_t i = 0; i < std::min(found->size(), kShown); ++i)
    if (const nlohmann::json& finding = (*found)[i]; finding.is_object())
      add(finding.value("rule", "") + ": " + finding.value("message", ""));
  if (found->size() > kShown) add("and " + std::to_string(found->size() - kShown) + " more");
  return out;
}

std::string statusCell(const ManifestLine& line, const nlohmann::json& summary) {
  return std::string("<td class=\"wide\"><span class=\"") + (line.isGood() ? "done" : "failed") +
         "\">" + wordFor(line.status) + "</span>" + reasonsIn(line, summary) + "</td>";
}

std::string numberCell(const NumberColumn& column, std::optional<double> value) {
  const std::string head = "<td class=\"number\" data-label=\"" + std::string(column.title) + "\" ";
  if (!value) return head + "data-value=\"\"></td>";
  std::ostringstream exact;
  exact << *value;
  return head + "data-value=\"" + exact.str() + "\">" +
         fixedText(column.factor * *value, column.digits) + "</td>";
}

std::string rowOf(const ManifestLine& line, const std::string& out) {
  nlohmann::json summary = nlohmann::json::parse(line.summary, nullptr, false);
  if (!summary.is_object()) summary = nlohmann::json::object();
  std::string row = "<tr>" + pictureCell(line) + nameCell(line, out) + statusCell(line, summary);
  for (const NumberColumn& column : kNumberColumns)
    row += numberCell(column, column.value(line, summary));
  return row + "</tr>\n";
}

std::string headingsText() {
  const auto heading = [](const std::string& title, const char* kind) {
    return std::string("<th") + kind + "><button type=\"button\">" + title + "</button></th>";
  };
  std::string out =
      "<thead><tr><th class=\"picture\"></th>" + heading("Mesh", "") + heading("Status", "");
  for (const NumberColumn& column : kNumberColumns)
    out += heading(column.title, " class=\"number\"");
  return out + "</tr></thead>\n";
}

std::string totalsList(const ManifestLines& lines) {
  std::map<MeshStatus, std::size_t> counts;
  std::size_t meshes = 0;
  double seconds = 0, peak = 0;
  for (const auto& [name, line] : lines) {
    counts[line.status] += line.inputs.size();
    meshes += line.inputs.size();
    seconds += line.seconds;
    peak = std::max(peak, line.peakMemory);
  }
  const auto total = [](const std::string& word, const std::string& value) {
    return "<div><dt>" + word + "</dt><dd>" + value + "</dd></div>\n";
  };
  std::string out = "<dl>\n" + total("meshes", std::to_string(meshes));
  for (const auto& [status, count] : counts) out += total(wordFor(status), std::to_string(count));
  return out + total("time of all", durationText(seconds)) +
         total("highest peak", fixedText(peak, 0) + " MB") + "</dl>\n";
}

}  // namespace

std::string reportPage(const ManifestLines& lines, const std::string& out) {
  std::string page = kBatchPageHead;
  page += "<h1>" + escapedMarkup(fs::path(out).lexically_normal().string()) + "</h1>\n";
  page += "<p>Made by abflat batch " ABFLAT_VERSION
          " of <a href=\"manifest.jsonl\">manifest.jsonl</a></p>\n";
  const bool isBare = std::all_of(lines.begin(), lines.end(),
                                  [](const auto& line) { return line.second.layout.empty(); });
  page += totalsList(lines) + (isBare ? "<table class=\"bare\">\n" : "<table>\n") + headingsText() +
          "<tbody>\n";
  for (const auto& [name, line] : lines) page += rowOf(line, out);
  return page + "</tbody>\n</table>\n" + kBatchPageScript + "</body>\n</html>\n";
}

}  // namespace abflat::cli
