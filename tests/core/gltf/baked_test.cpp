#include "abflat/gltf_look.h"
#include "catch.h"
#include "gltf/drop_unused.h"
#include "gltf_files.h"

namespace abflat::test {
namespace {

/// Two triangles with a material each; the last material and the first image are used by none.
std::string paintedGlb(const std::string& extensions = "[]") {
  const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::vector<float> uv = {0, 0, 1, 0, 0, 1};
  std::string json = R"({
    "asset": {"version": "2.0"}, "extensionsUsed": {EXTENSIONS},
    "buffers": [{"byteLength": {SIZE}}],
    "bufferViews": [
      {"buffer": 0, "byteOffset": 0, "byteLength": 36},
      {"buffer": 0, "byteOffset": 36, "byteLength": 24},
      {"buffer": 0, "byteOffset": 60, "byteLength": 5},
      {"buffer": 0, "byteOffset": 65, "byteLength": 6}],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
       "min": [0, 0, 0], "max": [1, 1, 0]},
      {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}],
    "images": [{"bufferView": 2, "mimeType": "image/png"},
               {"bufferView": 3, "mimeType": "image/png", "name": "bark"}],
    "samplers": [{"wrapS": 33071, "wrapT": 33648}],
    "textures": [{"source": 1, "sampler": 0}],
    "materials": [
      {"pbrMetallicRoughness": {"metallicFactor": 0.5, "baseColorTexture": {
         "index": 0, "texCoord": 0, "extensions": {"KHR_texture_transform": {
           "offset": [0.25, 0.5], "rotation": 1.5, "scale": [2, 3]}}}}},
      {"emissiveFactor": [1, 0.5, 0], "alphaMode": "MASK", "extensions":
         {"KHR_materials_emissive_strength": {"emissiveStrength": 4}}},
      {"name": "unused", "normalTexture": {"index": 0}}],
    "meshes": [{"primitives": [
      {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0},
      {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 1}]}]})";
  const std::string kPlace = "{EXTENSIONS}";
  json.replace(json.find(kPlace), kPlace.size(), extensions);
  return glbOf(json, bytesOf(positions) + bytesOf(uv) + "first" + "second");
}

Result<std::string> nothing(const std::string& path) {
  return Status{StatusCode::UnreadableFile, "there is no " + path};
}

}  // namespace

TEST_CASE("the look of a glTF is read as bake needs it") {
  const GltfModel model = readAlone(paintedGlb()).value();
  const GltfLook look = readGltfLook(*model.source, nothing).value();
  REQUIRE(look.materials.size() == 2);
  const GltfMaterial& bark = look.materials[0];
  CHECK((bark.metallic == 0.5 && bark.roughness == 1 && bark.alpha == GltfAlpha::Opaque));
  const GltfTexture& texture = bark.baseColorTexture;
  CHECK((texture.wrapU == Wrap::Clamp && texture.wrapV == Wrap::Mirror && texture.image == 0));
  CHECK((texture.offset[0] == 0.25 && texture.rotation == 1.5 && texture.scale[1] == 3));
  const GltfMaterial& glow = look.materials[1];
  CHECK((glow.emission[0] == 4 && glow.emission[1] == 2 && glow.alpha == GltfAlpha::Mask));
  REQUIRE(look.images.size() == 1);
  CHECK((look.images[0].bytes == "second" && look.images[0].name == "a.glb: images[1] 'bark'"));
  REQUIRE(look.parts.size() == 2);
  CHECK((look.parts[1].firstFace == 1 && look.parts[1].material == 1));
  CHECK(look.texcoords[0] == std::vector<double>{0, 0, 1, 0, 0, 1});
  CHECK(look.positions.empty());  // there is no normal map
  CHECK(freeTexcoord(*model.source) == 1);
  CHECK(freeTexcoord(*model.source, true) == 0);
}

TEST_CASE("new images take the place of the old ones") {
  GltfBaked baked;
  baked.images = {{"colours", "image/png", "new bytes"}};
  baked.baseColor = 0;
  GltfWriteOptions options;
  options.baked = &baked;
  for (const bool isKnown : {true, false}) {
    const GltfModel model =
        readAlone(paintedGlb(isKnown ? R"(["KHR_texture_transform"])" : R"(["ACME_strange"])"))
            .value();
    const std::string bytes =
        writeGltf(*model.source, model.mesh.texcoords, model.mesh.faceTexcoords, options).value();
    CHECK((bytes.find("second") == bytes.npos) == isKnown);
    CHECK((bytes.find("unused") == bytes.npos) == isKnown);
    CHECK((bytes.find("\"extensionsUsed\"") == bytes.npos) == isKnown);
    const GltfModel again = readAlone(bytes).value();
    CHECK(again.mesh.positions == model.mesh.positions);
    CHECK(again.mesh.texcoords == model.mesh.texcoords);
    const GltfLook look = readGltfLook(*again.source, nothing).value();
    REQUIRE(look.materials.size() == 2);  // one of them glows
    REQUIRE(look.images.size() == 1);
    CHECK(look.images[0].bytes == "new bytes");
    for (const GltfMaterial& material : look.materials) {
      CHECK(material.baseColorTexture.image == 0);
      CHECK(material.baseColorTexture.wrapU == Wrap::Repeat);
    }
    CHECK(look.materials[0].metallic == 0.5);
    CHECK(look.materials[1].emission[0] == 4);
  }
}

TEST_CASE("what is left of a file refers to the same things") {
  gltf::Json json = gltf::parsedJson(R"({
    "buffers": [{"byteLength": 16}],
    "bufferViews": [{"byteOffset": 0, "byteLength": 3}, {"byteOffset": 4, "byteLength": 4},
                    {"byteOffset": 9, "byteLength": 7}, {"byteOffset": 4, "byteLength": 4}],
    "accessors": [{"bufferView": 0}, {"bufferView": 1},
                  {"sparse": {"indices": {"bufferView": 2}, "values": {"bufferView": 3}}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 2}, "targets": [{"NORMAL": 1}]}]}],
    "materials": [{"name": "unused"}]})")
                        .value();
  std::string buffer = "abc.defg.hijklmn";
  gltf::dropUnused(json, buffer);
  CHECK(buffer.find("abc") == buffer.npos);
  CHECK(!json.has("materials"));
  const gltf::Json& accessors = json["accessors"];
  REQUIRE(accessors.items().size() == 2);
  const auto bytesOfView = [&](const gltf::Json& number) {
    const gltf::Json& view = json["bufferViews"][*number.wholeNumber()];
    return buffer.substr(*view["byteOffset"].wholeNumber(), *view["byteLength"].wholeNumber());
  };
  CHECK(bytesOfView(accessors[0]["bufferView"]) == "defg");
  CHECK(bytesOfView(accessors[1]["sparse"]["indices"]["bufferView"]) == "hijklmn");
  CHECK(bytesOfView(accessors[1]["sparse"]["values"]["bufferView"]) == "defg");
  const gltf::Json& primitive = json["meshes"][0]["primitives"][0];
  CHECK(*primitive["attributes"]["POSITION"].wholeNumber() == 1);
  CHECK(*primitive["targets"][0]["NORMAL"].wholeNumber() == 0);
  CHECK(*json["buffers"][0]["byteLength"].wholeNumber() == buffer.size());
  const std::string once = json.dump(false);
  gltf::dropUnused(json, buffer);
  CHECK(json.dump(false) == once);
}

}  // namespace abflat::test
