#include <png.h>

#include <array>
#include <cstring>
#include <memory>

#include "images/codecs.h"

namespace abflat::images {
namespace {

// libpng reports an error by jumping back to setjmp. So each function with setjmp calls nothing but
// libpng, and has no object with a destructor.

struct Png {
  std::string_view bytes;  ///< still to be read
  std::string* written = nullptr;
  std::array<char, 80> problem{};
  png_structp png = nullptr;
  png_infop info = nullptr;
};

[[noreturn]] void onError(png_structp png, png_const_charp text) {
  auto* const state = static_cast<Png*>(png_get_error_ptr(png));
  std::strncpy(state->problem.data(), text, state->problem.size() - 1);
  png_longjmp(png, 1);
}

void onWarning(png_structp, png_const_charp) {}

void takeBytes(png_structp png, png_bytep to, std::size_t size) {
  auto* const state = static_cast<Png*>(png_get_io_ptr(png));
  if (size > state->bytes.size()) png_error(png, "it ends too early");
  std::memcpy(to, state->bytes.data(), size);
  state->bytes.remove_prefix(size);
}

void putBytes(png_structp png, png_bytep from, std::size_t size) {
  auto* const state = static_cast<Png*>(png_get_io_ptr(png));
  bool isWritten = true;
  try {
    state->written->append(reinterpret_cast<const char*>(from), size);
  } catch (...) {
    isWritten = false;  // nothing may be thrown through C
  }
  if (!isWritten) png_error(png, "there is not enough memory");
}

void flush(png_structp) {}

struct FreeWriter {
  void operator()(Png* state) const { png_destroy_write_struct(&state->png, &state->info); }
};

bool readHeader(Png& state) {
  if (setjmp(png_jmpbuf(state.png))) return false;
  png_set_user_limits(state.png, 0x7fffffff, 0x7fffffff);  // checkedSize has its own
  png_set_read_fn(state.png, &state, takeBytes);
  png_read_info(state.png, state.info);
  return true;
}

bool isLittleEndian() {
  constexpr std::uint16_t kOne = 1;
  return *reinterpret_cast<const std::uint8_t*>(&kOne) == 1;
}

/// Asks for 8 or 16 bits a channel, without a palette.
bool expand(Png& state) {
  if (setjmp(png_jmpbuf(state.png))) return false;
  png_set_expand(state.png);
  if (isLittleEndian()) png_set_swap(state.png);
  png_set_interlace_handling(state.png);
  png_read_update_info(state.png, state.info);
  return true;
}

bool readRows(Png& state, png_bytepp rows) {
  if (setjmp(png_jmpbuf(state.png))) return false;
  png_read_image(state.png, rows);
  png_read_end(state.png, nullptr);
  return true;
}

bool writeAll(Png& state, const Image& image, int colour, png_bytepp rows) {
  if (setjmp(png_jmpbuf(state.png))) return false;
  png_set_write_fn(state.png, &state, putBytes, flush);
  png_set_IHDR(state.png, state.info, image.width, image.height, image.bits, colour,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(state.png, state.info);
  if (image.bits == 16 && isLittleEndian()) png_set_swap(state.png);
  png_write_image(state.png, rows);
  png_write_end(state.png, nullptr);
  return true;
}

std::vector<png_bytep> rowsOf(std::uint8_t* pixels, std::uint32_t height, std::size_t rowBytes) {
  std::vector<png_bytep> out(height);
  for (std::size_t y = 0; y < height; ++y) out[y] = pixels + y * rowBytes;
  return out;
}

class PngReader {
 public:
  explicit PngReader(std::string_view bytes) {
    state_.bytes = bytes;
    state_.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &state_, onError, onWarning);
    if (state_.png) state_.info = png_create_info_struct(state_.png);
  }
  ~PngReader() { png_destroy_read_struct(&state_.png, &state_.info, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  Result<Size> readSize() {
    if (!state_.info) throw std::bad_alloc();
    if (!readHeader(state_)) return problem();
    return checkedSize(png_get_image_width(state_.png, state_.info),
                       png_get_image_height(state_.png, state_.info));
  }

  /// To be called once the size is known.
  Result<Image> readPixels(Size size) {
    if (!expand(state_)) return problem();
    Image out = blank(size, png_get_channels(state_.png, state_.info),
                      png_get_bit_depth(state_.png, state_.info));
    std::vector<png_bytep> rows =
        rowsOf(out.pixels.data(), size.height, png_get_rowbytes(state_.png, state_.info));
    if (!readRows(state_, rows.data())) return problem();
    return out;
  }

 private:
  Status problem() const {
    return damaged(std::string("is a damaged PNG: ") + state_.problem.data() + ". Export it again");
  }

  Png state_;
};

}  // namespace

Result<Size> sizeOfPng(std::string_view bytes) {
  PngReader reader(bytes);
  return reader.readSize();
}

Result<Image> readPng(std::string_view bytes) {
  PngReader reader(bytes);
  const Result<Size> size = reader.readSize();
  if (!size.ok()) return size.status();
  return reader.readPixels(size.value());
}

Result<std::string> writePng(const Image& image) {
  std::string out;
  Png state;
  state.written = &out;
  state.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &state, onError, onWarning);
  const std::unique_ptr<Png, FreeWriter> owner(&state);
  if (state.png) state.info = png_create_info_struct(state.png);
  if (!state.info) throw std::bad_alloc();
  constexpr std::array<int, 4> kColours = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA,
                                           PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGB_ALPHA};
  const auto channels = static_cast<std::size_t>(image.channels);
  const std::size_t rowBytes = image.width * channels * static_cast<std::size_t>(image.bits / 8);
  // libpng only reads them, but its rows are not const.
  std::vector<png_bytep> rows =
      rowsOf(const_cast<std::uint8_t*>(image.pixels.data()), image.height, rowBytes);
  if (!writeAll(state, image, kColours[channels - 1], rows.data()))
    return cannotWrite(std::string("cannot write a PNG: ") + state.problem.data());
  return out;
}

}  // namespace abflat::images
