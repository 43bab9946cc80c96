#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "abflat/flatten.h"
#include "abflat/generated/bake_options.h"
#include "abflat/gltf.h"
#include "abflat/pack_layout.h"
#include "abflat/samples.h"
#include "abflat/unwrap.h"
#include "abflat/verify.h"
#include "files/kept_faces.h"

namespace abflat::cli {

/// Whether textures are to follow the layout that a command makes, and how.
struct Baking {
  bool isWanted = false;
  BakeOptionValues options;  ///< all but padding and threads, which are those of the layout
};

struct UnwrapCommand {
  std::string input, output;
  std::string movedTo;                  ///< where the output will lie; empty: where it is written
  bool allowsOutside = false;           ///< files that the mesh refers to may be anywhere
  std::optional<std::size_t> texcoord;  ///< number of the glTF set to write; none: auto
  GltfReadOptions gltf;
  std::string report;  ///< empty: not wanted
  UnwrapOptionValues options;
  SeamSources seams;
  std::string seamFile;  ///< edges to cut along; empty: none
  KeptFaces keep;
  std::string pins;  ///< file with pinned vertices; empty: none
  Baking baking;
  std::string writeSeams;  ///< file for the edges that were cut; empty: not wanted
  std::string layout;      ///< picture of the atlas, .svg or .png; empty: not wanted
  double scale = 0;        ///< millimetres per mesh unit in an SVG; 0: pixels
  std::string heatMap;     ///< picture of the distortion, .png; empty: not wanted
  bool quiet = false;
};

/// Meshes that share an atlas.
struct AtlasCommand {
  std::string parts;     ///< file that names them, see AtlasPart
  UnwrapCommand unwrap;  ///< without input and output
};

struct PackCommand {
  std::string input, output;
  std::string movedTo;                  ///< where the output will lie; empty: where it is written
  bool allowsOutside = false;           ///< files that the mesh refers to may be anywhere
  std::optional<std::size_t> texcoord;  ///< number of the glTF set to write; none: the one read
  GltfReadOptions gltf;
  std::string report;  ///< empty: not wanted
  PackOptionValues options;
  Baking baking;
  std::string layout;  ///< picture of the atlas, .svg or .png; empty: not wanted
  bool quiet = false;
};

struct BakeCommand {
  std::string input, output;
  std::string movedTo;         ///< where the output will lie; empty: where it is written
  bool allowsOutside = false;  ///< files that the mesh refers to may be anywhere
  std::optional<std::size_t> texcoord = 1;  ///< number of the glTF set with the new layout
  std::string report;                       ///< empty: not wanted
  BakeOptionValues options;
  bool quiet = false;
};

struct VerifyCommand {
  std::string input;
  bool allowsOutside = false;  ///< files that the mesh refers to may be anywhere
  GltfReadOptions gltf;
  std::string rules;                          ///< file with further options; empty: none
  std::string against;                        ///< file to compare with; empty: none
  std::string report, junit, sarif, picture;  ///< empty: not wanted
  VerifyOptionValues options;
  std::vector<bool> given;  ///< per option: not to be taken from the rules
  bool quiet = false;
};

struct FlattenCommand {
  std::string input, output;
  std::string movedTo;                  ///< where the output will lie; empty: where it is written
  bool allowsOutside = false;           ///< files that the mesh refers to may be anywhere
  std::optional<std::size_t> texcoord;  ///< number of the glTF set to write; none: auto
  std::string report;                   ///< empty: not wanted
  FlattenOptionValues options;
  std::string bounds;    ///< file with bounds of single vertices; empty: none
  std::string straight;  ///< file with straight runs; empty: none
  std::string pins;      ///< file with pinned vertices; empty: none
  bool quiet = false;
};

struct InspectCommand {
  std::string input;
  bool allowsOutside = false;
  bool json = false;
};

struct SampleCommand {
  std::string name, output;
  double detail = kMinSampleDetail;
};

struct SweepCommand {
  std::string input;
  bool allowsOutside = false;
  std::vector<double> t = {2, 1.05, 1,
                           0.968};    ///< those of the paper's table 2; may include kAutoT
  std::vector<double> balance = {0};  ///< each is combined with each t
  std::string csv;                    ///< file to write; empty: print a readable table
};

struct CompareCommand {
  std::string input;
  bool allowsOutside = false;
  std::string json;  ///< file to write; empty: print a readable table
};

struct ReproduceCommand {
  std::string meshes;  ///< folder; empty: only the generated models
  std::string out;     ///< folder
  bool wantsTables = true, wantsConvergence = true, wantsFigures = true;
  FlattenOptionValues options;  ///< precondition only
  bool quiet = false;
};

/// A word that a command takes for one of its options, and its value unless it is a switch.
struct GivenOption {
  std::string flag;
  std::optional<std::string> value;
};

struct BatchCommand {
  std::vector<std::string> inputs;  ///< files, folders, globs; "-": a list on standard input
  std::vector<std::string> lists;   ///< files with a list
  std::string out;
  std::string run = "unwrap";
  std::vector<GivenOption> options;  ///< of the command that is run
  bool hasFolderAtlases = false;     ///< meshes of a folder share an atlas
  std::string ending;      ///< of results, such as ".glb"; empty: as the input, if it can be
  std::size_t jobs = 0;    ///< 0: one per processor
  double timeLimit = 0;    ///< seconds per mesh; 0: none
  double memoryLimit = 0;  ///< MB per mesh; 0: none
  double totalMemory = 0;  ///< MB of all together; 0: most of what is free
  std::size_t shard = 0, shards = 1;
  bool resume = false, dryRun = false, merge = false, quiet = false;
  bool pictures = true;
};

/// Everything has been printed already (help, version, a usage error).
struct Finished {
  int exitCode = 0;
};

using Command = std::variant<Finished, UnwrapCommand, AtlasCommand, FlattenCommand, PackCommand,
                             BakeCommand, VerifyCommand, BatchCommand, InspectCommand,
                             SampleCommand, SweepCommand, CompareCommand, ReproduceCommand>;

/// Prints help and version to standard output, usage errors to standard error.
Command parseArguments(int argc, const char* const* argv);

/// The command of these words, without the name of the program. Errors: InvalidOption.
Result<Command> parseWords(const std::vector<std::string>& words);

/// Files that a command reads besides its mesh.
std::vector<std::string> filesReadBy(const Command& command);

/// An option of a command that batch passes on.
struct OptionOfCommand {
  std::string flag;
  bool hasValue = false;
};

/// Those of a command, which is one of unwrap, flatten, pack, bake, verify.
std::vector<OptionOfCommand> optionsOfCommand(const std::string& command);

}  // namespace abflat::cli
