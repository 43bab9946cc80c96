#include "arguments/options.h"
#include "arguments/pictures.h"
#include "arguments/subcommands.h"
#include "files/paths.h"

namespace abflat::cli {

CLI::App* addVerify(CLI::App& app, VerifyCommand& c) {
  CLI::App* sub = app.add_subcommand(
      "verify", "Judge the layout of a file, whichever program wrote it, and say what is wrong");
  sub->group("Commands");
  addInput(*sub, c.input);
  sub->add_option(
         "--rules", c.rules,
         wrapped("JSON file with an object of these options, named as in the report: "
                 "{\"padding\": 8, \"maxStretch\": 1.1}; what is given on the command line "
                 "counts instead"))
      ->type_name("FILE")
      ->check(notEmpty());
  sub->add_option("--against", c.against,
                  wrapped("the mesh that the file was made from: faces, vertices, their order, and "
                          "all but the texcoords must be the same"))
      ->type_name("FILE")
      ->check(notEmpty());
  addOptions(*sub, c.options);
  addReadTexcoord(*sub, c.gltf.texcoord,
                  "glTF set with the layout to verify: TEXCOORD_0 to TEXCOORD_7");
  addAllowOutside(*sub, c.allowsOutside);
  addReport(*sub, c.report);
  const auto addFile = [&](const char* flag, std::string& path, const char* help) {
    sub->add_option(flag, path, wrapped(help))->type_name("FILE")->check(notEmpty());
  };
  addFile("--junit", c.junit, "write JUnit XML with a test for each rule to this file");
  addFile("--sarif", c.sarif, "write what was found as SARIF 2.1.0 to this file");
  sub->add_option("--picture", c.picture,
                  wrapped("PNG of the layout with its faults: overlapping faces vermilion, flipped "
                          "ones blue, those outside of their tile yellow, other islands purple; "
                          "rings around what is small"))
      ->type_name("FILE")
      ->check(notEmpty())
      ->check(pictureName({".png"}, ".png"));
  addQuiet(*sub, c.quiet);
  setUsage(*sub, "abflat verify IN [OPTIONS]");
  sub->footer(exitCodeHelp());
  return sub;
}

void noteGiven(const CLI::App& app, VerifyCommand& c) {
  const OptionInfos infos = optionInfos(c.options);
  for (int i = 0; i < infos.count; ++i)
    c.given.push_back(app.get_option(infos[i].flag)->count() > 0);
}

void checkTogether(const VerifyCommand& c) {
  const std::pair<const char*, const std::string&> written[] = {
      {"--report", c.report}, {"--junit", c.junit}, {"--sarif", c.sarif}, {"--picture", c.picture}};
  for (const auto& [option, path] : written) {
    if (path.empty()) continue;
    if (replaces(path, c.input)) refuse(option, "would replace the input");
    if (!c.rules.empty() && replaces(path, c.rules)) refuse(option, "would replace the rules");
    if (!c.against.empty() && replaces(path, c.against))
      refuse(option, "would replace the mesh to compare with");
    for (const auto& [other, otherPath] : written)
      if (option != other && !otherPath.empty() && isSameTarget(path, otherPath))
        refuse(option, std::string("is the same file as ") + other);
  }
}

}  // namespace abflat::cli
