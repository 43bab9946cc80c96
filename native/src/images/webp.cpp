#include <webp/decode.h>
#include <webp/encode.h>

#include "images/codecs.h"

namespace abflat::images {
namespace {

constexpr int kMostQuality = 100;

Status webpProblem(VP8StatusCode code) {
  if (code == VP8_STATUS_OUT_OF_MEMORY) throw std::bad_alloc();
  const bool isShort = code == VP8_STATUS_NOT_ENOUGH_DATA || code == VP8_STATUS_SUSPENDED;
  return damaged(std::string("is a damaged WebP") + (isShort ? ": it ends too early" : "") +
                 ". Export it again");
}

Result<Size> readFeatures(std::string_view bytes, WebPBitstreamFeatures& out) {
  const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  const VP8StatusCode code = WebPGetFeatures(data, bytes.size(), &out);
  if (code != VP8_STATUS_OK) return webpProblem(code);
  if (out.has_animation) return damaged("is an animated WebP. Save one of its pictures");
  return checkedSize(static_cast<std::uint64_t>(out.width), static_cast<std::uint64_t>(out.height));
}

/// Grey as three channels, which is what the encoder takes.
std::vector<std::uint8_t> threefold(const std::vector<std::uint8_t>& grey) {
  std::vector<std::uint8_t> out;
  out.reserve(3 * grey.size());
  for (const std::uint8_t value : grey) out.insert(out.end(), 3, value);
  return out;
}

class WebpWriter {
 public:
  WebpWriter() {
    WebPMemoryWriterInit(&memory_);
    isReady_ = WebPPictureInit(&picture_) != 0;
  }
  ~WebpWriter() {
    WebPPictureFree(&picture_);
    WebPMemoryWriterClear(&memory_);
  }
  WebpWriter(const WebpWriter&) = delete;
  WebpWriter& operator=(const WebpWriter&) = delete;

  bool write(const Image& image, const WebPConfig& config) {
    if (!isReady_) return false;
    picture_.width = static_cast<int>(image.width);
    picture_.height = static_cast<int>(image.height);
    picture_.use_argb = config.lossless;
    picture_.writer = WebPMemoryWrite;
    picture_.custom_ptr = &memory_;
    return import(image) && WebPEncode(&config, &picture_);
  }
  bool lacksMemory() const {
    return picture_.error_code == VP8_ENC_ERROR_OUT_OF_MEMORY ||
           picture_.error_code == VP8_ENC_ERROR_BITSTREAM_OUT_OF_MEMORY;
  }
  std::string bytes() const { return {reinterpret_cast<const char*>(memory_.mem), memory_.size}; }

 private:
  bool import(const Image& image) {
    if (image.channels == 4)
      return WebPPictureImportRGBA(&picture_, image.pixels.data(), 4 * picture_.width);
    const bool isGrey = image.channels == 1;
    const std::vector<std::uint8_t> grey =
        isGrey ? threefold(image.pixels) : std::vector<std::uint8_t>();
    return WebPPictureImportRGB(&picture_, isGrey ? grey.data() : image.pixels.data(),
                                3 * picture_.width);
  }

  WebPPicture picture_{};
  WebPMemoryWriter memory_{};
  bool isReady_ = false;
};

}  // namespace

Result<Size> sizeOfWebp(std::string_view bytes) {
  WebPBitstreamFeatures features;
  return readFeatures(bytes, features);
}

Result<Image> readWebp(std::string_view bytes) {
  WebPBitstreamFeatures features;
  const Result<Size> size = readFeatures(bytes, features);
  if (!size.ok()) return size.status();
  Image out = blank(size.value(), features.has_alpha ? 4 : 3);
  WebPDecoderConfig config;
  if (!WebPInitDecoderConfig(&config)) return damaged("cannot be read by this version of libwebp");
  config.output.colorspace = features.has_alpha ? MODE_RGBA : MODE_RGB;
  config.output.is_external_memory = 1;
  config.output.u.RGBA = {out.pixels.data(), features.width * out.channels, out.pixels.size()};
  const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  const VP8StatusCode code = WebPDecode(data, bytes.size(), &config);
  WebPFreeDecBuffer(&config.output);
  if (code != VP8_STATUS_OK) return webpProblem(code);
  return out;
}

Result<std::string> writeWebp(const Image& image, int quality) {
  if (image.width > WEBP_MAX_DIMENSION || image.height > WEBP_MAX_DIMENSION)
    return cannotWrite("a WebP has at most 16383 pixels a side. Use PNG or a lower resolution");
  WebPConfig config;
  if (!WebPConfigInit(&config)) return cannotWrite("cannot write with this version of libwebp");
  config.quality = static_cast<float>(quality);
  config.lossless = quality == kMostQuality;
  config.exact = 1;  // colours that are transparent are needed where texels are mixed
  if (config.lossless) config.quality = 75;  // here the effort
  WebpWriter writer;
  if (writer.write(image, config)) return writer.bytes();
  if (writer.lacksMemory()) throw std::bad_alloc();
  return cannotWrite("cannot write a WebP");
}

}  // namespace abflat::images
