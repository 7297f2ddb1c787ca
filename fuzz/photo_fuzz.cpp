// Photos: PNG with corrected checksums, JPEG, WebP. Other bytes are EXIF data, or a colour profile
// after a byte that chooses its use.
#include <array>
#include <vector>

#include "codecs/photo/photo.hpp"
#include "codecs/photo/photo_exif.hpp"
#include "codecs/photo/photo_profile.hpp"
#include "fuzz.hpp"
#include "png_file.hpp"

using namespace sfumato;

namespace {

/// Largest side that is decoded: larger images would be slow without running other code.
constexpr std::size_t kSide = 128;

bool is_file(fuzz::Bytes bytes) {
  if (bytes.size() < 3) return false;
  return (bytes[0] == 0xFF && bytes[1] == 0xD8) || (bytes[0] == 'R' && bytes[1] == 'I') ||
         fuzz::is_png(bytes);
}

void read_file(fuzz::Bytes bytes) {
  const fuzz::File file =
      fuzz::is_png(bytes) ? fuzz::with_checksums(bytes) : fuzz::File(bytes.begin(), bytes.end());
  Context context{.budget = Budget(fuzz::kBudgetBytes)};
  context.limits.image_side = kSide;
  std::vector<Diagnostic> warnings;
  const Result<Image> image = codecs::read_photo(context, file, "fuzz.photo", &warnings);
  fuzz::require(context.budget.used() == 0, "a reader keeps what it charged");
  fuzz::require(warnings.size() <= 3, "more warnings than there are things to ignore");
  if (!image) {
    fuzz::require_honest(image.status());
    return;
  }
  fuzz::require(validate(context.limits, *image).ok(), "an image that is not valid");
  const Result<Image> again = codecs::read_photo(context, file, "fuzz.photo");
  fuzz::require_ok(again.status(), "a photo cannot be read twice");
  fuzz::require(again->bytes == image->bytes, "the second reading of a file differs");
}

/// An upright picture keeps its pixels, whatever the orientation.
void read_exif(fuzz::Bytes bytes) {
  const std::optional<codecs::Orientation> orientation = codecs::exif_orientation(bytes);
  fuzz::require(!orientation || (*orientation >= 1 && *orientation <= 8),
                "an orientation that there is not");
  const Context context;
  Image image{2, 1, PixelFormat::rgb8, {1, 1, 1, 2, 2, 2}};
  fuzz::require_ok(codecs::stand_upright(context, orientation.value_or(1), image),
                   "a picture cannot be turned");
  fuzz::require(image.bytes[0] + image.bytes[3] == 3, "a pixel is lost");
  fuzz::require(image.width * image.height == 2, "a picture of another size");
}

void read_profile(unsigned kind, fuzz::Bytes bytes) {
  using codecs::PhotoChannels;
  constexpr std::array<PhotoChannels, 4> kChannels{
      PhotoChannels::gray, PhotoChannels::rgb, PhotoChannels::cmyk, PhotoChannels::cmyk_inverted};
  codecs::PhotoPixels pixels{kChannels[kind % 4], kind % 4 < 2 ? 3 : 4, 1};
  if (kind % 4 < 2) pixels.bytes_per_channel = 1 + static_cast<int>(kind / 4 % 2);
  const Context context{.budget = Budget(fuzz::kBudgetBytes)};
  {
    const Result<codecs::ToSrgb> made = codecs::ToSrgb::by_profile(context, bytes, pixels);
    if (made) {
      std::array<std::uint8_t, 8 * 16> from{};
      for (std::size_t i = 0; i < from.size(); ++i) from[i] = static_cast<std::uint8_t>(29 * i);
      std::array<std::uint8_t, 6 * 16> rgb{};
      made->convert(from.data(), rgb.data(), 16);
    } else {
      fuzz::require_honest(made.status());
    }
  }
  fuzz::require(context.budget.used() == 0, "a profile keeps what it charged");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::Bytes bytes(data, size);
  if (is_file(bytes)) {
    read_file(bytes);
  } else if (size > 0 && data[0] < 8) {
    read_profile(data[0], bytes.subspan(1));
  } else {
    read_exif(bytes);
  }
  return 0;
}
