#include "arguments/options.h"
#include "arguments/subcommands.h"
#include "files/paths.h"

namespace abflat::cli {

CLI::App* addFlatten(CLI::App& app, FlattenCommand& c) {
  CLI::App* sub = app.add_subcommand("flatten", "Flatten a mesh that is a disk as one chart");
  sub->group("Commands");
  addInput(*sub, c.input);
  addOutput(*sub, c.output);
  addMovedTo(*sub, c.movedTo);
  addOptions(*sub, c.options);
  sub->add_option(
         "--bounds", c.bounds,
         wrapped("text file with bounds for single boundary vertices, which replace t there: "
                 "one 'VERTEX T' per line, numbered from 0; - reads standard input"))
      ->check(notEmpty())
      ->type_name("FILE");
  sub->add_option(
         "--straight", c.straight,
         wrapped("text file with parts of the boundary to make straight: one 'FROM TO' per line, "
                 "two boundary vertices numbered from 0, with the surface on the left from FROM "
                 "to TO; - reads standard input"))
      ->check(notEmpty())
      ->type_name("FILE");
  addPins(*sub, c.pins, " (two or more)");
  addTexcoordSet(*sub, c.texcoord);
  addAllowOutside(*sub, c.allowsOutside);
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
  const std::vector<Source> sources = {
      {"IN", c.input}, {"--bounds", c.bounds}, {"--straight", c.straight}, {"--pins", c.pins}};
  const char* reader = nullptr;  // what reads standard input
  for (const auto& [option, path] : sources) {
    const std::string loss = std::string("would replace the file of ") + option;
    if (&path != &c.input && replaces(c.report, path)) refuse("--report", loss);
    if (&path != &c.input && replaces(c.output, path)) refuse("--output", loss);
    if (path != kStandardStream) continue;
    if (reader != nullptr)
      throw CLI::ValidationError(
          option,
          std::string("standard input is ") +
              (c.input == kStandardStream ? "the mesh" : std::string("the file of ") + reader) +
              " already. Name a file");
    reader = option;
  }
}

}  // namespace abflat::cli
