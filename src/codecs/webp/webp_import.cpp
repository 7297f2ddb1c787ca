#include "codecs/webp/webp_import.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstring>

#include "base/owned.hpp"
#include "base/parallel.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"

namespace sfumato::codecs {
namespace {

/// A part of this side takes 10 ms.
constexpr int kPartSide = 512;
/// The pixels around a part that the conversion reads. Each round reads two pixels farther than the
/// round before; the margin is a whole number of chroma pixels.
constexpr int kMargin = 16;
/// The memory of a part with its margins: ARGB, planes, and twice two tables of 16 bits and
/// half-sized ones.
constexpr std::size_t kBytesPerPixel = 4 + 3 + 14;

/// Pixels [x0, x1) × [y0, y1).
struct Part {
  int x0, y0, x1, y1;
};

Status no_memory() {
  return make_error(StatusCode::out_of_memory, "no memory to write the WebP image");
}

bool is_opaque(const Image& image, int y) {
  const std::uint8_t* const row = &image.bytes[image.row_bytes() * static_cast<std::size_t>(y)];
  for (int x = 0; x < image.width; ++x) {
    if (row[4 * x + 3] != 255) return false;
  }
  return true;
}

/// Errors: cancelled.
Result<bool> is_opaque(const Context& context, const Image& image) {
  if (channel_count(image.format) != 4) return true;
  RarePoll<64> poll(context);
  for (int y = 0; y < image.height; ++y) {
    if (poll.cancelled()) return context.cancel_status();
    if (!is_opaque(image, y)) return false;
  }
  return true;
}

/// Copies the pixels from (`from_x`, `from_y`) on in a plane of the part to the whole plane.
void copy_plane(const std::uint8_t* from, int from_stride, const Part& at, int from_x, int from_y,
                std::uint8_t* to, int to_stride) {
  const auto width = static_cast<std::size_t>(at.x1 - at.x0);
  for (int y = at.y0; y < at.y1; ++y) {
    const std::ptrdiff_t row = from_y + y - at.y0;
    std::memcpy(to + std::ptrdiff_t{to_stride} * y + at.x0,
                from + std::ptrdiff_t{from_stride} * row + from_x, width);
  }
}

void copy_planes(const WebPPicture& from, const Part& part, int from_x, int from_y,
                 WebPPicture& to) {
  const Part half{part.x0 / 2, part.y0 / 2, (part.x1 + 1) / 2, (part.y1 + 1) / 2};
  copy_plane(from.y, from.y_stride, part, from_x, from_y, to.y, to.y_stride);
  copy_plane(from.u, from.uv_stride, half, from_x / 2, from_y / 2, to.u, to.uv_stride);
  copy_plane(from.v, from.uv_stride, half, from_x / 2, from_y / 2, to.v, to.uv_stride);
  if (!to.a) return;
  if (from.a) {
    copy_plane(from.a, from.a_stride, part, from_x, from_y, to.a, to.a_stride);
    return;
  }
  for (int y = part.y0; y < part.y1; ++y) {
    std::memset(to.a + std::ptrdiff_t{to.a_stride} * y + part.x0, 255,
                static_cast<std::size_t>(part.x1 - part.x0));
  }
}

/// Converts one part. Returns false if libwebp has no memory for it.
bool convert(const Image& image, const Part& part, WebPPicture& whole) {
  const Part seen{std::max(0, part.x0 - kMargin), std::max(0, part.y0 - kMargin),
                  std::min(image.width, part.x1 + kMargin),
                  std::min(image.height, part.y1 + kMargin)};
  WebPPicture picture;
  WebPPictureInit(&picture);
  const Owned<WebPPicture, WebPPictureFree> guard(&picture);
  picture.use_argb = 1;
  picture.width = seen.x1 - seen.x0;
  picture.height = seen.y1 - seen.y0;
  const auto channels = static_cast<std::size_t>(channel_count(image.format));
  const std::uint8_t* const pixels = image.bytes.data() +
                                     image.row_bytes() * static_cast<std::size_t>(seen.y0) +
                                     channels * static_cast<std::size_t>(seen.x0);
  const int stride = static_cast<int>(image.row_bytes());
  const int is_imported = channels == 4 ? WebPPictureImportRGBA(&picture, pixels, stride)
                                        : WebPPictureImportRGB(&picture, pixels, stride);
  if (!is_imported || !WebPPictureSharpARGBToYUVA(&picture)) return false;
  copy_planes(picture, part, part.x0 - seen.x0, part.y0 - seen.y0, whole);
  return true;
}

}  // namespace

std::size_t import_bytes(int thread_count) {
  constexpr std::size_t side = kPartSide + 2 * kMargin;
  return static_cast<std::size_t>(thread_count) * side * side * kBytesPerPixel;
}

Status import_argb(Context& context, const Image& image, WebPPicture& picture) {
  picture.use_argb = 1;
  if (!WebPPictureAlloc(&picture)) return no_memory();
  const auto channels = static_cast<std::size_t>(channel_count(image.format));
  RarePoll<64> poll(context);
  for (int y = 0; y < image.height; ++y) {
    if (poll.cancelled()) return context.cancel_status();
    const std::uint8_t* from = &image.bytes[image.row_bytes() * static_cast<std::size_t>(y)];
    std::uint32_t* const to = picture.argb + std::ptrdiff_t{picture.argb_stride} * y;
    for (int x = 0; x < image.width; ++x, from += channels) {
      const std::uint32_t alpha = channels == 4 ? from[3] : 255;
      to[x] = alpha << 24 | std::uint32_t{from[0]} << 16 | std::uint32_t{from[1]} << 8 | from[2];
    }
  }
  return ok_status();
}

Status import_yuv(Context& context, const Image& image, WebPPicture& picture) {
  SFUMATO_TRY_ASSIGN(const bool opaque, is_opaque(context, image));
  picture.use_argb = 0;
  picture.colorspace = opaque ? WEBP_YUV420 : WEBP_YUV420A;
  if (!WebPPictureAlloc(&picture)) return no_memory();
  const int columns = (image.width + kPartSide - 1) / kPartSide;
  const int rows = (image.height + kPartSide - 1) / kPartSide;
  std::atomic<bool> has_memory{true};
  SFUMATO_TRY(parallel_for(context,
                           static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 1,
                           [&](std::size_t begin, std::size_t) {
                             const int x = static_cast<int>(begin) % columns * kPartSide;
                             const int y = static_cast<int>(begin) / columns * kPartSide;
                             const Part part{x, y, std::min(image.width, x + kPartSide),
                                             std::min(image.height, y + kPartSide)};
                             if (!convert(image, part, picture)) has_memory = false;
                           }));
  return has_memory ? ok_status() : no_memory();
}

}  // namespace sfumato::codecs
