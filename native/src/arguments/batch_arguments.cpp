#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "arguments/options.h"
#include "arguments/subcommands.h"
#include "files/file_format.h"
#include "files/paths.h"

namespace abflat::cli {
namespace {

/// Options that name a file or a place: with many meshes, batch chooses these.
constexpr std::array kChosenByBatch = {"--output",      "--report",   "--layout", "--heat-map",
                                       "--scale",       "--junit",    "--sarif",  "--picture",
                                       "--write-seams", "--moved-to", "--quiet",  "--help"};

bool isChosenByBatch(const std::string& flag) {
  return std::find(kChosenByBatch.begin(), kChosenByBatch.end(), flag) != kChosenByBatch.end();
}

/// Calls `use` with every option of a command, that is not the mesh; with none if batch cannot run
/// it.
void forOptions(const std::string& command, const std::function<void(const CLI::Option&)>& use) {
  CLI::App app;
  UnwrapCommand unwrap;
  FlattenCommand flatten;
  PackCommand pack;
  BakeCommand bake;
  VerifyCommand verify;
  addUnwrap(app, unwrap);
  addFlatten(app, flatten);
  addPack(app, pack);
  addBake(app, bake);
  addVerify(app, verify);
  for (const CLI::App* named : app.get_subcommands([](const CLI::App*) { return true; }))
    if (named->get_name() == command)
      for (const CLI::Option* option : named->get_options())
        if (!option->get_positional()) use(*option);
}

bool hasFlag(const CLI::App& app, const std::string& flag) {
  return app.get_option_no_throw(flag) != nullptr;
}

/// Takes the options of the command that is run, to be checked by its own parser later.
void addPassedOptions(CLI::App& app, BatchCommand& c, const std::string& run) {
  for (const OptionOfCommand& option : optionsOfCommand(run)) {
    const auto take = [&c, option](const std::string& value) {
      c.options.push_back({option.flag, option.hasValue ? std::optional(value) : std::nullopt});
    };
    if (option.hasValue)
      app.add_option_function<std::string>(option.flag, take)->group("");
    else
      app.add_flag_callback(option.flag, [take] { take({}); })->group("");
  }
}

/// Says what batch does instead of options that name one file.
void addRefusedOptions(CLI::App& app) {
  const auto refuseIt = [](const char* flag) {
    return [flag](const std::string&) {
      throw CLI::ValidationError(flag, "batch names the files of each mesh itself. Leave it out");
    };
  };
  for (const char* flag : kChosenByBatch)
    if (!hasFlag(app, flag))
      app.add_option_function<std::string>(std::string(flag) == "--output" ? "-o,--output" : flag,
                                           refuseIt(flag))
          ->group("");
}

/// "i/n", counted from 0.
void setShard(const std::string& text, BatchCommand& c) {
  const std::size_t slash = text.find('/');
  double index = 0, count = 0;
  constexpr double kMost = 1e6;
  const bool isPair = slash != std::string::npos && readNumber(text.substr(0, slash), index) &&
                      readNumber(text.substr(slash + 1), count);
  const bool isWhole = isPair && index == std::floor(index) && count == std::floor(count);
  if (!isWhole || !(index >= 0 && index < count && count <= kMost))
    throw CLI::ValidationError("--shard", "'" + text +
                                              "' is not a part and the number of parts, such as "
                                              "0/4, 1/4, 2/4 and 3/4");
  c.shard = static_cast<std::size_t>(index);
  c.shards = static_cast<std::size_t>(count);
}

/// A number of MB, as with --memory of unwrap: "3000", "3G".
double megabytes(const char* flag, const std::string& text) {
  const UnwrapOptionValues values;
  const OptionInfos infos = optionInfos(values);
  int index = 0;
  while (infos[index].flag != std::string("--memory")) ++index;
  double value = 0;
  bool isWord = false;
  if (!readOption(values, index, text, value, isWord) || isWord || !(value > 0) ||
      !std::isfinite(value))
    throw CLI::ValidationError(flag,
                               "must be a number of MB above 0, such as 3000 or 3G, not " + text);
  return value;
}

void addMegabytes(CLI::App& app, const char* flag, double& value, const std::string& help) {
  app.add_option_function<std::string>(
         flag, [flag, &value](const std::string& text) { value = megabytes(flag, text); },
         wrapped(help))
      ->type_name("MB");
}

void setEnding(const std::string& text, BatchCommand& c) {
  c.ending = "." + text;
  if (!text.empty() && endingOf("x" + c.ending) == c.ending && isWritableName("x" + c.ending))
    return;
  throw CLI::ValidationError("--format", "'" + text +
                                             "' cannot be written. Use obj, ply, glb or "
                                             "gltf");
}

void setAtlas(const std::string& text, BatchCommand& c) {
  if (text != "file" && text != "folder")
    throw CLI::ValidationError("--atlas", "'" + text + "' is neither file nor folder");
  c.hasFolderAtlases = text == "folder";
}

void addPlaces(CLI::App& app, BatchCommand& c) {
  app.add_option("IN", c.inputs,
                 "files, folders with all that is in them, and patterns such as\n"
                 "'meshes/**/*.obj'; - reads a list from standard input")
      ->check(notEmpty())
      ->type_name("");
  app.add_option("--from", c.lists,
                 wrapped("file with a list of meshes: one path a line, or CSV or JSON Lines with "
                         "the path as 'input' and options of single meshes, named as on the "
                         "command line; - reads standard input"))
      ->check(notEmpty())
      ->allow_extra_args(false)
      ->type_name("LIST");
  app.add_option("--out", c.out,
                 wrapped("folder for all results; created if missing. Meshes keep their relative "
                         "paths in it"))
      ->required()
      ->check(notEmpty())
      ->type_name("DIR");
  app.add_option_function<std::string>(
         "--atlas", [&c](const std::string& text) { setAtlas(text, c); },
         wrapped(
             "which meshes share an atlas, at one texel density: file = none, folder = all that "
             "lie in the same folder; a list may name atlases, too, as 'atlas'"))
      ->default_str("file")
      ->type_name("WORD");
  app.add_option_function<std::string>(
         "--format", [&c](const std::string& text) { setEnding(text, c); },
         wrapped("how meshes are written: obj, ply, glb or gltf (default: as the input, or glb if "
                 "that cannot be written)"))
      ->type_name("WORD");
}

void addWork(CLI::App& app, BatchCommand& c) {
  app.add_option("--run", c.run,
                 wrapped("what to do with each mesh: unwrap, flatten, pack, bake or verify; all "
                         "options of that command that name no file to write can be given, too"))
      ->check(CLI::IsMember({"unwrap", "flatten", "pack", "bake", "verify"}))
      ->default_str(c.run)
      ->type_name("WORD");
  app.add_option_function<std::string>(
         "-j,--jobs",
         [&c](const std::string& text) {
           double jobs = 0;
           constexpr double kMost = 1024;
           if (!readNumber(text, jobs) || !(jobs >= 1 && jobs <= kMost) || jobs != std::floor(jobs))
             throw CLI::ValidationError("--jobs",
                                        "must be a whole number from 1 to 1024, not " + text);
           c.jobs = static_cast<std::size_t>(jobs);
         },
         wrapped("how many meshes to work on at once (default: one per processor)"))
      ->type_name("NUMBER");
  app.add_option("--time-limit", c.timeLimit, wrapped("most seconds for a mesh (default: none)"))
      ->check(numberCheck("above 0", [](double x) { return x > 0 && std::isfinite(x); }))
      ->type_name("SECONDS");
  addMegabytes(app, "--memory-limit", c.memoryLimit, "most memory for a mesh (default: none)");
  addMegabytes(
      app, "--total-memory", c.totalMemory,
      "most memory for all that run at once, as predicted (default: 80 % of what is free)");
  app.add_flag_callback(
      "--no-pictures", [&c] { c.pictures = false; },
      wrapped("draw no picture of each layout for the report"));
}

void addState(CLI::App& app, BatchCommand& c) {
  app.add_flag("--resume", c.resume,
               wrapped("go on where a run into this folder ended: skips what is done with the same "
                       "content, options and version"));
  app.add_option_function<std::string>(
         "--shard", [&c](const std::string& text) { setShard(text, c); },
         wrapped("work on part I of N only, counted from 0; the content of a file decides which "
                 "part it is in"))
      ->type_name("I/N");
  app.add_flag("--merge", c.merge,
               wrapped("work on nothing, but make one manifest and one report of those of all "
                       "parts in the folder"));
  app.add_flag("--dry-run", c.dryRun, wrapped("only print what would be done"));
}

}  // namespace

std::vector<OptionOfCommand> optionsOfCommand(const std::string& command) {
  std::vector<OptionOfCommand> out;
  forOptions(command, [&](const CLI::Option& option) {
    const std::string flag = "--" + option.get_lnames().front();
    if (!isChosenByBatch(flag)) out.push_back({flag, option.get_items_expected_max() > 0});
  });
  return out;
}

CLI::App* addBatch(CLI::App& app, BatchCommand& c, const std::string& run) {
  CLI::App* sub = app.add_subcommand(
      "batch", "Run unwrap, flatten, pack, bake or verify on many meshes, on all processors");
  sub->group("Commands");
  addPlaces(*sub, c);
  addWork(*sub, c);
  addState(*sub, c);
  addQuiet(*sub, c.quiet);
  setUsage(*sub, "abflat batch IN... --out DIR [--run COMMAND] [OPTIONS]");
  addPassedOptions(*sub, c, run);
  addRefusedOptions(*sub);
  sub->footer(
      "DIR/manifest.jsonl says what became of each mesh, DIR/report.html shows it. See 'abflat "
      "unwrap --help'\nfor options of unwrap, and so on.\n\n" +
      exitCodeHelp());
  return sub;
}

void checkTogether(const BatchCommand& c) {
  const bool hasInputs = !c.inputs.empty() || !c.lists.empty();
  if (c.merge && (hasInputs || c.resume || c.shards > 1 || !c.options.empty()))
    throw CLI::ValidationError("--merge", "takes nothing but --out");
  if (!c.merge && !hasInputs)
    throw CLI::ValidationError("IN", "no mesh is named. Name files, folders or a list");
  const auto readers = std::count(c.inputs.begin(), c.inputs.end(), kStandardStream) +
                       std::count(c.lists.begin(), c.lists.end(), kStandardStream);
  if (readers > 1) throw CLI::ValidationError("-", "standard input can be read only once");
  if (c.run == "verify" && !c.ending.empty())
    throw CLI::ValidationError("--format", "verify writes no meshes. Leave it out");
}

}  // namespace abflat::cli
