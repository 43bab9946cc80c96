#include "baking/old_obj.h"

#include <utility>

namespace abflat::cli {
namespace {

void leaveOut(ObjMaps& maps, std::size_t image, const std::string& why) {
  maps.notes.push_back("image " + maps.images[image].name + " was left out: it " + why);
  for (std::vector<MtlMap>& material : maps.materials)
    for (MtlMap& map : material)
      if (map.image == image) map.image = kNoImage;
}

/// Of all images; those that cannot be read are no longer used.
Result<std::vector<ImageTraits>> traitsOfAll(ObjMaps& maps) {
  std::vector<ImageTraits> out;
  for (std::size_t i = 0; i < maps.images.size(); ++i) {
    const Result<images::Image> image = images::readImage(maps.images[i].bytes, "");
    if (!image.ok() && image.status().code != StatusCode::ParseError) return image.status();
    if (!image.ok()) leaveOut(maps, i, image.status().message.substr(1));
    out.push_back(image.ok() ? traitsOf(image.value().view()) : ImageTraits());
  }
  return out;
}

/// Those that are used move to the front, so that only they are taken.
void dropUnused(ObjMaps& maps, std::vector<ImageTraits>& traits) {
  std::vector<std::size_t> numbers(maps.images.size(), kNoImage);
  std::vector<ImageFile> images;
  std::vector<ImageTraits> theirs;
  for (std::vector<MtlMap>& material : maps.materials)
    for (MtlMap& map : material) {
      if (map.image == kNoImage) continue;
      std::size_t& number = numbers[map.image];
      if (number == kNoImage) {
        number = images.size();
        images.push_back(std::move(maps.images[map.image]));
        theirs.push_back(traits[map.image]);
      }
      map.image = number;
    }
  maps.images = std::move(images);
  traits = std::move(theirs);
}

Result<OldObj> withPlans(ObjMaps maps) {
  OldObj out;
  out.maps = std::move(maps);
  Result<std::vector<ImageTraits>> traits = traitsOfAll(out.maps);
  if (!traits.ok()) return traits.status();
  dropUnused(out.maps, traits.value());
  out.plans = planObj(out.maps, traits.value());
  if (Status s = out.images.take(out.maps.images); !s.ok()) return s;
  return out;
}

}  // namespace

Result<OldObj> readOldObj(std::string_view bytes, const PolygonMesh& mesh,
                          const ReadResource& readResource) {
  Result<ObjMaps> maps = readObjMaps(bytes, mesh, readResource);
  if (!maps.ok()) return maps.status();
  return withPlans(std::move(maps).value());
}

Result<OldObj> readOldPly(std::string_view bytes, const PolygonMesh& mesh,
                          const ReadResource& readResource) {
  Result<Appearance> look = readAppearance(bytes, MeshFormat::Ply, mesh, readResource);
  if (!look.ok()) return look.status();
  ObjMaps maps;
  maps.images = std::move(look.value().images);
  for (const MaterialLook& material : look.value().materials) {
    MtlMap colour;
    colour.name = "diffuse";
    colour.meaning = MtlMeaning::Colour;
    colour.image = material.image;
    maps.materials.push_back({colour});
  }
  return withPlans(std::move(maps));
}

}  // namespace abflat::cli
