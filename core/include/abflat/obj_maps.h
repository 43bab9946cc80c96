#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "abflat/appearance.h"
#include "abflat/export.h"
#include "abflat/mesh.h"
#include "abflat/status.h"

// The images that the materials of an OBJ use, and its material file with others in their place.

namespace abflat {

/// What the numbers in an image of a material stand for.
enum class MtlMeaning {
  Colour,
  Number,   ///< such as roughness or opacity
  Normal,   ///< a normal map
  Relief,   ///< a normal map or heights, as the image tells
  Unknown,  ///< it cannot follow another layout
};

/// A line of a material that uses an image. Its texcoords, with v upwards, are scaled, then moved.
struct MtlMap {
  std::string name;  ///< what it is, such as diffuse; the keyword if that is not known
  MtlMeaning meaning = MtlMeaning::Unknown;
  std::size_t image = kNoImage;  ///< in ObjMaps; kNoImage: it cannot be used
  std::array<double, 2> scale = {1, 1}, offset = {0, 0};
  bool isClamped = false;
  double strength = 1;  ///< of bumps
};

/// A material file, and the folder that its paths are relative to.
struct MtlFile {
  std::string text, folder;
};

struct ObjMaps {
  std::vector<std::vector<MtlMap>> materials;  ///< by number in materialNames of the mesh
  std::vector<std::string> materialNames;      ///< those of the mesh
  std::vector<ImageFile> images;
  std::vector<MtlFile> files;      ///< the first that has a material counts
  std::vector<std::string> notes;  ///< what cannot be used, one sentence each
};

/// Those of the OBJ text that `mesh` was read from. Errors: OutOfMemory.
ABFLAT_API Result<ObjMaps> readObjMaps(std::string_view bytes, const PolygonMesh& mesh,
                                       const ReadResource& readResource);

/// The material files as one, of the materials of the mesh alone. `names` has the new file of each
/// map, by material; lines of maps where it is empty are left out, as is what places the old ones.
ABFLAT_API std::string writeMtl(const ObjMaps& maps,
                                const std::vector<std::vector<std::string>>& names);

/// An OBJ text that names this material file in place of its own.
ABFLAT_API std::string withMtl(std::string_view obj, const std::string& name);

}  // namespace abflat
