#include "sfumato/export/svg/svg.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "base/charge.hpp"
#include "base/limit_error.hpp"
#include "base/output_buffer.hpp"
#include "base/public_verb.hpp"
#include "base/text/number_text.hpp"
#include "base/try.hpp"
#include "codecs/data_uri_write.hpp"
#include "document/names.hpp"
#include "document/rules.hpp"
#include "export/page.hpp"
#include "export/pixel_run.hpp"
#include "export/svg/svg_layer.hpp"
#include "export/svg/svg_text.hpp"
#include "picture/check_picture.hpp"
#include "sfumato/base/limits.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/raster/rasterize.hpp"

namespace sfumato {
namespace {

using outputs::SvgLayer;

constexpr double kPxPerInch = 96;
/// Longer side of a picture of triangles in pixels for which it is made: it can be shown at half
/// that size and at any larger one.
constexpr double kNominalSide = 512;

constexpr std::string_view kFileEnd = "</svg>\n";

double pixels_per_unit(const SvgOptions& options) {
  return options.scale * options.dpi / kPxPerInch;
}

Status check(const Context& context, const Picture& picture, const SvgOptions& options) {
  if (!(options.scale > 0) || !(options.dpi > 0) || !(pixels_per_unit(options) > 0) ||
      !std::isfinite(pixels_per_unit(options))) {
    return make_error(StatusCode::bad_input,
                      "the scale and dpi of an SVG must be positive numbers");
  }
  if (!(options.max_error > 0) || !std::isfinite(options.max_error)) {
    return make_error(StatusCode::bad_input,
                      "the largest error of an SVG's colours must be a positive number");
  }
  if (options.mode > SvgMode::vector) {
    return make_error(StatusCode::bad_input, "an unknown mode of SVG");
  }
  SFUMATO_TRY(outputs::check_viewport(picture.viewport));
  SFUMATO_TRY(rules::check_background(options.background));
  return picture::check_picture(context, picture);
}

void append_attribute(OutputBuffer& text, std::string_view name, double value) {
  ((text += ' ') += name) += "=\"" + number_text(value) + '"';
}

void append_box(OutputBuffer& text, const Box& box) {
  append_attribute(text, "x", box.min.x);
  append_attribute(text, "y", box.min.y);
  append_attribute(text, "width", box.width());
  append_attribute(text, "height", box.height());
}

void append_compositing(OutputBuffer& text, float opacity, BlendMode blend) {
  if (opacity != 1) append_attribute(text, "opacity", opacity);
  if (blend == BlendMode::normal) return;
  text += " style=\"mix-blend-mode:" + std::string(blend_name(blend)) + '"';
}

void append_image(const Context& context, const Box& box, BlendMode blend,
                  const std::vector<std::uint8_t>& png, OutputBuffer& text) {
  text += "<image";
  append_box(text, box);
  append_compositing(text, 1, blend);
  text += " preserveAspectRatio=\"none\" xlink:href=\"";
  codecs::append_data_uri(context, "image/png", png, text);
  text += "\"/>\n";
}

void begin_file(OutputBuffer& text, const Box& viewport, double scale) {
  text += "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"";
  append_attribute(text, "width", scale * viewport.width());
  append_attribute(text, "height", scale * viewport.height());
  text += " viewBox=\"" + number_text(viewport.min.x) + ' ' + number_text(viewport.min.y) + ' ' +
          number_text(viewport.width()) + ' ' + number_text(viewport.height()) + "\">\n";
}

Result<std::vector<std::uint8_t>> image_file(Context& context, const Picture& picture,
                                             const SvgOptions& options) {
  const Box& viewport = picture.viewport;
  const auto side = [&](double units) {
    return static_cast<int>(std::clamp(std::round(units * pixels_per_unit(options)), 1.0, 1e9));
  };
  RasterOptions raster;
  raster.width = side(viewport.width());
  raster.height = side(viewport.height());
  raster.background = options.background;
  raster.format = options.background || picture.background ? PixelFormat::rgb8 : PixelFormat::rgba8;
  SFUMATO_TRY_ASSIGN(const Image& image, rasterize(context, picture, raster));
  SFUMATO_TRY_ASSIGN(const auto& png, encode_png(context, image));
  ScopedCharge held;
  SFUMATO_TRY(held.add(context, capacity_bytes(png), "the image as PNG"));
  OutputBuffer text(context, "the image as SVG");
  begin_file(text, viewport, options.scale);
  append_image(context, viewport, BlendMode::normal, png, text);
  text += kFileEnd;
  return text.finish();
}

double scale_of(const Affine& map) {
  return std::sqrt(std::fabs(map.determinant()));
}

/// The instances of a layer that are drawn as triangles.
struct LayerUse {
  std::uint64_t count = 0;
  double smallest_scale = 0;
  double largest_scale = 0;
};

class VectorWriter {
 public:
  VectorWriter(Context& context, const Picture& picture, const SvgOptions& options,
               ExportNotes* notes)
      : context_(context),
        picture_(picture),
        options_(options),
        notes_(notes),
        text_(context, "the SVG") {}

