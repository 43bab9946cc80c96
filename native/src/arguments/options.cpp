#include "arguments/options.h"

#include <cmath>
#include <memory>
#include <sstream>

#include "abflat/generated/status_code.h"
#include "arguments/arguments.h"
#include "files/file_format.h"
#include "files/paths.h"

namespace abflat::cli {
namespace {

/// Shows required options in the usage line, and footers unchanged.
class HelpFormatter : public CLI::Formatter {
 public:
  explicit HelpFormatter(std::string usage) : usage_(std::move(usage)) {
    label("REQUIRED", "(required)");
    label("Positionals", "Arguments");
    column_width(29);
  }
  std::string make_usage(const CLI::App*, std::string) const override {
    return "Usage: " + usage_ + "\n";
  }
  std::string make_footer(const CLI::App* app) const override { return app->get_footer(); }

 private:
  std::string usage_;
};

/// A name that promises another format would mislead whoever reads the file next.
CLI::Validator resultName() {
  return CLI::Validator(
      [](const std::string& text) -> std::string {
        if (isWritableName(text)) return "";
        return "cannot write " + endingOf(text) + " files. Use " + kWrittenEndings;
      },
      "");
}

}  // namespace

std::string exitCodeHelp() {
  std::ostringstream out;
  out << "Exit codes:\n";
  for (int code = 0; code < kExitCodeCount; ++code)
    out << "  " << code << "  " << exitCodeText(static_cast<ExitCode>(code)) << "\n";
  return out.str();
}

std::string wrapped(const std::string& text) {
  constexpr std::size_t kWidth = 50;
  std::istringstream words(text);
  std::string out, word;
  for (std::size_t column = 0; words >> word; column += word.size() + 1) {
    const bool isFull = column > 0 && column + word.size() > kWidth;
    if (isFull) column = 0;
    out += (out.empty() ? "" : isFull ? "\n" : " ") + word;
  }
  return out;
}

void setUsage(CLI::App& app, const std::string& usage) {
  app.formatter(std::make_shared<HelpFormatter>(usage));
  app.set_help_flag("-h,--help", "print this help");
}

CLI::Validator numberCheck(const std::string& range, bool (*isValid)(double)) {
  return CLI::Validator(
      [=](const std::string& text) -> std::string {
        double value = 0;
        if (!readNumber(text, value)) return "'" + text + "' is not a number";
        return isValid(value) ? "" : "must be a number " + range + ", not " + text;
      },
      "");
}

CLI::Validator notEmpty() {
  return CLI::Validator(
      [](const std::string& text) -> std::string {
        return text.empty() ? "the name is empty" : "";
      },
      "");
}

void addInput(CLI::App& app, std::string& input) {
  app.add_option("IN", input,
                 std::string("mesh to read: ") + kFormatTitles + "; - reads standard input")
      ->required()
      ->check(notEmpty())
      ->type_name("");
}

void addOutput(CLI::App& app, std::string& output) {
  app.add_option("-o,--output", output,
                 wrapped(std::string("file to write: ") + kWrittenEndings + "; - writes " +
                         titleOf(kUnnamedFormat) + " to standard output"))
      ->required()
      ->check(notEmpty())
      ->check(resultName())
      ->type_name("OUT");
}

void addMovedTo(CLI::App& app, std::string& path) {
  app.add_option("--moved-to", path, "where OUT will lie: files that it names are named from there")
      ->check(notEmpty())
      ->group("");
}

void addPins(CLI::App& app, std::string& pins, const std::string& where) {
  app.add_option("--pins", pins,
                 wrapped("text file that pins vertices to uv" + where +
                         ": one 'VERTEX U V' per line, or 'VERTEX U V FACE' for a vertex on a "
                         "seam, numbered from 0; - reads standard input"))
      ->check(notEmpty())
      ->type_name("FILE");
}

std::size_t texcoordSet(const char* option, const std::string& text, const char* others) {
  constexpr double kLast = 7;
  double number = 0;
  if (!readNumber(text, number) || !(number >= 0 && number <= kLast) ||
      number != std::floor(number))
    throw CLI::ValidationError(option,
                               "'" + text + "' is not " + others + "a whole number from 0 to 7");
  return static_cast<std::size_t>(number);
}

void addTexcoordSet(CLI::App& app, std::optional<std::size_t>& set) {
  const auto take = [&set](const std::string& text) {
    set.reset();
    if (text != "auto") set = texcoordSet("--texcoord", text, "auto or ");
  };
  app.add_option_function<std::string>(
         "--texcoord", take,
         wrapped(
             "glTF set for the new texcoords: TEXCOORD_0 to TEXCOORD_7; other sets stay, so use "
             "1 for a lightmap beside the textures (auto = 0, or the first free set if a texture "
             "uses TEXCOORD_0)"))
      ->default_str("auto")
      ->type_name("NUMBER");
}

void addReadTexcoord(CLI::App& app, std::size_t& set, const std::string& help) {
  app.add_option_function<std::string>(
         "--read-texcoord",
         [&set](const std::string& text) { set = texcoordSet("--read-texcoord", text, ""); },
         wrapped(help))
      ->default_str("0")
      ->type_name("NUMBER");
}

void addOwnTexels(CLI::App& app, bool& ownTexels) {
  app.add_flag("--own-texels", ownTexels,
               wrapped("give each node of a glTF texels of its own where several share a mesh, as "
                       "lightmaps need; the output has a copy of the mesh for each"));
}

void addAllowOutside(CLI::App& app, bool& allowsOutside) {
  app.add_flag("--allow-outside", allowsOutside,
               wrapped("read buffers, material files and images that the mesh refers to from any "
                       "folder, not only from the folder of the mesh and its subfolders"));
}

void addReport(CLI::App& app, std::string& report) {
  app.add_option("--report", report,
                 wrapped("JSON file for the report; - writes to standard output"))
      ->check(notEmpty())
      ->type_name("FILE");
}

void addQuiet(CLI::App& app, bool& quiet) {
  app.add_flag("-q,--quiet", quiet, "print only errors: no progress, no summary");
}

void refuse(const char* option, const std::string& what) {
  throw CLI::ValidationError(option, what + ". Give it another name");
}

bool replaces(const std::string& target, const std::string& source) {
  return !target.empty() && !source.empty() && target != kStandardStream &&
         isSameTarget(target, source);
}

}  // namespace abflat::cli
