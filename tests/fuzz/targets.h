#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace abflat::fuzz {

/// What a fuzzer runs on bytes that it makes up. Ends the process where a property does not hold.
/// False: nothing came of the bytes (they are no mesh, or one that is refused).
using Target = bool (*)(const std::uint8_t* bytes, std::size_t size);

bool readObj(const std::uint8_t* bytes, std::size_t size);
bool readPly(const std::uint8_t* bytes, std::size_t size);
bool readStl(const std::uint8_t* bytes, std::size_t size);
bool readOff(const std::uint8_t* bytes, std::size_t size);
bool readGltf(const std::uint8_t* bytes, std::size_t size);
/// An OBJ, and material files and images that it refers to.
bool readMaterials(const std::uint8_t* bytes, std::size_t size);
/// A random mesh with random options to an atlas, and on to files.
bool unwrapMesh(const std::uint8_t* bytes, std::size_t size);
bool flattenMesh(const std::uint8_t* bytes, std::size_t size);
/// A random mesh with a random layout, packed again.
bool packMesh(const std::uint8_t* bytes, std::size_t size);
/// A layout, random or of a file, judged.
bool verifyMesh(const std::uint8_t* bytes, std::size_t size);

struct NamedTarget {
  const char* name;
  Target run;
};

constexpr std::array<NamedTarget, 10> kTargets = {{{"obj", readObj},
                                                   {"ply", readPly},
                                                   {"stl", readStl},
                                                   {"off", readOff},
                                                   {"gltf", readGltf},
                                                   {"materials", readMaterials},
                                                   {"unwrap", unwrapMesh},
                                                   {"flatten", flattenMesh},
                                                   {"pack", packMesh},
                                                   {"verify", verifyMesh}}};

}  // namespace abflat::fuzz
