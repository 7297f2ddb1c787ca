// Picture files. Size and checksum are corrected, because otherwise no changed byte would pass
// them. The result is written again byte for byte, drawn, and exported.
#include <cstring>
#include <vector>

#include "fuzz.hpp"
#include "picture/checksum.hpp"
#include "sfumato/export/glb/glb.hpp"
#include "sfumato/picture/picture_file.hpp"
#include "sfumato/raster/rasterize.hpp"

using namespace sfumato;

namespace {

constexpr std::uint8_t kHeader[] = {'S', 'F', 'P', 'I', 'C', 'T', 0x1a, kPictureFileVersion,
                                    4,   3,   2,   1};
constexpr std::size_t kSizeAt = 12, kChecksumAt = 20, kHeaderBytes = 28;
constexpr int kSide = 12;
/// Limit for the texels and strokes of a hostile picture, which may take long to draw.
constexpr std::size_t kMostItems = 6;
constexpr std::size_t kMostTriangles = 24;

std::vector<std::uint8_t> with_valid_header(const Context& context, const std::uint8_t* data,
                                            std::size_t size) {
  std::vector<std::uint8_t> file(data, data + size);
  if (size < kHeaderBytes) return file;
  std::memcpy(file.data(), kHeader, sizeof kHeader);
  const std::uint64_t bytes = size;
  std::memcpy(&file[kSizeAt], &bytes, sizeof bytes);
  const auto sum = picture::checksum(context, std::span(file).subspan(kHeaderBytes));
  std::memcpy(&file[kChecksumAt], &*sum, sizeof *sum);
  return file;
}

bool is_small(const Picture& picture) {
  std::size_t triangles = 0;
  for (const PatchLayer& layer : picture.layers) triangles += layer.triangle_count();
  return triangles <= kMostTriangles && picture.stack.size() <= kMostItems;
}

template <class Made>
void check(const Made& made) {
  if (!made) fuzz::require_honest(made.status());
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Context context{.budget = Budget(fuzz::kBudgetBytes)};
  const std::vector<std::uint8_t> file = with_valid_header(context, data, size);
  {
    PictureOrigin origin;
    const Result<Picture> picture = read_picture(context, file, &origin);
    if (!picture) {
      fuzz::require_honest(picture.status());
      fuzz::require(context.budget.used() == 0, "a refusal keeps what it charged");
      return 0;
    }
    const auto again = write_picture(context, *picture, origin);
    fuzz::require(again.ok() && *again == file, "it is not written as it was read");
    if (is_small(*picture)) {
      check(rasterize(context, *picture, {.width = kSide, .height = kSide}));
      check(export_glb(context, *picture, {.max_error = 16, .dpi = 8}));
    }
  }
  fuzz::require(context.budget.used() == 0, "a picture keeps what it charged");
  return 0;
}
