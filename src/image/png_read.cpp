// PNG out of memory, by libpng.
//
// Its errors leave by longjmp, over frames of C and of the plain functions below alone: nothing with a
// destructor lives between setjmp and longjmp. Chunks that change no pixel are not even parsed.
#include <png.h>

#include <algorithm>
#include <bit>
#include <csetjmp>
#include <cstring>

#include "image/picture_read.h"

namespace blysk {
namespace {

static_assert(std::endian::native == std::endian::little,
              "rows are decoded into pixels, red in the low byte");

constexpr std::size_t kSignature = 8;
// Deflate makes of one byte at most 1032; so much more can a header not promise.
constexpr std::uint64_t kMostInflated = 1032;

// libpng's state, and where it reads. Destroyed outside of all that may jump.
struct Decoder {
  explicit Decoder(std::span<const std::byte> all) : bytes(all) {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning);
    if (png != nullptr) info = png_create_info_struct(png);
    if (info == nullptr) std::strcpy(message, "not enough memory to decode it");
  }
  ~Decoder() { png_destroy_read_struct(&png, &info, nullptr); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  [[noreturn]] static void on_error(png_structp png, png_const_charp words) {
    auto* self = static_cast<Decoder*>(png_get_error_ptr(png));
    std::strncpy(self->message, words, sizeof self->message - 1);
    png_longjmp(png, 1);
  }
  static void on_warning(png_structp, png_const_charp) {}

  static void on_read(png_structp png, png_bytep to, std::size_t count) {
    auto* self = static_cast<Decoder*>(png_get_io_ptr(png));
    if (self->bytes.size() - self->at < count) png_error(png, "the file ends in the middle");
    std::memcpy(to, self->bytes.data() + self->at, count);
    self->at += count;
  }

  std::span<const std::byte> bytes;
  std::size_t at = 0;
  png_structp png = nullptr;
  png_infop info = nullptr;
  Image* image = nullptr;
  char message[120] = {};
};

// Runs a step that has no destructors; false where libpng gave up, with its words in the decoder.
bool attempt(Decoder& decoder, void (*step)(Decoder&)) {
  if (setjmp(png_jmpbuf(decoder.png)) != 0) return false;
  step(decoder);
  return true;
}

void read_header(Decoder& decoder) {
  static constexpr png_byte kIgnored[] =
      "bKGD\0cHRM\0eXIf\0gAMA\0hIST\0iCCP\0iTXt\0oFFs\0pCAL\0pHYs\0sBIT\0sCAL\0sPLT\0sRGB\0sTER\0tEXt\0tIME\0"
      "zTXt";
  png_set_read_fn(decoder.png, &decoder, Decoder::on_read);
  png_set_user_limits(decoder.png, 0x7fffffff, 0x7fffffff);  // ours are asked with better words
  png_set_keep_unknown_chunks(decoder.png, PNG_HANDLE_CHUNK_NEVER, nullptr, 0);
  png_set_keep_unknown_chunks(decoder.png, PNG_HANDLE_CHUNK_NEVER, kIgnored,
                              static_cast<int>(sizeof kIgnored / 5));
  png_read_info(decoder.png, decoder.info);
}

void read_rows(Decoder& decoder) {
  png_set_expand(decoder.png);  // palettes, fewer than eight bits, transparent colours
  png_set_scale_16(decoder.png);
  png_set_gray_to_rgb(decoder.png);
  png_set_add_alpha(decoder.png, 0xff, PNG_FILLER_AFTER);
  const int passes = png_set_interlace_handling(decoder.png);
  png_read_update_info(decoder.png, decoder.info);
  const auto width = static_cast<std::size_t>(decoder.image->width);
  if (png_get_rowbytes(decoder.png, decoder.info) != 4 * width)
    png_error(decoder.png, "unknown kind of pixels");
  for (int pass = 0; pass < passes; ++pass) {
    for (int y = 0; y < decoder.image->height; ++y) {
      std::uint32_t* row = decoder.image->pixels.data() + static_cast<std::size_t>(y) * width;
      png_read_row(decoder.png, reinterpret_cast<png_bytep>(row), nullptr);
    }
  }
  png_read_end(decoder.png, nullptr);
}

Error broken_png(const PictureSource& source, const Decoder& decoder) {
  std::string words = decoder.message;
  std::ranges::replace_if(
      words, [](char c) { return c < ' ' || c > '~'; }, '?');
  return broken_picture(source, "the PNG is broken near byte " + std::to_string(decoder.at) + ": " + words);
}

}  // namespace

bool looks_like_png(std::span<const std::byte> bytes) {
  return bytes.size() >= kSignature &&
         png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, kSignature) == 0;
}

Result<Image> read_png(const PictureSource& source) {
  Decoder decoder(source.bytes);
  if (decoder.info == nullptr) return broken_png(source, decoder);
  if (!attempt(decoder, read_header)) return broken_png(source, decoder);

  const std::uint64_t width = png_get_image_width(decoder.png, decoder.info);
  const std::uint64_t height = png_get_image_height(decoder.png, decoder.info);
  if (const Status status = check_picture_size(source, width, height); !status) return status.error();
  const std::uint64_t inflated = png_get_rowbytes(decoder.png, decoder.info) * height;
  if (inflated / kMostInflated > source.bytes.size()) {
    return broken_picture(source, "the PNG ends in the middle: " + std::to_string(source.bytes.size()) +
                                      " bytes cannot hold " + std::to_string(width) + "x" +
                                      std::to_string(height) + " pixels");
  }
  Image image;
  // Filled, so that no broken file can show what the memory held before.
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  image.pixels.assign(width * height, 0);
  decoder.image = &image;
  if (!attempt(decoder, read_rows)) return broken_png(source, decoder);
  return image;
}

}  // namespace blysk
