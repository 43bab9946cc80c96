#include "gltf/textures.h"

#include <utility>

#include "gltf/uri.h"

namespace abflat::gltf {
namespace {

constexpr std::size_t kMostSets = 64;

Wrap wrapOf(const Field& code) {
  constexpr std::size_t kRepeat = 10497, kMirror = 33648, kClamp = 33071;
  switch (code.count(kRepeat)) {
    case kRepeat:
      return Wrap::Repeat;
    case kMirror:
      return Wrap::Mirror;
    case kClamp:
      return Wrap::Clamp;
  }
  code.complain("must be 10497, 33071 or 33648");
  return Wrap::Repeat;
}

}  // namespace

TextureReader::TextureReader(const Document& document, const ReadResource& readResource,
                             Complaints& complaints)
    : document_(document),
      readResource_(readResource),
      complaints_(complaints),
      root_(&document.json, "", complaints),
      numbers_(root_["images"].items().size(), kNone) {}

GltfTexture TextureReader::read(const Field& info) {
  GltfTexture out;
  if (!info.isPresent()) return out;
  const std::vector<Field> textures = root_["textures"].items();
  const std::size_t index = info["index"].requiredIndex(textures.size(), "textures");
  if (index == kNone) return out;
  out.image = imageOf(textures[index]);
  out.texcoord = info["texCoord"].count(0);
  setWrap(textures[index], out);
  const Field transform = info["extensions"]["KHR_texture_transform"];
  transform["offset"].numbers(out.offset.data(), 2);
  transform["scale"].numbers(out.scale.data(), 2);
  out.rotation = transform["rotation"].number(0);
  out.texcoord = transform["texCoord"].count(out.texcoord);
  if (out.texcoord >= kMostSets) info["texCoord"].complain("is above 63");
  return out;
}

void TextureReader::setWrap(const Field& texture, GltfTexture& out) const {
  const std::vector<Field> samplers = root_["samplers"].items();
  const std::size_t index = texture["sampler"].index(samplers.size(), "samplers");
  if (index == kNone) return;
  out.wrapU = wrapOf(samplers[index]["wrapS"]);
  out.wrapV = wrapOf(samplers[index]["wrapT"]);
}

/// The image that every program reads, or else the one for those with an extension.
std::size_t TextureReader::imageOf(const Field& texture) {
  std::size_t image = texture["source"].index(numbers_.size(), "images");
  for (const auto& extension : texture["extensions"].members())
    if (image == kNone) image = extension.second["source"].index(numbers_.size(), "images");
  if (image == kNone) return kNoImage;
  if (numbers_[image] == kNone) {
    numbers_[image] = images_.size();
    images_.push_back(load(image));
  }
  return numbers_[image];
}

ImageFile TextureReader::load(std::size_t image) const {
  const Field field = root_["images"].items()[image];
  ImageFile out{document_.fileName + ": " + field.place(), field["mimeType"].text(), {}};
  if (const std::string name = field["name"].text(); !name.empty()) out.name += " '" + name + "'";
  if (!field["uri"].isPresent()) {
    const std::size_t view =
        field["bufferView"].requiredIndex(document_.views.size(), "bufferViews");
    if (view != kNone) out.bytes = std::string(document_.viewBytes(view));
    return out;
  }
  const std::string uri = field["uri"].text();
  const bool isRemote = !isDataUri(uri) && hasScheme(uri);
  if (isRemote)
    field["uri"].complain("is " + uri + ", which is not a local file. Download it first");
  if (isRemote) return out;
  Result<std::string> bytes = isDataUri(uri) ? dataOf(uri) : readResource_(pathOfUri(uri));
  if (bytes.ok())
    out.bytes = std::move(bytes).value();
  else if (isDataUri(uri))
    field["uri"].complain(bytes.status().message);
  else
    complaints_.fail({bytes.status().code, out.name + ": " + bytes.status().message});
  return out;
}

}  // namespace abflat::gltf
