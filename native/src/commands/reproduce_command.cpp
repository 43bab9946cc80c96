#include <algorithm>
#include <cstdio>

#include "commands/commands.h"
#include "reproduce/convergence.h"
#include "reproduce/experiment.h"
#include "reproduce/figures.h"
#include "reproduce/output_folder.h"
#include "reproduce/page.h"
#include "reproduce/tables.h"
#include "terminal/terminal.h"

namespace abflat::cli {
namespace {

/// The results so far, mesh by mesh; pictures are written as soon as they are made.
class Reproduction {
 public:
  explicit Reproduction(const ReproduceCommand& command)
      : command_(command), folder_(command.out) {}

  Status run() {
    const Result<std::vector<Model>> models = findModels(command_.meshes);
    if (!models.ok()) return models.status();
    if (Status s = folder_.prepare(); !s.ok()) return s;
    for (std::size_t i = 0; i < models.value().size(); ++i) {
      Experiment experiment(models.value()[i]);
      if (!command_.quiet) announce(experiment, i + 1, models.value().size());
      if (Status s = add(experiment); !s.ok()) return s;
    }
    return writeSummaries();
  }

 private:
  static void announce(const Experiment& e, std::size_t number, std::size_t count) {
    const std::string& problem = e.status().message;
    std::fprintf(stderr, "[%zu/%zu] %s: %s\n", number, count, printable(e.model().name).c_str(),
                 e.status().ok() ? (std::to_string(e.summary().triangles) + " faces").c_str()
                                 : printable(problem).c_str());
  }

  Status add(Experiment& e) {
    if (command_.wantsTables) addRows(tables_, e);
    if (!e.status().ok()) page_.remarks.push_back(e.model().name + ": " + e.status().message);
    if (command_.wantsConvergence) {
      const std::string plot = addConvergence(convergence_, e, command_.options.precondition);
      const std::string file = "convergence-" + e.model().fileStem + ".svg";
      if (Status s = addPicture("Convergence", file, e.model().name, plot); !s.ok()) return s;
    }
    if (!command_.wantsFigures) return {};
    const FigureSet set = makeFigures(e);
    page_.remarks.insert(page_.remarks.end(), set.remarks.begin(), set.remarks.end());
    for (const Figure& f : set.figures)
      if (Status s = addPicture(figureHeading(f.number), f.file, f.title, f.svg); !s.ok()) return s;
    return {};
  }

  Status addPicture(const std::string& section, const std::string& file, const std::string& title,
                    const std::string& svg) {
    if (svg.empty()) return {};
    page_.pictures.push_back({section, file, title});
    return folder_.write(file, svg);
  }

  Status writeSummaries() {
    if (command_.wantsTables) {
      page_.tables = &tables_;
      if (Status s = folder_.write("table1.csv", csvText(tables_.table1)); !s.ok()) return s;
      if (Status s = folder_.write("table2.csv", csvText(tables_.table2)); !s.ok()) return s;
      if (Status s = folder_.write("tables.md", tablesMarkdown(tables_)); !s.ok()) return s;
    }
    if (command_.wantsConvergence)
      if (Status s = folder_.write("convergence.csv", csvText(convergence_)); !s.ok()) return s;
    std::stable_sort(
        page_.pictures.begin(), page_.pictures.end(),
        [](const PagePicture& a, const PagePicture& b) { return a.section < b.section; });
    return folder_.write("index.html", pageHtml(page_));
  }

  const ReproduceCommand& command_;
  OutputFolder folder_;
  PaperTables tables_ = emptyTables();
  Table convergence_ = emptyConvergence();
  PageContent page_;
};

}  // namespace

int runReproduce(const ReproduceCommand& command) {
  const Status status = Reproduction(command).run();
  if (!status.ok()) complain(status.message);
  return exitCodeOf(status.code);
}

}  // namespace abflat::cli
