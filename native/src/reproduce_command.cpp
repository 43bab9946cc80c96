#include <cstdio>

#include "commands.h"
#include "reproduce/experiment.h"
#include "reproduce/output_folder.h"
#include "reproduce/tables.h"
#include "terminal.h"

namespace abflat::cli {
namespace {

Status reproduce(const ReproduceCommand& command) {
  const OutputFolder folder(command.out);
  const Result<std::vector<Model>> models = findModels(command.meshes);
  if (!models.ok()) return models.status;
  if (Status s = folder.prepare(); !s.ok()) return s;
  PaperTables tables = emptyTables();
  for (const Model& model : models.value) {
    if (!command.quiet) std::fprintf(stderr, "%s\n", model.name.c_str());
    Experiment experiment(model);
    addRows(tables, experiment);
  }
  if (Status s = folder.write("table1.csv", csvText(tables.table1)); !s.ok()) return s;
  if (Status s = folder.write("table2.csv", csvText(tables.table2)); !s.ok()) return s;
  return folder.write("tables.md", tablesMarkdown(tables));
}

}  // namespace

int runReproduce(const ReproduceCommand& command) {
  const Status status = reproduce(command);
  if (!status.ok()) complain(status.message);
  return exitCodeOf(status.code);
}

}  // namespace abflat::cli
