// Builds a drawing in code and draws it: drawing, which writes evening.png (docs/api.md).
#include <cstdio>
#include <sfumato/sfumato.hpp>

using namespace sfumato;

Status draw(const char* path) {
  Document document;
  document.artboard = {{0, 0}, {400, 300}};  // user units; y points down

  Curve top = polyline({{-20, -20}, {420, -20}});  // from left to right: its right side is below
  top.right = colored({rgb(0x1d2b64)});
  Curve horizon = bezier({{-20, 210}, {130, 180}, {270, 240}, {420, 210}});
  horizon.left = colored({rgb(0xf8cdda), rgb(0xff9966)});  // above: two colours along the curve
  horizon.right = colored({rgb(0x1b2a1f)});
  // Two pieces, closed.
  Curve sun =
      bezier({{210, 120}, {210, 67}, {290, 67}, {290, 120}, {290, 173}, {210, 173}, {210, 120}});
  sun.left = colored({rgb(0xffb75e)}, 12);  // outside, blurred over 12 units
  sun.right = colored({rgb(0xfff3c4)});     // inside, as the curve runs clockwise on the screen
  add_layer(document, {top, horizon, sun});

  ThreadPool pool;  // one thread per core
  Context context;
  context.executor = &pool;
  DiffuseOptions solving;
  solving.pixels_per_unit = 3;  // as fine as an output of three pixels to a user unit needs
  const Result<Picture> picture = diffuse(context, document, solving);
  if (!picture) return picture.status();
  RasterOptions pixels;
  pixels.width = 1200;
  pixels.height = 900;
  const Result<Image> image = rasterize(context, *picture, pixels);
  if (!image) return image.status();
  const auto png = encode_png(context, *image);
  return png ? write_file(path, *png) : png.status();
}

int main() {
  const Status status = draw("evening.png");
  if (!status) std::fprintf(stderr, "%s\n", to_string(status).c_str());
  return status ? 0 : 1;
}
