#include "abflat/inspect.h"
#include "commands/commands.h"
#include "files/input_file.h"
#include "files/out_of_memory.h"
#include "files/output_file.h"
#include "files/paths.h"
#include "terminal/terminal.h"
#include "terminal/texts.h"

namespace abflat::cli {

int runInspect(const InspectCommand& command) {
  const std::string name = inputName(command.input);
  const auto ended = [](const Status& status) {
    complain(status.message);
    return exitCodeOf(status.code);
  };
  const Result<InputFile> input = readInput(command.input, {Repeated::Join, command.allowsOutside});
  if (!input.ok()) return ended(input.status());
  const Result<MeshSummary> summary = orOutOfMemory(name, [&]() -> Result<MeshSummary> {
    MeshSummary found = inspect(input.value().mesh);
    if (found.disk.code == StatusCode::OutOfMemory) return found.disk;
    return found;
  });
  if (!summary.ok()) return ended(summary.status());
  OutputFile out(kStandardStream);
  const Status written =
      out.writeNow(command.json ? inspectJson(summary.value(), command.input)
                                : inspectText(summary.value(), name, input.value().notes));
  return written.ok() ? static_cast<int>(ExitCode::Valid) : ended(written);
}

}  // namespace abflat::cli
