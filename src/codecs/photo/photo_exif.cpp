#include "codecs/photo/photo_exif.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>

#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"

namespace sfumato::codecs {
namespace {

constexpr std::uint32_t kMagic = 42;
constexpr std::size_t kEntryBytes = 12;
constexpr std::uint32_t kOrientationTag = 0x0112;
constexpr std::uint32_t kShortType = 3;

/// Reads the numbers of a TIFF structure, the format of EXIF data.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes)
      : bytes_(bytes), is_big_endian_(!bytes.empty() && bytes[0] == 'M') {}

  bool has(std::size_t at, std::size_t count) const {
    return at <= bytes_.size() && count <= bytes_.size() - at;
  }
  /// Precondition: has(at, byte_count).
  std::uint32_t number(std::size_t at, std::size_t byte_count) const {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < byte_count; ++i) {
      number = number << 8 | bytes_[at + (is_big_endian_ ? i : byte_count - 1 - i)];
    }
    return number;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  bool is_big_endian_;
};

/// Maps the pixel (x, y) of a picture of this size to its index in the upright picture.
struct Placement {
  std::ptrdiff_t first, per_x, per_y;
};

Placement placement(Orientation orientation, std::ptrdiff_t width, std::ptrdiff_t height) {
  switch (orientation) {
    case 2:
      return {width - 1, -1, width};
    case 3:
      return {width * height - 1, -1, -width};
    case 4:
      return {(height - 1) * width, 1, -width};
    case 5:
      return {0, height, 1};
    case 6:
      return {height - 1, height, -1};
    case 7:
      return {width * height - 1, -height, -1};
    case 8:
      return {(width - 1) * height, -height, 1};
    default:
      return {0, 1, width};
  }
}

}  // namespace

std::optional<Orientation> exif_orientation(std::span<const std::uint8_t> exif) {
  if (exif.size() >= kExifName.size() &&
      std::memcmp(exif.data(), kExifName.data(), kExifName.size()) == 0) {
    exif = exif.subspan(kExifName.size());
  }
  const Reader reader(exif);
  const bool has_order =
      exif.size() >= 8 && exif[0] == exif[1] && (exif[0] == 'M' || exif[0] == 'I');
  if (!has_order || reader.number(2, 2) != kMagic) return std::nullopt;
  const std::size_t table = reader.number(4, 4);
  if (!reader.has(table, 2)) return std::nullopt;
  const std::size_t entry_count = reader.number(table, 2);
  for (std::size_t i = 0; i < entry_count; ++i) {
    const std::size_t entry = table + 2 + i * kEntryBytes;
    if (!reader.has(entry, kEntryBytes)) return std::nullopt;
    if (reader.number(entry, 2) != kOrientationTag) continue;
    const std::uint32_t value = reader.number(entry + 8, 2);
    const bool is_known = reader.number(entry + 2, 2) == kShortType && value >= 1 && value <= 8;
    return is_known ? std::optional(static_cast<Orientation>(value)) : std::nullopt;
  }
  return 1;
}

Status stand_upright(const Context& context, Orientation orientation, Image& image) {
  if (orientation <= 1 || orientation > 8) return ok_status();
  ScopedCharge held;
  SFUMATO_TRY(held.add(context, capacity_bytes(image.bytes), "a photo"));
  TableMemory memory("a photo");
  std::vector<std::uint8_t> turned;
  SFUMATO_TRY(memory.resize(context, turned, image.bytes.size()));
  const Placement to = placement(orientation, image.width, image.height);
  const std::size_t pixel_bytes = image.row_bytes() / static_cast<std::size_t>(image.width);
  for (int y = 0; y < image.height; ++y) {
    if (context.cancelled()) return context.cancel_status();
    const std::uint8_t* from = &image.bytes[image.row_bytes() * static_cast<std::size_t>(y)];
    for (int x = 0; x < image.width; ++x, from += pixel_bytes) {
      const std::ptrdiff_t pixel = to.first + to.per_x * x + to.per_y * y;
      std::memcpy(&turned[pixel_bytes * static_cast<std::size_t>(pixel)], from, pixel_bytes);
    }
  }
  image.bytes = std::move(turned);
  if (orientation >= 5) std::swap(image.width, image.height);
  return ok_status();
}

}  // namespace sfumato::codecs