  Result<std::vector<std::uint8_t>> write();

 private:
  void find_uses();
  /// Returns whether triangles of an item are drawn.
  bool is_drawn(const PatchInstance& instance) const;
  Status check_count(std::uint64_t triangles) const;
  Status make_layers();
  void tell();
  Status write_layers();
  Status write_stack();
  Status write_pixels(std::size_t first, std::size_t end);

  Context& context_;
  const Picture& picture_;
  const SvgOptions& options_;
  ExportNotes* notes_;
  std::vector<LayerUse> uses_;
  std::vector<SvgLayer> layers_;
  std::uint64_t stored_ = 0;
  bool has_pixels_ = false;
  OutputBuffer text_;
};

bool VectorWriter::is_drawn(const PatchInstance& instance) const {
  return scale_of(instance.artboard_from_layer) > 0 &&
         picture_.layers[instance.layer].triangle_count() > 0;
}

void VectorWriter::find_uses() {
  uses_.resize(picture_.layers.size());
  for (const PictureItem& item : picture_.stack) {
    if (outputs::needs_pixels(picture_, item)) {
      has_pixels_ = true;
      continue;
    }
    const auto* instance = std::get_if<PatchInstance>(&item);
    if (!instance || !is_drawn(*instance)) continue;
    LayerUse& use = uses_[instance->layer];
    const double scale = scale_of(instance->artboard_from_layer);
    use.smallest_scale = use.count == 0 ? scale : std::min(use.smallest_scale, scale);
    use.largest_scale =
        std::max(use.largest_scale, outputs::instance_scale(instance->artboard_from_layer));
    ++use.count;
  }
}

Status VectorWriter::check_count(std::uint64_t triangles) const {
  if (options_.force || triangles <= context_.limits.svg_triangles) return ok_status();
  return make_limit_error(&Limits::svg_triangles,
                          std::to_string(triangles) +
                              " triangles or more in an SVG; the limit is " +
                              limit_text(context_.limits, &Limits::svg_triangles, "triangles") +
                              ": allow a larger error or write pixels instead");
}

Status VectorWriter::make_layers() {
  std::uint64_t painted = 0;
  for (std::size_t i = 0; i < uses_.size(); ++i) {
    painted += uses_[i].count * picture_.layers[i].triangle_count();
  }
  SFUMATO_TRY(check_count(painted));
  painted = 0;
  const Box& viewport = picture_.viewport;
  const double pixel = std::max(viewport.width(), viewport.height()) / kNominalSide;
  layers_.resize(uses_.size());
  for (std::size_t i = 0; i < uses_.size(); ++i) {
    const LayerUse& use = uses_[i];
    if (use.count == 0) continue;
    const outputs::SvgScale scale{options_.max_error / 255, pixel, use.smallest_scale,
                                  use.largest_scale};
    SFUMATO_TRY_ASSIGN(auto&& layer, outputs::make_svg_layer(context_, picture_.layers[i],
                                                             picture_.interpolation, scale));
    stored_ += layer.facet_count();
    painted += use.count * layer.facet_count();
    SFUMATO_TRY(check_count(painted));
    layers_[i] = std::move(layer);
  }
  if (notes_ && painted > limits::kSvgTrianglesSlow) {
    notes_->lost.push_back("an SVG of " + std::to_string(painted) +
                           " triangles is slow to open; above " +
                           std::to_string(limits::kSvgTrianglesSlow) + " pixels are better");
  }
  return ok_status();
}

void VectorWriter::tell() {
  if (!notes_) return;
  notes_->triangle_count += stored_;
  if (!has_pixels_) return;
  notes_->lost.push_back("local curves and layers with textures or gradients are stored as pixels");
}

Status VectorWriter::write_layers() {
  if (stored_ == 0) return ok_status();
  text_ += "<defs>\n";
  for (const outputs::Ink& ink :
       {outputs::kRed, outputs::kGreen, outputs::kBlue, outputs::kWhite}) {
    outputs::append_stops(ink, text_);
  }
  outputs::SvgIds ids;
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    if (layers_[i].color.facet_vertex.empty()) continue;
    SFUMATO_TRY(outputs::append_layer(context_, layers_[i], "L" + std::to_string(i), ids, text_));
    layers_[i] = {};
  }
  text_ += "</defs>\n";
  return ok_status();
}

Status VectorWriter::write_pixels(std::size_t first, std::size_t end) {
  SFUMATO_TRY_ASSIGN(const auto& part,
                     outputs::paint_run(context_, picture_, first, end, pixels_per_unit(options_)));
  if (part.box.empty()) return ok_status();
  append_image(context_, part.box, outputs::run_blend(picture_, first), part.png, text_);
  return text_.status();
}

Status VectorWriter::write_stack() {
  const std::vector<PictureItem>& stack = picture_.stack;
  for (std::size_t i = 0; i < stack.size(); ++i) {
    if (outputs::needs_pixels(picture_, stack[i])) {
      const std::size_t end = outputs::pixel_run_end(picture_, i);
      SFUMATO_TRY(write_pixels(i, end));
      i = end - 1;
    } else if (const auto* group = std::get_if<GroupBegin>(&stack[i])) {
      const bool is_plain = group->opacity == 1 && group->blend == BlendMode::normal;
      text_ += is_plain ? "<g style=\"isolation:isolate\"" : "<g";
      append_compositing(text_, group->opacity, group->blend);
      text_ += ">\n";
    } else if (std::holds_alternative<GroupEnd>(stack[i])) {
      text_ += "</g>\n";
    } else if (const auto& instance = std::get<PatchInstance>(stack[i]); is_drawn(instance)) {
      text_ += "<use xlink:href=\"#L" + std::to_string(instance.layer) + '"' +
               outputs::transform_attribute(instance.artboard_from_layer);
      append_compositing(text_, instance.opacity, instance.blend);
      text_ += "/>\n";
    }
    if (!text_.status()) break;
  }
  return text_.status();
}

Result<std::vector<std::uint8_t>> VectorWriter::write() {
  find_uses();
  SFUMATO_TRY(make_layers());
  tell();
  begin_file(text_, picture_.viewport, options_.scale);
  if (const auto& color = options_.background ? options_.background : picture_.background) {
    text_ += "<rect";
    append_box(text_, picture_.viewport);
    text_ += " fill=\"" + color_text(*color) + "\"/>\n";
  }
  SFUMATO_TRY(write_layers());
  SFUMATO_TRY(write_stack());
  text_ += kFileEnd;
  return text_.finish();
}

Result<std::vector<std::uint8_t>> write(Context& context, const Picture& picture,
                                        const SvgOptions& options, ExportNotes* notes) {
  SFUMATO_TRY(check(context, picture, options));
  if (options.mode == SvgMode::image) return image_file(context, picture, options);
  return VectorWriter(context, picture, options, notes).write();
}

}  // namespace

Result<std::vector<std::uint8_t>> export_svg(Context& context, const Picture& picture,
                                             const SvgOptions& options, ExportNotes* notes) {
  return public_verb(context, [&] { return write(context, picture, options, notes); });
}

}  // namespace sfumato
