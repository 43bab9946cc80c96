#include <iomanip>
#include <sstream>

#include "arguments/options.h"
#include "arguments/subcommands.h"

namespace abflat::cli {
namespace {

std::string sampleHelp() {
  std::ostringstream out;
  out << "Samples:\n";
  for (const Sample& sample : samples())
    out << "  " << std::left << std::setw(14) << sample.name << sample.title << "\n";
  return out.str();
}

CLI::Validator sampleName() {
  return CLI::Validator(
      [](const std::string& text) -> std::string {
        std::string known;
        for (const Sample& sample : samples()) {
          if (sample.name == text) return "";
          known += (known.empty() ? "" : ", ") + std::string(sample.name);
        }
        return "there is no sample '" + text + "'. Use " + known;
      },
      "");
}

}  // namespace

CLI::App* addSample(CLI::App& app, SampleCommand& c) {
  CLI::App* sub = app.add_subcommand("sample", "Write a generated mesh to experiment with");
  sub->group("Commands");
  sub->add_option("NAME", c.name, "one of the samples below")
      ->required()
      ->check(sampleName())
      ->type_name("");
  addOutput(*sub, c.output);
  std::ostringstream range;
  range << "from " << kMinSampleDetail << " to " << kMaxSampleDetail;
  sub->add_option("--detail", c.detail, "multiplies the number of faces, " + range.str())
      ->check(numberCheck(range.str(),
                          [](double d) { return d >= kMinSampleDetail && d <= kMaxSampleDetail; }))
      ->capture_default_str()
      ->type_name("NUMBER");
  sub->footer(sampleHelp());
  setUsage(*sub, "abflat sample NAME -o OUT [--detail NUMBER]");
  return sub;
}

}  // namespace abflat::cli
