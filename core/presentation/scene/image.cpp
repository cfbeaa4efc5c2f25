#include "core/presentation/scene/image.h"

#include <png.h>

#include <csetjmp>
#include <cstring>

namespace geargraph {
namespace {

constexpr int kLevel = 3;  // without filters a third of the time, and with flat faces the same size

/// Where a file's bytes go: memory that is large enough for any compression of the picture.
struct Room {
  std::uint8_t* next = nullptr;
  std::uint8_t* end = nullptr;
};

void append(png_structp png, png_bytep bytes, png_size_t count) {
  auto* room = static_cast<Room*>(png_get_io_ptr(png));
  if (count > static_cast<png_size_t>(room->end - room->next)) png_error(png, "no room");
  std::memcpy(room->next, bytes, count);
  room->next += count;
}

void fail(png_structp png, png_const_charp) {
  png_longjmp(png, 1);
}

void ignore(png_structp, png_const_charp) {}

struct Writer {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;

  Writer() = default;
  ~Writer() { png_destroy_write_struct(&png, &info); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
};

/// False where libpng fails or `stop` was requested. libpng jumps back here, past no object with a
/// destructor.
bool write(const Writer& writer, Room* room, const Image& image, const std::stop_token& stop) {
  if (setjmp(png_jmpbuf(writer.png)) != 0) return false;
  png_set_write_fn(writer.png, room, append, nullptr);
  png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), 8, PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_BASE, PNG_FILTER_TYPE_BASE);
  png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(writer.png, writer.info);
  png_set_filter(writer.png, PNG_FILTER_TYPE_BASE, PNG_NO_FILTERS);
  png_set_compression_level(writer.png, kLevel);
  const std::uint8_t* const end = image.rgba.data() + image.rgba.size();
  for (const std::uint8_t* row = image.rgba.data(); row != end; row += std::ptrdiff_t{4} * image.width) {
    if (stop.stop_requested()) return false;
    png_write_row(writer.png, row);
  }
  png_write_end(writer.png, writer.info);
  return true;
}

}  // namespace

std::vector<std::uint8_t> pngBytes(const Image& image, const std::stop_token& stop) {
  if (image.rgba.empty()) return {};
  png_image header{};
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGBA;
  const Writer writer;
  if (writer.info == nullptr) return {};
  std::vector<std::uint8_t> bytes(PNG_IMAGE_PNG_SIZE_MAX(header));
  Room room{bytes.data(), bytes.data() + bytes.size()};
  if (!write(writer, &room, image, stop)) return {};
  bytes.resize(static_cast<std::size_t>(room.next - bytes.data()));
  return bytes;
}

}  // namespace geargraph
