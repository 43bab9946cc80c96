#include <iomanip>
#include <sstream>

#include "abflat/flatten.h"
#include "commands/commands.h"
#include "files/input_file.h"
#include "files/out_of_memory.h"
#include "files/output_file.h"
#include "files/paths.h"
#include "terminal/terminal.h"

namespace abflat::cli {
namespace {

/// The result for one t and balance: a report, or the status that says why there is none.
struct Row {
  double t, balance;
  Result<FlattenResult> result;
};

std::string numberText(double x) {
  std::ostringstream out;
  out << x;
  return out.str();
}

std::string boundText(double t) { return t == kAutoT ? "auto" : numberText(t); }

/// A cell of a CSV file; quoted, since sentences may contain commas.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

std::string csvText(const std::vector<Row>& rows) {
  std::ostringstream out;
  out << std::setprecision(10);
  out << "t,balance,used t,solver,steps,angular distortion,length distortion,symmetric "
         "Dirichlet,crossings,flipped,valid,seconds,problem\n";
  for (const Row& row : rows) {
    out << boundText(row.t) << ',' << row.balance << ',';
    if (!row.result.ok()) {
      out << ",,,,,,,,false,," << quoted(row.result.status().message) << '\n';
      continue;
    }
    const ChartReport& c = row.result.value().report.charts.front();
    const Timings& s = row.result.value().report.timings;
    out << c.t << ',' << nameOf(c.solver) << ',' << c.iterations << ',' << c.angularDistortion
        << ',' << c.lengthDistortion << ',' << c.symmetricDirichlet << ',' << c.boundaryCrossings
        << ',' << c.flippedTriangles << ',' << (c.valid ? "true" : "false") << ','
        << s.connectivity + s.solve + s.layout + s.refine + s.check << ',' << quoted(c.problem)
        << '\n';
  }
  return out.str();
}

std::string sweepTable(const std::vector<Row>& rows) {
  std::ostringstream out;
  out << std::setw(8) << "t" << std::setw(9) << "balance" << std::setw(8) << "used" << std::setw(7)
      << "steps" << std::setw(12) << "angular" << std::setw(12) << "length" << std::setw(12)
      << "stretch" << std::setw(11) << "crossings" << std::setw(9) << "flipped" << std::setw(9)
      << "seconds"
      << "  result\n";
  for (const Row& row : rows) {
    out << std::setw(8) << boundText(row.t) << std::setw(9) << numberText(row.balance);
    if (!row.result.ok()) {
      out << std::setw(80) << ""
          << "  " << row.result.status().message << '\n';
      continue;
    }
    const ChartReport& c = row.result.value().report.charts.front();
    const Timings& s = row.result.value().report.timings;
    out << std::setw(8) << boundText(c.t) << std::setw(7) << c.iterations << std::fixed
        << std::setprecision(5) << std::setw(12) << c.angularDistortion << std::setprecision(4)
        << std::setw(12) << c.lengthDistortion << std::setw(12) << c.symmetricDirichlet
        << std::setw(11) << c.boundaryCrossings << std::setw(9) << c.flippedTriangles
        << std::setprecision(2) << std::setw(9)
        << s.connectivity + s.solve + s.layout + s.refine + s.check << std::defaultfloat << "  "
        << (c.valid ? "valid" : c.problem) << '\n';
  }
  return out.str();
}

}  // namespace

int runSweep(const SweepCommand& command) {
  const std::string name = inputName(command.input);
  const auto ended = [](const Status& status) {
    complain(status.message);
    return exitCodeOf(status.code);
  };
  OutputFile out(command.csv.empty() ? kStandardStream : command.csv);
  if (const Status s = out.check(); !s.ok()) return ended(s);
  const Result<InputFile> input = readInput(command.input, {Repeated::Join, command.allowsOutside});
  if (!input.ok()) return ended(input.status());
  std::vector<Row> rows;
  for (const double t : command.t) {
    for (const double balance : command.balance) {
      FlattenOptions options;
      options.t = t;
      options.balance = balance;
      const auto run = [&] { return flatten(input.value().mesh, options); };
      rows.push_back({t, balance, orOutOfMemory(name, run)});
      const Status& status = rows.back().result.status();
      // An error that neither t nor balance can change ends the sweep.
      if (!status.ok() && status.code != StatusCode::InfeasibleBound)
        return ended({status.code, name + ": " + status.message});
    }
  }
  const Status written = out.writeNow(command.csv.empty() ? sweepTable(rows) : csvText(rows));
  return written.ok() ? static_cast<int>(ExitCode::Valid) : ended(written);
}

}  // namespace abflat::cli
