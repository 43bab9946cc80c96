#include <turbojpeg.h>

#include <array>
#include <memory>

#include "images/codecs.h"

namespace abflat::images {
namespace {

struct CloseJpeg {
  void operator()(void* handle) const { tjDestroy(handle); }
};
using JpegHandle = std::unique_ptr<void, CloseJpeg>;

struct FreeJpeg {
  void operator()(unsigned char* bytes) const { tjFree(bytes); }
};

class JpegReader {
 public:
  explicit JpegReader(std::string_view bytes)
      : handle_(tjInitDecompress()),
        data_(reinterpret_cast<const unsigned char*>(bytes.data())),
        length_(bytes.size()) {}

  Result<Size> readSize() {
    if (!handle_) throw std::bad_alloc();
    int width = 0, height = 0, sampling = 0;
    if (tjDecompressHeader3(handle_.get(), data_, length_, &width, &height, &sampling, &colours_))
      return problem();
    if (colours_ == TJCS_CMYK || colours_ == TJCS_YCCK)
      return damaged("is a JPEG for print, with CMYK colours. Save it with RGB colours");
    return checkedSize(static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height));
  }

  /// To be called once the size is known.
  Result<Image> readPixels(Size size) {
    const bool isGrey = colours_ == TJCS_GRAY;
    Image out = blank(size, isGrey ? 1 : 3);
    // What is only half there would look like a texture. Many scans take long for few bytes.
    constexpr int kFlags = TJFLAG_ACCURATEDCT | TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS;
    if (tjDecompress2(handle_.get(), data_, length_, out.pixels.data(),
                      static_cast<int>(size.width), 0, static_cast<int>(size.height),
                      isGrey ? TJPF_GRAY : TJPF_RGB, kFlags))
      return problem();
    return out;
  }

 private:
  Status problem() const {
    return damaged(std::string("is a damaged JPEG: ") + tjGetErrorStr2(handle_.get()) +
                   ". Export it again");
  }

  JpegHandle handle_;
  const unsigned char* data_;
  unsigned long length_;
  int colours_ = 0;
};

}  // namespace

Result<Size> sizeOfJpeg(std::string_view bytes) { return JpegReader(bytes).readSize(); }

Result<Image> readJpeg(std::string_view bytes) {
  JpegReader reader(bytes);
  const Result<Size> size = reader.readSize();
  if (!size.ok()) return size.status();
  return reader.readPixels(size.value());
}

Result<std::string> writeJpeg(const Image& image, int quality) {
  const JpegHandle handle(tjInitCompress());
  if (!handle) throw std::bad_alloc();
  const bool isGrey = image.channels == 1;
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  const int failed =
      tjCompress2(handle.get(), image.pixels.data(), static_cast<int>(image.width), 0,
                  static_cast<int>(image.height), isGrey ? TJPF_GRAY : TJPF_RGB, &bytes, &size,
                  isGrey ? TJSAMP_GRAY : TJSAMP_444, quality, TJFLAG_ACCURATEDCT);
  const std::unique_ptr<unsigned char, FreeJpeg> owner(bytes);
  if (failed)
    return cannotWrite(std::string("cannot write a JPEG: ") + tjGetErrorStr2(handle.get()));
  return std::string(reinterpret_cast<const char*>(bytes), size);
}

}  // namespace abflat::images
