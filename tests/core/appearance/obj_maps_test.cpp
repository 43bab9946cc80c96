#include "abflat/obj_maps.h"

#include "abflat/io.h"
#include "catch.h"

namespace abflat {
namespace {

constexpr const char* kObj =
    "mtllib a.mtl\r\nv 0 0 0\nv 1 0 0\nv 0 1 0\nmtllib b.mtl\nusemtl wood\nf 1 2 3\n";

ObjMaps mapsOf(const std::string& mtl) {
  const PolygonMesh mesh = readMesh(kObj, MeshFormat::Obj, "a.obj").value();
  return readObjMaps(kObj, mesh,
                     [&](const std::string& path) -> Result<std::string> {
                       if (path == "a.mtl") return mtl;
                       if (path == "b.mtl") return std::string("newmtl wood\nmap_Kd other.png\n");
                       if (path == "lost.png")
                         return Status{StatusCode::UnreadableFile, "it is lost"};
                       return "image " + path;
                     })
      .value();
}

TEST_CASE("lines of images are read with what places them", "[appearance]") {
  const ObjMaps maps = mapsOf(
      "newmtl wood\nmap_Kd -s 2 3 1 -o 0.5 -clamp on my wood.png\nMAP_BUMP -bm 0.5 b.png\n"
      "refl -type sphere c.png\nmap_d lost.png\nKd 1 1 1\nmap_aat on\n");
  REQUIRE(maps.materials.size() == 1);
  const std::vector<MtlMap>& row = maps.materials[0];
  REQUIRE(row.size() == 4);
  CHECK(row[0].name == "diffuse");
  CHECK(row[0].meaning == MtlMeaning::Colour);
  CHECK(row[0].scale == std::array<double, 2>{2, 3});
  CHECK(row[0].offset == std::array<double, 2>{0.5, 0});
  CHECK(row[0].isClamped);
  CHECK(maps.images[row[0].image].bytes == "image my wood.png");
  CHECK(row[1].meaning == MtlMeaning::Relief);
  CHECK(row[1].strength == 0.5);
  CHECK(row[2].image == kNoImage);
  CHECK(row[3].image == kNoImage);
  CHECK(maps.notes ==
        std::vector<std::string>{
            "'refl' of material 'wood' was left out, because images of this kind are not baked",
            "image lost.png was left out: it is lost"});
}

TEST_CASE("a material file keeps all but images and what places them", "[appearance]") {
  const ObjMaps maps = mapsOf(
      "# first\nnewmtl none\nmap_Kd a.png\r\nnewmtl wood\r\nKd 1 0 0 # red\nmap_Kd -s 2 2 -mm 0 1 "
      "a.png\nrefl c.png\nbump -bm 2 -o 1 b.png");
  REQUIRE(maps.materials[0].size() == 3);
  CHECK(writeMtl(maps, {{"new.png", "", "bumps.png"}}) ==
        "newmtl wood\r\nKd 1 0 0 # red\nmap_Kd -mm 0 1 new.png\nbump -bm 2 bumps.png\n");
}

TEST_CASE("an OBJ names its material file once", "[appearance]") {
  CHECK(withMtl(kObj, "new.mtl") ==
        "mtllib new.mtl\r\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl wood\nf 1 2 3\n");
  CHECK(withMtl("v 0 0 0\n# mtllib a\n", "new.mtl") == "v 0 0 0\n# mtllib a\n");
}

}  // namespace
}  // namespace abflat
