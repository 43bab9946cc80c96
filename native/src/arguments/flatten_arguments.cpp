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
  sub->add_option(
         "--straight", c.straight,
         wrapped("text file with parts of the boundary that are to be straight: a line 'FROM TO' "
                 "each, boundary vertices counted from 0, with the surface on the left on the way "
                 "from one to the other; - for standard input"))
      ->check(notEmpty())
      ->type_name("FILE");
  addPins(*sub, c.pins, "");
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
  const char* reader = nullptr;  // of standard input
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
              " already; name a file");
    reader = option;
  }
}

}  // namespace abflat::cli
