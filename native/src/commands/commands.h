#pragma once

#include "arguments/arguments.h"

namespace abflat::cli {

// Each returns the exit code, after reporting any error on standard error.
int runUnwrap(const UnwrapCommand& command);
int runFlatten(const FlattenCommand& command);
int runPack(const PackCommand& command);
int runBake(const BakeCommand& command);
int runAtlas(const AtlasCommand& command);
int runVerify(const VerifyCommand& command);
int runBatch(const BatchCommand& command);
int runInspect(const InspectCommand& command);
int runSample(const SampleCommand& command);
int runSweep(const SweepCommand& command);
int runCompare(const CompareCommand& command);
int runReproduce(const ReproduceCommand& command);

}  // namespace abflat::cli
