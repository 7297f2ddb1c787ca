// JPEG files: baseline, progressive, arithmetic; gray, YCbCr, CMYK.
#include "codecs/image_file.hpp"
#include "codecs/jpeg/jpeg_decode.hpp"
#include "fuzz.hpp"

using namespace sfumato;

namespace {

/// The library itself needs at least two thirds of it.
constexpr std::size_t kJpegBudgetBytes = std::size_t{3} << 19;

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::Bytes file(data, size);
  Context context{.budget = Budget(kJpegBudgetBytes)};
  const Result<codecs::RgbaImage> image = codecs::decode_jpeg(context, file);
  fuzz::require(context.budget.used() == 0, "a decoder keeps what it charged");
  if (!image) {
    fuzz::require_honest(image.status());
    return 0;
  }
  fuzz::require(image->width > 0 && image->height > 0, "an image of no pixels");
  const std::size_t pixels =
      static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height);
  fuzz::require(image->rgba.size() == 4 * pixels, "an image of another size than its bytes");
  for (std::size_t i = 3; i < image->rgba.size(); i += 4) {
    fuzz::require(image->rgba[i] == 255, "a JPEG that can be seen through");
  }
  // Files that begin as JPEG are textures for the library.
  const Result<codecs::RgbaImage> again = codecs::decode_image(context, file);
  fuzz::require(again || data[2] != 0xFF, "a JPEG that is no texture");
  fuzz::require(!again || again->rgba == image->rgba, "the second reading of a file differs");
  return 0;
}
