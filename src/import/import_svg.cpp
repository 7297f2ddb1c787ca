#include "sfumato/import/import_svg.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "base/public_verb.hpp"
#include "base/table_memory.hpp"
#include "codecs/gunzip.hpp"
#include "formats/svg/plain_svg.hpp"
#include "import/boundary.hpp"
#include "import/painted_layer.hpp"
#include "import/stroke_outline.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato {
namespace {

using svg_import::Contours;
using svg_import::PaintedLayer;
using svg_import::Region;

/// Of the artboard's longer side: how exactly crossings and offsets are found.
constexpr double kTolerance = 1.0 / 16384;

SideShader<float> constant_opacity(float value) {
  return {ShaderKind::curve_domain, {StopSpace::parameter, {{0, value}}}, 0};
}

class Importer {
 public:
  Importer(Context& context, svg::PlainSvg plain)
      : context_(context),
        plain_(std::move(plain)),
        tolerance_(kTolerance *
                   std::max(plain_.document.artboard.width(), plain_.document.artboard.height())) {}

  Status run();
  ImportedSvg take() {
    return {std::move(plain_.document), std::move(plain_.title), std::move(plain_.warnings)};
  }

 private:
  /// What paints into a layer that is empty in the document.
  struct Source {
    const svg::PlainShape* shape = nullptr;
    bool is_stroke = false;
  };

  Status paint(const LayerInstance& instance, const Source& source);
  Result<Contours> boundary_of(const Source& source, TableMemory& memory) const;
  Region region_of(const svg::PlainShape& shape, const svg::PlainPaint& paint);
  std::optional<SideShader<float>> gradient_opacity(std::uint32_t shader);
  Status paint_region(const LayerInstance& instance, const Region& region);
  void end_layer();
  void forget_empty_groups();

