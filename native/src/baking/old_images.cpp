#include "baking/old_images.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace abflat::cli {
namespace {

/// What all images may have together: many of a single colour could fill any memory.
constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 29;
/// Or as many times the bytes of their files, if that is more.
constexpr std::uint64_t kMostExpansion = 1024;

std::size_t pixelCount(const images::Image& image) {
  return std::size_t{image.width} * image.height;
}

/// An image of the first channels of another.
images::Image firstChannels(const images::Image& from, int channels) {
  images::Image out{from.width, from.height, channels, from.bits, {}};
  const auto was = static_cast<std::size_t>(from.channels * from.bits / 8);
  const auto is = static_cast<std::size_t>(channels * from.bits / 8);
  out.pixels.resize(pixelCount(from) * is);
  for (std::size_t i = 0; i < pixelCount(from); ++i)
    std::memcpy(&out.pixels[i * is], &from.pixels[i * was], is);
  return out;
}

template <class Number>
void fade(images::Image& image, double strength, double most) {
  for (std::size_t i = 0; i < pixelCount(image); ++i) {
    Number value;
    std::memcpy(&value, &image.pixels[i * sizeof value], sizeof value);
    value = static_cast<Number>(std::lround(most - strength * (most - value)));
    std::memcpy(&image.pixels[i * sizeof value], &value, sizeof value);
  }
}

}  // namespace

Status OldImages::take(std::vector<ImageFile>& files) {
  std::uint64_t pixels = 0, bytes = 0;
  for (const ImageFile& file : files) {
    const Result<images::Size> size = images::imageSize(file.bytes, file.name);
    if (!size.ok()) return size.status();
    sizes_.push_back(size.value());
    pixels += size.value().pixels();
    bytes += file.bytes.size();
    if (pixels > std::max(kMostPixels, kMostExpansion * bytes))
      return {StatusCode::ParseError,
              file.name + " brings the images to " + std::to_string(pixels) + " pixels from " +
                  std::to_string(bytes) + " bytes, which is too many. Make them smaller"};
  }
  files_ = std::move(files);
  return {};
}

Result<ImageView> OldImages::whole(std::size_t image) {
  if (const auto known = whole_.find(image); known != whole_.end()) return known->second.view();
  Result<images::Image> read = images::readImage(files_[image].bytes, files_[image].name);
  if (!read.ok()) return read.status();
  if (read.value().bits > 8) deep_.insert(image);
  return whole_.emplace(image, std::move(read.value())).first->second.view();
}

Result<ImageView> OldImages::opaque(std::size_t image) {
  Result<ImageView> view = whole(image);
  if (!view.ok() || view.value().channels % 2 == 1) return view;
  const auto [place, isNew] = opaque_.try_emplace(image);
  if (isNew) place->second = firstChannels(whole_.at(image), view.value().channels - 1);
  return place->second.view();
}

Result<ImageView> OldImages::occlusion(std::size_t image, double strength) {
  Result<ImageView> view = whole(image);
  if (!view.ok()) return view;
  const auto [place, isNew] = occlusion_.try_emplace({image, strength});
  images::Image& out = place->second;
  if (!isNew) return out.view();
  out = firstChannels(whole_.at(image), 1);
  if (out.bits == 8)
    fade<std::uint8_t>(out, strength, 255);
  else
    fade<std::uint16_t>(out, strength, 65535);
  return out.view();
}

std::string depthNote(std::size_t count) {
  if (count == 0) return {};
  return (count == 1 ? "1 image has" : std::to_string(count) + " images have") +
         " 16 bits per channel, of which the new ones have 8";
}

void OldImages::release() {
  whole_.clear();
  opaque_.clear();
  occlusion_.clear();
}

}  // namespace abflat::cli
