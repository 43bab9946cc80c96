#include "commands/obj_run.h"

#include <chrono>
#include <filesystem>
#include <set>
#include <utility>

#include "baking/bake_made_gltf.h"
#include "files/file_format.h"
#include "files/out_of_memory.h"
#include "files/paths.h"

namespace abflat::cli {

namespace fs = std::filesystem;

ObjRun::ObjRun(const std::string& output, const BakeOptionValues& options,
               std::vector<std::string> others)
    : beside_(output),
      isGltf_(writtenFormat(output) == FileFormat::Gltf),
      options_(options),
      others_(std::move(others)) {}

/// Of the files beside the OBJ. A map with alpha may turn out to be a PNG.
std::vector<std::string> ObjRun::names() const {
  std::vector<std::string> out = {beside_.stem() + ".mtl"};
  for (const ObjPlan& plan : old_->plans.plans)
    for (const ImageFormat format : {options_.imageFormat, ImageFormat::Png})
      out.push_back(objImageName(beside_.stem(), plan, format));
  return out;
}

Status ObjRun::read(const InputFile& input) {
  std::vector<std::string> used = others_;
  const fs::path folder = fs::path(input.path).parent_path();
  const ReadResource readResource = [&](const std::string& name) {
    used.push_back((folder / name).string());
    return input.readResource(name);
  };
  Result<OldObj> old = orOutOfMemory(inputName(input.path), [&] {
    return (input.format == FileFormat::Ply ? readOldPly : readOldObj)(input.bytes, input.mesh,
                                                                       readResource);
  });
  if (!old.ok()) return old.status();
  old_ = std::move(old).value();
  return isBeside() ? beside_.check(names(), used) : Status{};
}

Status ObjRun::bake(InputFile& input, const NewLayout& layout,
                    const std::vector<std::uint32_t>& triangleCorners) {
  const auto start = std::chrono::steady_clock::now();
  ObjBaker baker(*old_, input.mesh, layout, triangleCorners, options_, input.look.colors);
  Status status = isGltf_ ? bakeMadeGltf(*old_, baker, options_.imageFormat, input.look,
                                         new_.report, new_.notes)
                          : bakeBeside(baker);
  new_.report.materials = old_->maps.materials.size();
  new_.report.images = old_->images.count();
  noteDepth();
  if (isEmpty() && new_.report.maps.empty())
    new_.notes.emplace_back(isGltf_ ? "nothing was baked: no material of the mesh has a texture, "
                                      "and no vertex has a colour"
                                    : "nothing was baked: no material of the mesh has a texture");
  new_.report.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return status;
}

/// Images of heights keep their bits.
void ObjRun::noteDepth() {
  std::set<std::size_t> lost;
  for (const ObjPlan& plan : old_->plans.plans) {
    if (plan.bits > 8 && !isGltf_ && options_.imageFormat == ImageFormat::Png) continue;
    for (const std::optional<ObjUse>& use : plan.uses)
      if (use && old_->images.deep().count(use->image) > 0) lost.insert(use->image);
  }
  if (const std::string note = depthNote(lost.size()); !note.empty()) new_.notes.push_back(note);
}

Status ObjRun::bakeBeside(ObjBaker& baker) {
  Result<NewObj> result = bakeObj(*old_, baker, beside_.stem(), options_.imageFormat);
  if (!result.ok()) return result.status();
  new_ = std::move(result).value();
  return {};
}

std::string ObjRun::named(std::string obj) const {
  return isBeside() ? withMtl(obj, beside_.stem() + ".mtl") : std::move(obj);
}

Status ObjRun::write(std::vector<OutputFile*>& files) {
  if (!isBeside()) return {};
  std::vector<ImageFile> contents = std::move(new_.images);
  contents.push_back({beside_.stem() + ".mtl", {}, std::move(new_.mtl)});
  return beside_.write(std::move(contents), files);
}

}  // namespace abflat::cli