  Context& context_;
  svg::PlainSvg plain_;
  double tolerance_;
  std::vector<Layer> layers_;
  std::vector<StackItem> stack_;
  std::optional<PaintedLayer> open_;  ///< of the stack's last item
  std::map<std::uint32_t, std::uint32_t> opacity_shader_;
  TableMemory memory_{"the curves"};  ///< of the layers and the stack
};

Result<Contours> copy_of(Context& context, const Contours& from, TableMemory& memory) {
  Contours to;
  Status status = memory.reserve(context, to, from.size());
  for (std::size_t i = 0; status && i < from.size(); ++i) {
    status = memory.append(context, from[i], to.emplace_back());
  }
  if (!status) return status;
  return to;
}

Result<Contours> Importer::boundary_of(const Source& source, TableMemory& memory) const {
  const svg::PlainShape& shape = *source.shape;
  TableMemory working("the curves");
  const double scale = std::sqrt(std::abs(shape.artboard_from_user.determinant()));
  Result<Contours> made = source.is_stroke
                              ? svg_import::stroke_outline(context_, shape.subpaths, shape.style,
                                                           tolerance_ / scale, &working)
                              : copy_of(context_, shape.subpaths, working);
  if (!made) return made;
  Contours& contours = *made;
  for (std::vector<Vec2>& contour : contours) {
    for (Vec2& point : contour) point = shape.artboard_from_user(point);
  }
  return svg_import::fill_boundary(context_, contours, !source.is_stroke && shape.even_odd,
                                   tolerance_, &memory);
}

/// A paint of the alphas of a gradient's stops; none where all are 1.
std::optional<SideShader<float>> Importer::gradient_opacity(std::uint32_t index) {
  if (const auto known = opacity_shader_.find(index); known != opacity_shader_.end()) {
    return SideShader<float>{ShaderKind::image_domain, {}, known->second};
  }
  std::vector<Shader>& shaders = plain_.document.shaders;
  const auto* fill = std::get_if<GradientFill>(&shaders[index].paint);
  const auto is_opaque = [](const GradientStop& stop) { return stop.alpha >= 1; };
  if (!fill || std::ranges::all_of(fill->stops, is_opaque)) return std::nullopt;
  GradientFill alphas = *fill;
  for (GradientStop& stop : alphas.stops) stop.color = {1, 1, 1};
  for (GradientStop& stop : std::get<GradientFill>(shaders[index].paint).stops) stop.alpha = 1;
  const auto added = static_cast<std::uint32_t>(shaders.size());
  opacity_shader_.emplace(index, added);
  const std::string id = shaders[index].id.empty() ? "" : shaders[index].id + "-opacity";
  shaders.push_back({id, std::move(alphas)});
  return SideShader<float>{ShaderKind::image_domain, {}, added};
}

Region Importer::region_of(const svg::PlainShape& shape, const svg::PlainPaint& paint) {
  Region region;
  region.id = shape.id;
  region.opacity = constant_opacity(1);
  if (paint.color) {
    region.color = {ShaderKind::curve_domain, {StopSpace::parameter, {{0, *paint.color}}}, 0};
    return region;
  }
  region.color = {ShaderKind::image_domain, {}, paint.shader};
  if (auto opacity = gradient_opacity(paint.shader)) {
    region.opacity = *opacity;
    region.is_opaque = false;
  }
  return region;
}

void Importer::end_layer() {
  if (open_) layers_.back().curves = open_->take_curves(memory_);
  open_.reset();
}

/// Into the open layer where that shows it as it is, else into a new one.
Status Importer::paint_region(const LayerInstance& instance, const Region& region) {
  const bool is_plain = instance.opacity == 1 && instance.blend == BlendMode::normal;
  if (open_ && is_plain) {
    const Result<bool> is_added = open_->try_add(context_, region);
    if (!is_added || *is_added) return is_added.status();
  }
  end_layer();
  LayerInstance placed = instance;
  placed.layer = static_cast<std::uint32_t>(layers_.size());
  PaintedLayer layer(tolerance_);
  Status status = memory_.push_back(context_, layers_, {});
  if (status) status = memory_.push_back(context_, stack_, placed);
  if (status) status = layer.add(context_, region);
  if (!status) return status;
  if (is_plain) {
    open_.emplace(std::move(layer));
  } else {
    layers_.back().curves = layer.take_curves(memory_);
  }
  return ok_status();
}

Status Importer::paint(const LayerInstance& instance, const Source& source) {
  TableMemory memory("the curves");
  Result<Contours> boundary = boundary_of(source, memory);
  if (!boundary) return boundary.status();
  if (boundary->empty()) return ok_status();
  const svg::PlainShape& shape = *source.shape;
  Region region = region_of(shape, source.is_stroke ? *shape.stroke : *shape.fill);
  if (source.is_stroke && shape.fill && !region.id.empty()) region.id += "-stroke";
  region.boundary = std::move(*boundary);
  return paint_region(instance, region);
}

/// A group whose shapes all turned out to fill nothing.
void Importer::forget_empty_groups() {
  while (stack_.size() >= 2 && std::holds_alternative<GroupEnd>(stack_.back()) &&
         std::holds_alternative<GroupBegin>(stack_[stack_.size() - 2])) {
    stack_.resize(stack_.size() - 2);
  }
}

Status Importer::run() {
  Document& document = plain_.document;
  std::map<std::uint32_t, Source> source_of;
  for (const svg::PlainShape& shape : plain_.shapes) {
    if (shape.fill) source_of[shape.fill_layer] = {&shape, false};
    if (shape.stroke) source_of[shape.stroke_layer] = {&shape, true};
  }
  std::map<std::uint32_t, std::uint32_t> kept;  // layers of Sfumato's own attributes
  for (const StackItem& item : document.stack) {
    if (context_.cancelled()) return context_.cancel_status();
    const auto* instance = std::get_if<LayerInstance>(&item);
    if (const auto found = instance ? source_of.find(instance->layer) : source_of.end();
        found != source_of.end()) {
      if (Status status = paint(*instance, found->second); !status) return status;
      continue;
    }
    end_layer();
    if (Status status = memory_.push_back(context_, stack_, item); !status) return status;
    forget_empty_groups();
    if (!instance) continue;
    const auto [entry, is_new] =
        kept.emplace(instance->layer, static_cast<std::uint32_t>(layers_.size()));
    if (is_new) {
      Status status =
          memory_.push_back(context_, layers_, std::move(document.layers[instance->layer]));
      if (!status) return status;
    }
    std::get<LayerInstance>(stack_.back()).layer = entry->second;
  }
  end_layer();
  document.layers = std::move(layers_);
  document.stack = std::move(stack_);
  return validate(context_, document);
}

Result<ImportedSvg> import_text(Context& context, std::string_view text, const std::string& file,
                                const ResourceLoader* loader) {
  TableMemory memory("unpacked gzip");
  std::string unpacked;
  if (codecs::is_gzip(text)) {
    Result<std::string> bytes = codecs::gunzip(context, text, memory);
    if (!bytes) return bytes.status();
    unpacked = std::move(*bytes);
    text = unpacked;
  }
  Result<svg::PlainSvg> plain = svg::read_plain_svg(context, text, file, loader);
  if (!plain) return plain.status();
  Importer importer(context, std::move(*plain));
  Status status = importer.run();
  if (status) return importer.take();
  if (status.where.file.empty()) status.where.file = file;
  return status;
}

}  // namespace

Result<ImportedSvg> import_svg(Context& context, std::string_view text, const std::string& file,
                               const ResourceLoader* loader) {
  return public_verb(context, [&] { return import_text(context, text, file, loader); });
}

}  // namespace sfumato
