#include "../paths.h"
#include "options.h"
#include "subcommands.h"

namespace abflat::cli {

CLI::App* addFlatten(CLI::App& app, FlattenCommand& c) {
  CLI::App* sub = app.add_subcommand(
      "flatten", "Flatten a mesh that is a disk and write it with its uv layout");
  sub->group("Commands");
  addInput(*sub, c.input);
  addOutput(*sub, c.output);
  addOptions(*sub, c.options);
  sub->add_option(
         "--bounds", c.bounds,
         wrapped("text file with bounds for single boundary vertices, in place of the "
                 "common t: a line 'VERTEX T' each, vertices counted from 0; - for standard input"))
      ->check(notEmpty())
      ->type_name("FILE");
  addTexcoordSet(*sub, c.texcoord);
  addReport(*sub, c.report);
  addQuiet(*sub, c.quiet);
  sub->footer(exitCodeHelp());
  setUsage(*sub, "abflat flatten IN -o OUT [OPTIONS]");
  return sub;
}

void checkTogether(const FlattenCommand& c) {
  if (!c.report.empty() && isSameTarget(c.report, c.output))
    refuse("--report", "is the same file as --output");
  if (replaces(c.report, c.input)) refuse("--report", "would replace the input");
  if (replaces(c.report, c.bounds)) refuse("--report", "would replace the file of --bounds");
  if (replaces(c.output, c.bounds)) refuse("--output", "would replace the file of --bounds");
  if (c.input == kStandardStream && c.bounds == kStandardStream)
    throw CLI::ValidationError("--bounds", "standard input is the mesh already; name a file");
}

}  // namespace abflat::cli
