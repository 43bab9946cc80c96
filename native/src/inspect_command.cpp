#include "abflat/inspect.h"
#include "commands.h"
#include "input_file.h"
#include "out_of_memory.h"
#include "output_file.h"
#include "paths.h"
#include "terminal.h"
#include "texts.h"

namespace abflat::cli {

int runInspect(const InspectCommand& command) {
  const std::string name = inputName(command.input);
  const auto ended = [](const Status& status) {
    complain(status.message);
    return exitCodeOf(status.code);
  };
  const Result<InputMesh> input = readInput(command.input, {Repeated::Join, command.allowsOutside});
  if (!input.ok()) return ended(input.status);
  const Result<MeshSummary> summary =
      orOutOfMemory(name, [&]() -> Result<MeshSummary> { return inspect(input.value.mesh); });
  if (!summary.ok()) return ended(summary.status);
  OutputFile out(kStandardStream);
  const Status written =
      out.writeNow(command.json ? inspectJson(summary.value, command.input)
                                : inspectText(summary.value, name, input.value.notes));
  return written.ok() ? static_cast<int>(ExitCode::Valid) : ended(written);
}

}  // namespace abflat::cli
