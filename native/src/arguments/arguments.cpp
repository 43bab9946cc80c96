#include "arguments/arguments.h"

#include <iostream>

#include "abflat/generated/status_code.h"
#include "abflat/version.h"
#include "arguments/options.h"
#include "arguments/subcommands.h"
#include "terminal/terminal.h"

namespace abflat::cli {
namespace {

/// The first word that looks like an option but is not one.
std::string unknownOption(const CLI::App& command) {
  for (const std::string& word : command.remaining())
    if (word.size() > 1 && word[0] == '-') return word;
  return {};
}

std::string usageError(const CLI::App& app, const CLI::Error& error) {
  const auto named = app.get_subcommands();
  std::string what = error.what();
  if (named.empty() && !app.remaining().empty())
    what =
        "there is no command '" + app.remaining().front() +
        "'. Use unwrap, flatten, pack, bake, verify, inspect, sample, sweep, compare or reproduce";
  else if (named.empty())
    what =
        "no command given. Use unwrap, flatten, pack, bake, verify, inspect, sample, sweep, "
        "compare or reproduce";
  else if (const std::string option = unknownOption(*named.front()); !option.empty())
    what = "there is no option '" + option + "'. If that is a file, write ./" + option;
  else if (error.get_name() == "ArgumentMismatch")
    what = what.substr(0, what.find(':')) + " takes exactly one value";
  const std::string command = named.empty() ? "" : " " + named.front()->get_name();
  return "abflat: " + sentence(what) + "\nRun 'abflat" + command + " --help' for usage.\n";
}

}  // namespace

Command parseArguments(int argc, const char* const* argv) {
  CLI::App app("Unwraps 3D meshes: cuts them into charts and flattens these by their angles.",
               "abflat");
  app.set_version_flag("--version", "abflat " ABFLAT_VERSION, "print the version");
  app.require_subcommand(1);
  setUsage(app, "abflat COMMAND ...");
  app.footer(
      "Run 'abflat COMMAND --help' for the options of a command.\n\n"
      "Examples:\n"
      "  abflat unwrap character.obj -o character-uv.obj\n"
      "  abflat flatten head.obj -o head-uv.obj\n"
      "  abflat flatten head.obj -o head-uv.obj --t 2 --report head.json\n"
      "  abflat pack robot.glb -o robot-packed.glb\n"
      "  abflat bake robot.glb -o robot-baked.glb --texcoord 1\n"
      "  abflat verify robot.glb --padding 8 --resolution 2048\n"
      "  abflat inspect head.obj\n"
      "  abflat sample head -o head.obj\n\n" +
      exitCodeHelp());
  UnwrapCommand unwrap;
  FlattenCommand flatten;
  PackCommand pack;
  BakeCommand bake;
  VerifyCommand verify;
  InspectCommand inspect;
  SampleCommand sample;
  SweepCommand sweep;
  CompareCommand compare;
  ReproduceCommand reproduce;
  const CLI::App* unwrapApp = addUnwrap(app, unwrap);
  const CLI::App* flattenApp = addFlatten(app, flatten);
  const CLI::App* packApp = addPack(app, pack);
  const CLI::App* bakeApp = addBake(app, bake);
  const CLI::App* verifyApp = addVerify(app, verify);
  const CLI::App* inspectApp = addInspect(app, inspect);
  const CLI::App* sampleApp = addSample(app, sample);
  const CLI::App* sweepApp = addSweep(app, sweep);
  const CLI::App* compareApp = addCompare(app, compare);
  const CLI::App* reproduceApp = addReproduce(app, reproduce);
  try {
    app.parse(argc, argv);
    if (unwrapApp->parsed()) checkTogether(unwrap);
    if (flattenApp->parsed()) checkTogether(flatten);
    if (packApp->parsed()) checkTogether(pack);
    if (bakeApp->parsed()) checkTogether(bake);
    if (verifyApp->parsed()) {
      checkTogether(verify);
      noteGiven(*verifyApp, verify);
    }
    if (sweepApp->parsed()) checkTogether(sweep);
    if (compareApp->parsed()) checkTogether(compare);
  } catch (const CLI::Success& request) {
    const int code = app.exit(request);
    return Finished{std::cout.flush() ? code : static_cast<int>(ExitCode::CannotWrite)};
  } catch (const CLI::ParseError& error) {
    std::cerr << usageError(app, error);
    return Finished{static_cast<int>(ExitCode::Usage)};
  }
  if (unwrapApp->parsed()) return unwrap;
  if (flattenApp->parsed()) return flatten;
  if (packApp->parsed()) return pack;
  if (bakeApp->parsed()) return bake;
  if (verifyApp->parsed()) return verify;
  if (inspectApp->parsed()) return inspect;
  if (sampleApp->parsed()) return sample;
  if (sweepApp->parsed()) return sweep;
  if (compareApp->parsed()) return compare;
  if (reproduceApp->parsed()) return reproduce;
  return Finished{static_cast<int>(ExitCode::Usage)};
}

}  // namespace abflat::cli
