// Draws a document of diffusion curves as a PNG: embed IN OUT.png
#include <cstdio>
#include <sfumato/sfumato.hpp>

namespace {

sfumato::Status draw(const std::string& in, const std::string& out) {
  using namespace sfumato;
  ThreadPool pool;
  Context context;
  context.executor = &pool;

  auto xml = read_file(in, limits::kInputBytes);
  if (!xml) return xml.status();
  RasterOptions options;
  options.width = 1440;
  options.height = 960;

  auto read = read_document(context, *xml, in);
  if (!read) return read.status();
  auto picture = diffuse(context, read->document, {});
  if (!picture) return picture.status();
  auto image = rasterize(context, *picture, options);
  if (!image) return image.status();
  auto png = encode_png(context, *image);
  if (!png) return png.status();
  return write_file(out, *png);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: embed IN OUT.png\n", stderr);
    return 2;
  }
  const sfumato::Status status = draw(argv[1], argv[2]);
  if (!status) std::fprintf(stderr, "%s\n", to_string(status).c_str());
  return status ? 0 : 1;
}
