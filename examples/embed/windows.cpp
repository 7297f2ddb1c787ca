// Paints an image in windows; only one of them at a time is in memory (docs/api.md).
#include <cstdio>
#include <sfumato/sfumato.hpp>
#include <vector>

using namespace sfumato;

void keep(const std::vector<std::uint8_t>& pixels, int x, int y) {
  const unsigned long size = pixels.size();
  if (x == y) std::printf("%lu bytes at (%d, %d)\n", size, x, y);
}

Status paint_tiles(Context& context, const Picture& picture, int side) {
  RasterOptions whole;
  whole.width = whole.height = side;
  const Result<PreparedRaster> prepared = PreparedRaster::create(context, picture, whole);
  if (!prepared) return prepared.status();
  std::vector<std::uint8_t> pixels(3 * 512 * 512);
  for (int y = 0; y + 512 <= side; y += 512) {
    for (int x = 0; x + 512 <= side; x += 512) {
      const Status status = prepared->paint(context, x, y, 512, 512, pixels.data(), 3 * 512);
      if (!status) return status;
      keep(pixels, x, y);
    }
  }
  return {};
}

int main() {
  Document document;
  document.artboard = {{0, 0}, {100, 100}};
  Curve horizon = polyline({{-10, 60}, {110, 40}});
  horizon.left = colored({rgb(0xff9966)});
  horizon.right = colored({rgb(0x1d2b64)});
  add_layer(document, {horizon});
  Context context;
  DiffuseOptions solving;
  solving.pixels_per_unit = 20;
  const Result<Picture> picture = diffuse(context, document, solving);
  const Status status = picture ? paint_tiles(context, *picture, 2048) : picture.status();
  if (!status) std::fprintf(stderr, "%s\n", to_string(status).c_str());
  return status ? 0 : 1;
}
