#include <csignal>
#include <exception>
#include <new>
#include <string>

#include "commands/commands.h"
#include "files/out_of_memory.h"
#include "memory/pages.h"
#include "terminal/terminal.h"

namespace abflat::cli {
namespace {

struct Runner {
  int operator()(const Finished& finished) const { return finished.exitCode; }
  int operator()(const UnwrapCommand& command) const { return runUnwrap(command); }
  int operator()(const FlattenCommand& command) const { return runFlatten(command); }
  int operator()(const PackCommand& command) const { return runPack(command); }
  int operator()(const BakeCommand& command) const { return runBake(command); }
  int operator()(const AtlasCommand& command) const { return runAtlas(command); }
  int operator()(const VerifyCommand& command) const { return runVerify(command); }
  int operator()(const BatchCommand& command) const { return runBatch(command); }
  int operator()(const InspectCommand& command) const { return runInspect(command); }
  int operator()(const SampleCommand& command) const { return runSample(command); }
  int operator()(const SweepCommand& command) const { return runSweep(command); }
  int operator()(const CompareCommand& command) const { return runCompare(command); }
  int operator()(const ReproduceCommand& command) const { return runReproduce(command); }
};

int ended(const Status& status) {
  complain(status.message);
  return exitCodeOf(status.code);
}

}  // namespace
}  // namespace abflat::cli

int main(int argc, char** argv) {
  using namespace abflat;
  cli::beginWithHugePages(argv);
  // A reader that goes away makes the output unwritable, which has its own exit code.
  std::signal(SIGPIPE, SIG_IGN);
  // So does a file that grows beyond the user's limits.
  std::signal(SIGXFSZ, SIG_IGN);
  cli::keepFreedMemory();
  try {
    return std::visit(cli::Runner{}, cli::parseArguments(argc, argv));
  } catch (const std::bad_alloc&) {
    return cli::ended(cli::outOfMemory("abflat"));
  } catch (const std::exception& defect) {
    return cli::ended({StatusCode::Internal,
                       std::string("this is a bug in abflat. Please report it: ") + defect.what()});
  }
}
