#include "abflat/io.h"
#include "abflat/samples.h"
#include "commands/commands.h"
#include "files/layout_text.h"
#include "files/out_of_memory.h"
#include "files/output_file.h"
#include "terminal/terminal.h"

namespace abflat::cli {
namespace {

Result<std::string> sampleText(const SampleCommand& command) {
  for (const Sample& sample : samples())
    if (sample.name == command.name) {
      InputFile input;
      input.mesh = sample.make(command.detail);
      return layoutText(input, command.output, 0, {{}, {}, triangleCornersOf(input.mesh), {}});
    }
  return Status{StatusCode::InvalidOption, "there is no sample '" + command.name + "'"};
}

}  // namespace

int runSample(const SampleCommand& command) {
  OutputFile out(command.output);
  Status status = out.check();
  if (status.ok()) {
    Result<std::string> text =
        orOutOfMemory("sample " + command.name, [&] { return sampleText(command); });
    status = text.status();
    if (status.ok()) status = out.writeNow(std::move(text.value()));
  }
  if (!status.ok()) complain(status.message);
  return exitCodeOf(status.code);
}

}  // namespace abflat::cli
