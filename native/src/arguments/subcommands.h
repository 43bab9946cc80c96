#pragma once

#include <CLI/CLI.hpp>

#include "arguments/arguments.h"

namespace abflat::cli {

CLI::App* addUnwrap(CLI::App& app, UnwrapCommand& c);
CLI::App* addFlatten(CLI::App& app, FlattenCommand& c);
/// Hidden: batch starts it.
CLI::App* addAtlas(CLI::App& app, AtlasCommand& c);
CLI::App* addPack(CLI::App& app, PackCommand& c);
CLI::App* addBake(CLI::App& app, BakeCommand& c);
CLI::App* addVerify(CLI::App& app, VerifyCommand& c);
/// `run`: the command that is run, whose options are options of batch, too.
CLI::App* addBatch(CLI::App& app, BatchCommand& c, const std::string& run);
CLI::App* addInspect(CLI::App& app, InspectCommand& c);
CLI::App* addSample(CLI::App& app, SampleCommand& c);
CLI::App* addSweep(CLI::App& app, SweepCommand& c);
CLI::App* addCompare(CLI::App& app, CompareCommand& c);
CLI::App* addReproduce(CLI::App& app, ReproduceCommand& c);

/// Which options of the parsed command were given.
void noteGiven(const CLI::App& app, VerifyCommand& c);

/// Checks that involve several options; throws CLI::ValidationError. A mesh may be replaced by its
/// own result.
void checkTogether(const UnwrapCommand& c);
void checkTogether(const FlattenCommand& c);
void checkTogether(const AtlasCommand& c);
void checkTogether(const PackCommand& c);
void checkTogether(const BakeCommand& c);
void checkTogether(const VerifyCommand& c);
void checkTogether(const BatchCommand& c);
void checkTogether(const SweepCommand& c);
void checkTogether(const CompareCommand& c);

}  // namespace abflat::cli
