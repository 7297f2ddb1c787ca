#include "equal/tool/digest.hpp"

#include <cinttypes>
#include <cstdio>
#include <utility>

#include "sfumato/api/render_pixels.hpp"
#include "sfumato/codecs/jpeg_encode.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/codecs/webp_encode.hpp"
#include "sfumato/export/eps/eps.hpp"
#include "sfumato/export/glb/glb.hpp"
#include "sfumato/export/html/html.hpp"
#include "sfumato/export/pdf/pdf.hpp"
#include "sfumato/export/svg/svg.hpp"
#include "sfumato/formats/svg/svg_write.hpp"

namespace sfumato::test {
namespace {

void add_mesh(const PatchLayer& layer, Hasher& hasher) {
  const double frame[] = {layer.frame.min.x, layer.frame.min.y, layer.frame.max.x,
                          layer.frame.max.y};
  hasher.add(std::vector<double>(frame, frame + 4));
  hasher.add(layer.vertex_position);
  hasher.add(layer.triangle_vertex);
  hasher.add(layer.edge_is_curve);
  hasher.add(layer.color.triangle_node);
  hasher.add(layer.opacity.triangle_node);
}

void add_nodes(const PatchField& field, Hasher& hasher) {
  hasher.add(std::vector<int>{field.channel_count});
  hasher.add(field.node_value);
  hasher.add(field.shader);
}

/// Resolution for exporters that draw pixels: enough to detect differences, and quick.
constexpr double kDpi = 24;

template <class Options>
Options coarse() {
  Options options;
  options.dpi = kDpi;
  return options;
}

class Digester {
 public:
  Digester(Context& context, const Scene& scene) : context_(context), scene_(scene) {}

  std::vector<StageHash> run() {
    if (!add_bytes("document", write_svg(context_, scene_.document))) return std::move(digest_);
    const Result<Picture> picture = diffuse(context_, scene_.document, scene_.diffuse);
    if (!picture) return failed("mesh", picture.status());
    add_picture(*picture);
    const Result<Image> image = rasterize(context_, *picture, scene_.raster);
    if (!image) return failed("pixels", image.status());
    add_hash("pixels", image->bytes);
    add_bytes("png", encode_png(context_, *image));
    if (scene_.by_pixels) add_gathered();
    if (scene_.with_outputs) add_outputs(*picture, *image);
    add_grid();
    return std::move(digest_);
  }

 private:
  template <class Items>
  void add_hash(const char* stage, const Items& items) {
    Hasher hasher;
    hasher.add(items);
    digest_.push_back({stage, hasher.value()});
  }

  template <class Bytes>
  bool add_bytes(const char* stage, const Result<Bytes>& bytes) {
    add_hash(stage,
             bytes ? *bytes : Bytes(bytes.status().message.begin(), bytes.status().message.end()));
    return bytes.ok();
  }

  std::vector<StageHash> failed(const char* stage, const Status& status) {
    add_hash(stage, status.message);
    return std::move(digest_);
  }

  void add_picture(const Picture& picture) {
    Hasher mesh, nodes;
    for (const PatchLayer& layer : picture.layers) {
      test::add_mesh(layer, mesh);
      add_nodes(layer.color, nodes);
      add_nodes(layer.opacity, nodes);
    }
    digest_.push_back({"mesh", mesh.value()});
    digest_.push_back({"nodes", nodes.value()});
  }

  void add_gathered() {
    const Result<Image> image =
        render_pixels(context_, scene_.document, scene_.diffuse, scene_.raster);
    if (!image) return static_cast<void>(failed("gathered", image.status()));
    add_hash("gathered", image->bytes);
  }

  /// The pixels of a picture that was solved for them.
  void add_grid() {
    DiffuseOptions options = scene_.diffuse;
    options.pixel_grid = true;
    options.tolerance.reset();
    const Result<Picture> picture = diffuse(context_, scene_.document, options);
    if (!picture) return static_cast<void>(failed("grid", picture.status()));
    const Result<Image> image = rasterize(context_, *picture, scene_.raster);
    if (!image) return static_cast<void>(failed("grid", image.status()));
    add_hash("grid", image->bytes);
  }

  void add_outputs(const Picture& picture, const Image& image) {
    auto triangles = coarse<SvgOptions>();
    triangles.mode = SvgMode::vector;
    triangles.force = true;
    add_bytes("html", export_html(context_, picture, {}));
    add_bytes("pdf", export_pdf(context_, picture, coarse<PdfOptions>()));
    add_bytes("eps", export_eps(context_, picture, coarse<EpsOptions>()));
    add_bytes("svg", export_svg(context_, picture, triangles));
    add_bytes("glb", export_glb(context_, picture, coarse<GlbOptions>()));
    if (image.format == PixelFormat::rgb8) add_bytes("jpeg", encode_jpeg(context_, image, 90));
    if (bytes_per_channel(image.format) == 1) add_bytes("webp", encode_webp(context_, image, {}));
  }

  Context& context_;
  const Scene& scene_;
  std::vector<StageHash> digest_;
};

}  // namespace

void Hasher::add_bytes(const void* bytes, std::size_t size) {
  const auto* const first = static_cast<const std::uint8_t*>(bytes);
  for (std::size_t i = 0; i < size; ++i) value_ = (value_ ^ first[i]) * 0x100000001b3u;
}

std::vector<StageHash> digest_scene(Context& context, const Scene& scene) {
  return Digester(context, scene).run();
}

std::string digest_line(const Scene& scene, const std::vector<StageHash>& digest) {
  std::string line = scene.name;
  for (const StageHash& stage : digest) {
    char hash[20];
    std::snprintf(hash, sizeof hash, ":%016" PRIx64, stage.hash);
    line += ' ' + stage.stage + hash;
  }
  return line;
}

}  // namespace sfumato::test
