#include "reproduce/tables.h"

#include <iomanip>
#include <sstream>

#include "abflat/flatten.h"

namespace abflat::cli {
namespace {

constexpr double kTableT[] = {2, 1.05, 1, 0.968};

using Cells = std::vector<Cell>;

void append(Cells& row, const Cells& more) { row.insert(row.end(), more.begin(), more.end()); }

std::string shortNumber(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

/// The paper sums over the edges but seems to divide by 1.5 F, the number of edges of a mesh
/// without boundary: that reproduces the values of its "Body".
double lengthPerClosedEdge(const ChartReport& c) {
  const double edges =
      (3.0 * static_cast<double>(c.faces) + static_cast<double>(c.boundaryVertices)) / 2;
  return c.lengthDistortion * edges / (1.5 * static_cast<double>(c.faces));
}

/// Angular and length distortion, crossings, flipped, valid, problem.
Cells resultCells(const Result<FlattenResult>& result) {
  if (!result.ok()) return {"", "", "", "", "", "no", result.status().message};
  const ChartReport& c = result.value().report.charts.front();
  return {{c.angularDistortion, 5},
          {c.lengthDistortion, 4},
          {lengthPerClosedEdge(c), 4},
          c.boundaryCrossings,
          c.flippedTriangles,
          c.valid ? "yes" : "no",
          c.problem};
}

std::string paperNote(const Experiment& e) {
  const PaperModel* paper = e.model().paper;
  if (!paper) return "";
  if (e.model().path.empty()) return "generated look-alike, not the paper's mesh";
  if (std::to_string(e.summary().triangles) != paper->faces)
    return "not the same mesh: the paper's has " + std::string(paper->faces) + " faces";
  return "";
}

std::string joined(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + "; " + b;
}

Cells paperCells(const PaperModel* paper) {
  if (!paper) return {"", "", "", "", ""};
  return {std::string(paper->name), std::string(paper->faces), std::string(paper->seconds),
          std::string(paper->angular), std::string(paper->length)};
}

Cells firstRow(Experiment& e) {
  if (!e.status().ok()) {
    Cells row = {e.model().name, ""};
    append(row, {"", "", "", "", "", "", "no"});
    append(row, paperCells(nullptr));
    row.emplace_back(e.status().message);
    return row;
  }
  const Result<FlattenResult>& result = e.flattened(1);
  Cells row = {e.model().name, e.summary().triangles,
               result.ok() ? Cell(secondsOf(result.value().report), 3) : Cell()};
  Cells cells = resultCells(result);
  const std::string problem = cells.back().exact;
  cells.pop_back();
  append(row, cells);
  append(row, paperCells(e.model().paper));
  row.emplace_back(joined(problem, paperNote(e)));
  return row;
}

Cells secondRow(Experiment& e, double t) {
  Cells row = {e.model().name, e.summary().triangles, shortNumber(t)};
  const PaperModel* paper = e.model().paper;
  const PaperDistortion* printed = paper ? findDistortion(*paper, t) : nullptr;
  Cells cells = resultCells(e.flattened(t));
  const std::string problem = cells.back().exact;
  cells.pop_back();
  append(row, cells);
  row.emplace_back(printed ? std::string(printed->angular) : "");
  row.emplace_back(printed ? std::string(printed->length) : "");
  row.emplace_back(joined(problem, printed ? paperNote(e) : ""));
  return row;
}

const std::vector<Column>& resultColumns() {
  static const std::vector<Column> columns = {
      {"angular distortion"}, {"length distortion"}, {"length per 1.5 F"},
      {"crossings"},          {"flipped"},           {"valid", true}};
  return columns;
}

Table tableOf(const std::vector<Column>& first, const std::vector<Column>& last) {
  Table out{first, {}};
  out.columns.insert(out.columns.end(), resultColumns().begin(), resultColumns().end());
  out.columns.insert(out.columns.end(), last.begin(), last.end());
  return out;
}

}  // namespace

PaperTables emptyTables() {
  return {tableOf({{"mesh", true}, {"faces"}, {"seconds"}}, {{"paper model", true},
                                                             {"paper faces"},
                                                             {"paper seconds"},
                                                             {"paper angular"},
                                                             {"paper length"},
                                                             {"remark", true}}),
          tableOf({{"mesh", true}, {"faces"}, {"t"}},
                  {{"paper angular"}, {"paper length"}, {"remark", true}})};
}

void addRows(PaperTables& tables, Experiment& e) {
  tables.table1.rows.push_back(firstRow(e));
  if (!e.status().ok()) {
    tables.table2.rows.push_back(
        {e.model().name, "", "", "", "", "", "", "", "no", "", "", e.status().message});
    return;
  }
  for (const double t : kTableT) tables.table2.rows.push_back(secondRow(e, t));
}

std::vector<std::string> tableNotes() {
  const std::string length =
      "Length distortion: mean over edges of (sL/l - 1)², L in uv, l in 3D, s = Σl/ΣL. Per 1.5 F: "
      "the same sum divided by 1.5 times the number of faces, as the paper's values of its Body "
      "suggest.";
  const std::string counts =
      "Crossings: pairs of boundary edges that cross or touch; flipped: triangles that are not "
      "positively oriented; both by exact predicates.";
  return {"Angular distortion: mean over corners of ((x - α)/α)², x in uv, α in 3D.", length,
          counts,
          "Columns of the paper: " + std::string(kPaperSource) +
              "; its times are those of a 1.8 GHz Xeon, ours those of this machine.",
          "Models are matched by file name. A remark says where a mesh is not the paper's own."};
}

std::string tablesMarkdown(const PaperTables& tables) {
  std::string out = "# Table 1: convex boundary, t = 1\n\n" + markdownText(tables.table1) +
                    "\n# Table 2: distortion for several t\n\n" + markdownText(tables.table2) +
                    "\n";
  for (const std::string& note : tableNotes()) out += "* " + note + "\n";
  return out;
}

}  // namespace abflat::cli
