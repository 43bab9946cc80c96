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
  addPins(*sub, c.pins, "");
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
  struct Source {
    const char* option;
    const std::string& path;
  };
  for (const auto& [option, path] : {Source{"--bounds", c.bounds}, Source{"--pins", c.pins}}) {
    const std::string loss = std::string("would replace the file of ") + option;
    if (replaces(c.report, path)) refuse("--report", loss);
    if (replaces(c.output, path)) refuse("--output", loss);
    if (c.input == kStandardStream && path == kStandardStream)
      throw CLI::ValidationError(option, "standard input is the mesh already; name a file");
  }
  if (c.bounds == kStandardStream && c.pins == kStandardStream)
    throw CLI::ValidationError("--pins", "standard input has the bounds already; name a file");
}

}  // namespace abflat::cli
