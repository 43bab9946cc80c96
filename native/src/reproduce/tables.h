#pragma once

#include "reproduce/experiment.h"
#include "reproduce/table.h"

namespace abflat::cli {

/// The paper's tables, with our numbers beside the printed ones.
struct PaperTables {
  Table table1;  ///< t = 1: faces, time, distortions
  Table table2;  ///< distortions for t = 2, 1.05, 1, 0.968
};
PaperTables emptyTables();

/// Adds the rows of one mesh; one that cannot be flattened gets a row that says why.
void addRows(PaperTables& tables, Experiment& experiment);

/// Both tables, with an explanation of their columns, as Markdown.
std::string tablesMarkdown(const PaperTables& tables);

/// What readers need to know about the columns, one sentence each.
std::vector<std::string> tableNotes();

}  // namespace abflat::cli
