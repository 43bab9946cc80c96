#include <algorithm>
#include <csignal>
#include <filesystem>

#include "batch/awaited_signals.h"
#include "batch/batch_run.h"
#include "batch/batch_text.h"
#include "batch/merge.h"
#include "batch/report_page.h"
#include "commands/commands.h"
#include "files/output_file.h"
#include "files/paths.h"
#include "terminal/terminal.h"

namespace abflat::cli {
namespace {

std::string pathIn(const BatchCommand& command, const std::string& name) {
  return (std::filesystem::path(command.out) / name).string();
}

int endedWith(const Status& status) {
  complain(status.message);
  // So that the parent process sees which signal ended the program.
  if (status.code == StatusCode::Aborted) raise(AwaitedSignals::asked());
  return exitCodeOf(status.code);
}

Status printed(const BatchCommand& command, const std::string& text) {
  return command.quiet ? Status{} : OutputFile(kStandardStream).writeNow(text);
}

/// Writes the page about a whole manifest, and says what is in it.
int concluded(const BatchCommand& command, const ManifestLines& lines, bool isPart) {
  if (!isPart)
    if (Status s =
            OutputFile(pathIn(command, "report.html")).writeNow(reportPage(lines, command.out));
        !s.ok())
      return endedWith(s);
  std::string text = batchText(lines, pathIn(command, manifestName(command.shard, command.shards)));
  if (isPart)
    text += "Once all parts are done, 'abflat batch --merge --out " + command.out +
            "' makes one manifest and the report.\n";
  if (Status s = printed(command, text); !s.ok()) return endedWith(s);
  const bool isGood = std::all_of(lines.begin(), lines.end(),
                                  [](const auto& line) { return line.second.isGood(); });
  return static_cast<int>(isGood ? ExitCode::Valid : ExitCode::NotValid);
}

}  // namespace

int runBatch(const BatchCommand& command) {
  if (command.merge) {
    const Result<ManifestLines> lines = mergeManifests(command.out);
    return lines.ok() ? concluded(command, lines.value(), false) : endedWith(lines.status());
  }
  BatchRun batch(command);
  if (Status s = batch.plan(); !s.ok()) return endedWith(s);
  if (command.dryRun) {
    const Status s = OutputFile(kStandardStream).writeNow(batch.planText());
    return s.ok() ? static_cast<int>(ExitCode::Valid) : endedWith(s);
  }
  if (Status s = batch.run(); !s.ok()) return endedWith(s);
  return concluded(command, batch.lines(), command.shards > 1);
}

}  // namespace abflat::cli
