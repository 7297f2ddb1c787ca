#include "sfumato/import/import_svg.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <variant>

#include "base/boxes.hpp"
#include "base/limit_error.hpp"
#include "base/public_verb.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "codecs/gunzip.hpp"
#include "document/gaussian.hpp"
#include "document/rules.hpp"
#include "formats/svg/read/plain_svg.hpp"
#include "formats/text/warnings.hpp"
#include "formats/text/xml_source.hpp"
#include "import/boundary.hpp"
#include "import/chords.hpp"
#include "import/clip_regions.hpp"
#include "import/mask_opacity.hpp"
#include "import/paint_opacity.hpp"
#include "import/painted_layer.hpp"
#include "import/placed_contours.hpp"
#include "import/unseen_stops.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato {
namespace {

using svg_import::Contours;
using svg_import::Fit;
using svg_import::Outline;
using svg_import::PaintedLayer;
using svg_import::Region;
using svg_import::UnseenStops;

/// A share of the artboard's longer side: the accuracy of crossings and offsets.
constexpr double kTolerance = 1.0 / 16384;
/// Chords of regions that later ones are compared with; beyond, they get layers of their own.
constexpr std::size_t kOpenChords = 500'000;
/// Comparisons of chords in one import, some seconds of work; beyond, the same.
constexpr std::size_t kSteps = 1'000'000'000;
/// Tolerances: the outline of a stroke no wider than this is closed as a slit…
constexpr double kThinStroke = 4;
/// …hence it is drawn this wide, with as much less opacity…
constexpr double kDrawnStroke = 6;
/// …or not at all if it is no wider than this, which nobody sees.
constexpr double kUnseenStroke = 1.0 / 8;
/// The most shapes that are left out because they cross themselves too often; each takes a second.
constexpr int kIntricateShapes = 4;

SideShader<float> constant_opacity(float value) {
  return {ShaderKind::curve_domain, {StopSpace::parameter, {{0, value}}}, 0};
}

double tolerance_for(const Box& artboard) {
  return kTolerance * std::max(artboard.width(), artboard.height());
}

class Importer {
 public:
  /// painter   draws products of masks; without one, paints that need them lose their mask
  Importer(Context& context, svg::PlainSvg plain, std::string_view text, const std::string& file,
           const std::optional<TilePainter>& painter)
      : context_(context),
        plain_(std::move(plain)),
        text_(text),
        file_(file),
        painter_(painter),
        tolerance_(tolerance_for(plain_.document.artboard)) {}

  Status run();
  ImportedSvg take() {
    std::ranges::move(warnings_.take(), std::back_inserter(plain_.warnings));
    return {std::move(plain_.document), std::move(plain_.title), std::move(plain_.warnings)};
  }

 private:
  /// Paints regions into a layer that is empty in the document.
  struct Source {
    const svg::PlainShape* shape = nullptr;
    bool is_stroke = false;
  };

  /// A layer into which more regions may be painted.
  struct OpenLayer {
    PaintedLayer layer;
    std::uint32_t index = 0;  ///< in layers_
    float opacity = 1;        ///< of its instance
    BlendMode blend = BlendMode::normal;
  };

  Status fit_artboard();
  Status extend_by(const Source& source, double tolerance, Box& box);
  Status paint_all();
  Status paint(const LayerInstance& instance, const Source& source);
  Result<Contours> contours_of(const Source& source, double tolerance, TableMemory& memory) const;
  Result<Contours> boundary_of(const Source& source, TableMemory& memory);
  SourcePlace place_of(const svg::PlainShape& shape) const;
  bool may_lose_intricate(const Status& status);
  Status leave_out(const svg::PlainShape& shape, Status status);
  Result<Region> region_of(const svg::PlainShape& shape, const svg::PlainPaint& paint,
                           Contours boundary);
  Result<std::optional<std::uint32_t>> opacity_of(std::uint32_t shader);
  Result<std::uint32_t> shader_of_mask(std::uint32_t mask_shader);
  std::uint32_t seen_shader(std::uint32_t index, const Contours& boundary);
  Result<std::vector<std::uint32_t>> opacities_of(const svg::PlainShape& shape,
                                                  const svg::PlainPaint& paint,
                                                  const Contours& boundary);
  Result<std::uint32_t> product_of(const svg::PlainShape& shape,
                                   const std::vector<std::uint32_t>& factors,
                                   const Contours& boundary);
  Status paint_region(const LayerInstance& instance, const Region& region);
  Result<std::size_t> find_layer(const LayerInstance& instance, const Outline& outline, Fit& fit);
  void close_layers();
  void forget_empty_groups();

  Context& context_;
  svg::PlainSvg plain_;
  std::string_view text_;
  const std::string& file_;
  const std::optional<TilePainter>& painter_;
  double tolerance_;
  text::Warnings warnings_;
  std::vector<Layer> layers_;
  std::vector<StackItem> stack_;
  std::vector<OpenLayer> open_;  ///< of the stack's last items
  std::size_t open_chords_ = 0;  ///< of outlines in open_
  std::size_t steps_ = kSteps;   ///< comparisons of chords that are left
  int intricate_ = 0;            ///< shapes that crossed themselves too often
  std::map<std::uint32_t, std::optional<std::uint32_t>> opacity_shader_;  ///< by colour
  std::map<std::uint32_t, std::uint32_t> mask_shader_;  ///< of the document, by the mask's shader
  std::map<std::pair<std::uint32_t, UnseenStops>, std::uint32_t> seen_shader_;
  svg_import::MaskProducts products_;
  svg_import::ClipRegions clip_regions_;
  TableMemory memory_{"the curves"};  ///< of the layers and the stack
  TableMemory texture_memory_{"textures"};
};

/// Returns how many artboard units a unit of a stroke's lengths is.
double stroke_scale(const svg::PlainShape& shape) {
  return shape.style.is_scaled ? std::sqrt(std::abs(shape.artboard_from_user.determinant())) : 1;
}

/// Returns the width of a stroke over the width that it is drawn with: 1, less if it is too thin to
/// be drawn, 0 if it is not drawn.
double share_of_width(const svg::PlainShape& shape, double tolerance) {
  const double width = shape.style.width * stroke_scale(shape);
  if (width > kThinStroke * tolerance) return 1;
  return width > kUnseenStroke * tolerance ? width / (kDrawnStroke * tolerance) : 0;
}

/// Returns the outline of a stroke in the artboard's frame.
Result<Contours> stroke_of(Context& context, const svg::PlainShape& shape, double tolerance,
                           TableMemory& memory) {
  const double share = share_of_width(shape, tolerance);
  if (!(share > 0)) return Contours{};
  svg::StrokeStyle style = shape.style;
  style.width /= share;
  return svg_import::placed_stroke(context, shape.subpaths, style, shape.artboard_from_user,
                                   tolerance, memory);
}

/// Returns the region of a fill or a stroke in the artboard's frame. Errors: bad_input out of
/// range.
Result<Contours> Importer::contours_of(const Source& source, double tolerance,
                                       TableMemory& memory) const {
  const svg::PlainShape& shape = *source.shape;
  SFUMATO_TRY_ASSIGN(auto&& made, source.is_stroke
                                      ? stroke_of(context_, shape, tolerance, memory)
                                      : svg_import::copy_of(context_, shape.subpaths, memory));
  if (!source.is_stroke) svg_import::map_points(shape.artboard_from_user, made);
  if (svg_import::are_in_range(made)) return std::move(made);
  return make_error(StatusCode::bad_input,
                    "it reaches farther than " +
                        std::to_string(static_cast<long>(limits::kCoordinate)) +
                        " from the origin; keep coordinates within that");
}

Result<Contours> Importer::boundary_of(const Source& source, TableMemory& memory) {
  TableMemory working("the curves");
  SFUMATO_TRY_ASSIGN(const Contours& contours, contours_of(source, tolerance_, working));
  const std::optional<std::uint32_t> clip = source.shape->clip;
  const bool even_odd = !source.is_stroke && source.shape->even_odd;
  Result<Contours> region = svg_import::fill_boundary(context_, contours, even_odd, tolerance_,
                                                      clip ? &working : &memory);
  return region && clip ? clip_regions_.clipped(context_, plain_.content.clips, std::move(*region),
                                                *clip, tolerance_, memory)
                        : std::move(region);
}

SourcePlace Importer::place_of(const svg::PlainShape& shape) const {
  return shape.offset > 0 ? text::place_in(text_, file_, shape.offset) : SourcePlace{file_};
}

/// Returns whether a shape or clip failed because it is too intricate, so that the file can be read
/// without it.
bool Importer::may_lose_intricate(const Status& status) {
  return svg_import::is_too_intricate(status) && intricate_++ < kIntricateShapes;
}

/// Returns ok after a warning if the shape is at fault; otherwise the failure with the shape's
/// place.
Status Importer::leave_out(const svg::PlainShape& shape, Status status) {
  const bool is_ended = status.code == StatusCode::cancelled || status.limit == "time";
  if (status || is_ended) return status;
  const bool is_at_fault = status.code == StatusCode::bad_input || status.limit == "dashes" ||
                           may_lose_intricate(status);
  if (!is_at_fault) {
    status.where = place_of(shape);
    return status;
  }
  if (warnings_.is_new(status.message)) {
    const std::string id = shape.id.empty() ? "" : " #" + shape.id.substr(0, 64);
    const std::string advice =
        status.limit.empty() ? "" : "; raise the limit " + std::string(status.limit);
    warnings_.add("the shape" + id + " is left out: " + status.message + advice, place_of(shape));
  }
  return ok_status();
}

/// Returns a paint of the alphas of another paint; none if all are 1.
Result<std::optional<std::uint32_t>> Importer::opacity_of(std::uint32_t index) {
  if (const auto known = opacity_shader_.find(index); known != opacity_shader_.end()) {
    return known->second;
  }
  std::vector<Shader>& shaders = plain_.document.shaders;
  SFUMATO_TRY_ASSIGN(auto&& alphas,
                     svg_import::take_alphas(context_, shaders[index], texture_memory_));
  std::optional<std::uint32_t> added;
  if (alphas) {
    added = static_cast<std::uint32_t>(shaders.size());
    shaders.push_back(std::move(*alphas));
  }
  opacity_shader_.emplace(index, added);
  return added;
}

/// Returns the document's shader for a paint of a mask.
Result<std::uint32_t> Importer::shader_of_mask(std::uint32_t mask_shader) {
  if (const auto known = mask_shader_.find(mask_shader); known != mask_shader_.end()) {
    return known->second;
  }
  std::vector<Shader>& shaders = plain_.document.shaders;
  const auto added = static_cast<std::uint32_t>(shaders.size());
  shaders.push_back(std::move(plain_.content.mask_shaders[mask_shader]));
  mask_shader_.emplace(mask_shader, added);
  return added;
}

/// Returns the shader without the stops that the region does not show.
std::uint32_t Importer::seen_shader(std::uint32_t index, const Contours& boundary) {
  std::vector<Shader>& shaders = plain_.document.shaders;
  const auto* fill = std::get_if<GradientFill>(&shaders[index].paint);
  if (!fill) return index;
  const UnseenStops unseen = svg_import::unseen_stops(*fill, boundary, tolerance_);
  if (unseen == UnseenStops{}) return index;
  const auto [entry, is_new] =
      seen_shader_.emplace(std::pair(index, unseen), static_cast<std::uint32_t>(shaders.size()));
  if (!is_new) return entry->second;
  GradientFill seen = *fill;
  seen.stops.erase(seen.stops.end() - static_cast<std::ptrdiff_t>(unseen.last), seen.stops.end());
  seen.stops.erase(seen.stops.begin(),
                   seen.stops.begin() + static_cast<std::ptrdiff_t>(unseen.first));
  Shader added{shaders[index].id, std::move(seen)};
  shaders.push_back(std::move(added));
  return entry->second;
}

/// Returns the shaders of the document that multiply to the opacity of a paint.
Result<std::vector<std::uint32_t>> Importer::opacities_of(const svg::PlainShape& shape,
                                                          const svg::PlainPaint& paint,
                                                          const Contours& boundary) {
  std::vector<std::uint32_t> opacities;
  if (!paint.color) {
    SFUMATO_TRY_ASSIGN(const std::optional<std::uint32_t>& own, opacity_of(paint.shader));
    if (own) opacities.push_back(seen_shader(*own, boundary));
  }
  for (auto mask = shape.mask; mask; mask = plain_.content.masks[*mask].outer) {
    SFUMATO_TRY_ASSIGN(const std::uint32_t shader,
                       shader_of_mask(plain_.content.masks[*mask].shader));
    opacities.push_back(shader);
  }
  return opacities;
}

/// Returns a texture of the product of opacities over a region; if it cannot be drawn, returns the
/// first opacity, with a warning.
Result<std::uint32_t> Importer::product_of(const svg::PlainShape& shape,
                                           const std::vector<std::uint32_t>& factors,
                                           const Contours& boundary) {
  if (factors.size() == 1) return factors.front();
  Box box;
  for (const std::vector<Vec2>& contour : boundary) box = united(box, box_of_points(contour));
  SFUMATO_TRY_ASSIGN(auto&& product,
                     products_.draw(context_, plain_.document, factors, box, plain_.units_per_px,
                                    painter_, texture_memory_));
  if (!product) {
    if (warnings_.is_new("/product")) {
      const std::string id = shape.id.empty() ? "" : " #" + shape.id.substr(0, 64);
      warnings_.add("the mask of the shape" + id + " is left out: its paint is not opaque, or " +
                        "several masks overlap, and " +
                        (painter_ ? "there are too many of that kind"
                                  : "nothing draws their product here; the command does"),
                    place_of(shape));
    }
    return factors.front();
  }
  std::vector<Shader>& shaders = plain_.document.shaders;
  shaders.push_back(std::move(*product));
  return static_cast<std::uint32_t>(shaders.size() - 1);
}

Result<Region> Importer::region_of(const svg::PlainShape& shape, const svg::PlainPaint& paint,
                                   Contours boundary) {
  Region region;
  region.id = shape.id;
  region.opacity = constant_opacity(1);
  region.boundary = std::move(boundary);
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint32_t>& opacities,
                     opacities_of(shape, paint, region.boundary));
  if (paint.color) {
    region.color = {ShaderKind::curve_domain, {StopSpace::parameter, {{0, *paint.color}}}, 0};
  } else {  // opacities_of() has taken its alphas
    region.color = {ShaderKind::image_domain, {}, seen_shader(paint.shader, region.boundary)};
  }
  if (opacities.empty()) return region;
  SFUMATO_TRY_ASSIGN(const std::uint32_t opacity, product_of(shape, opacities, region.boundary));
  region.opacity = {ShaderKind::image_domain, {}, opacity};
  region.is_opaque = false;
  return region;
}

/// Later items are painted over all layers up to here.
void Importer::close_layers() {
  for (OpenLayer& open : open_) layers_[open.index].curves = open.layer.take_curves(memory_);
  open_.clear();
  open_chords_ = 0;
}

/// Returns the open layer that shows the region as a layer of its own on top of all would: the
/// lowest one such that the region meets nothing of the layers above. open_.size(): none.
Result<std::size_t> Importer::find_layer(const LayerInstance& instance, const Outline& outline,
                                         Fit& fit) {
  std::size_t best = open_.size();
  for (std::size_t i = open_.size(); i-- > 0;) {
    if (context_.cancelled()) return context_.cancel_status();
    const OpenLayer& open = open_[i];
    SFUMATO_TRY_ASSIGN(const Fit& here, open.layer.look(context_, outline, steps_));
    if (here.kind == Fit::Kind::covers) break;
    const bool is_on_one = here.kind == Fit::Kind::on_one;
    const bool is_alike = open.opacity == instance.opacity && open.blend == instance.blend;
    const bool is_plain = instance.opacity == 1 && instance.blend == BlendMode::normal;
    if (is_alike && (is_plain || !is_on_one) && open.layer.has_room()) {
      best = i;
      fit = here;
    }
    if (is_on_one) break;
  }
  return best;
}

/// Paints a region into an open layer if it looks the same there, else into a new layer.
Status Importer::paint_region(const LayerInstance& instance, const Region& region) {
  SFUMATO_TRY_ASSIGN(auto&& outline, svg_import::outline_of(context_, region, tolerance_));
  // A soft edge reaches farther than the outline, so nothing else is painted into that layer.
  const bool is_soft = region.blur_radius > 0;
  if (is_soft || open_chords_ + outline.chords.size() > kOpenChords) close_layers();
  open_chords_ += outline.chords.size();
  Fit fit;
  SFUMATO_TRY_ASSIGN(const std::size_t found, find_layer(instance, outline, fit));
  if (found == open_.size()) {
    if (layers_.size() >= context_.limits.layers) {
      return limit_error(context_.limits, &Limits::layers, "layers");
    }
    fit = {};
    LayerInstance placed = instance;
    placed.layer = static_cast<std::uint32_t>(layers_.size());
    open_.push_back({PaintedLayer(tolerance_), placed.layer, instance.opacity, instance.blend});
    SFUMATO_TRY(memory_.push_back(context_, layers_, {}));
    SFUMATO_TRY(memory_.push_back(context_, stack_, placed));
  }
  Status status = open_[found].layer.add(context_, region, std::move(outline), fit);
  if (is_soft) close_layers();
  return status;
}

Status Importer::paint(const LayerInstance& instance, const Source& source) {
  TableMemory memory("the curves");
  const svg::PlainShape& shape = *source.shape;
  Result<Contours> boundary = boundary_of(source, memory);
  if (!boundary) return leave_out(shape, boundary.status());
  if (boundary->empty()) return ok_status();
  Result<Region> region =
      region_of(shape, source.is_stroke ? *shape.stroke : *shape.fill, std::move(*boundary));
  if (!region) return leave_out(shape, region.status());
  if (source.is_stroke && shape.fill && !region->id.empty()) region->id += "-stroke";
  region->blur_radius = std::min(kBlurRadiusOfSigma * shape.blur, limits::kCoordinate);
  LayerInstance painted = instance;
  if (source.is_stroke) painted.opacity *= static_cast<float>(share_of_width(shape, tolerance_));
  return leave_out(shape, paint_region(painted, *region));
}

/// The group's shapes all fill nothing.
void Importer::forget_empty_groups() {
  while (stack_.size() >= 2 && std::holds_alternative<GroupEnd>(stack_.back()) &&
         std::holds_alternative<GroupBegin>(stack_[stack_.size() - 2])) {
    stack_.resize(stack_.size() - 2);
  }
}

/// Extends the box by the area of a fill or a stroke, but not if the shape will be left out.
Status Importer::extend_by(const Source& source, double tolerance, Box& box) {
  TableMemory working("the curves");
  const Result<Contours> contours = contours_of(source, tolerance, working);
  if (!contours) {
    return contours.status().code == StatusCode::bad_input
               ? ok_status()
               : leave_out(*source.shape, contours.status());
  }
  for (const std::vector<Vec2>& contour : *contours) {
    if (context_.cancelled()) return context_.cancel_status();
    box.extend(contour.front());
    svg_import::for_each_chord_end(contour, tolerance, [&](Vec2 end) { box.extend(end); });
  }
  return ok_status();
}

/// Makes the artboard of a drawing whose size is open: the box of its shapes.
Status Importer::fit_artboard() {
  Box rough;
  for (const svg::PlainShape& shape : plain_.content.shapes) {
    for (const std::vector<Vec2>& chain : shape.subpaths) {
      for (const Vec2 user_point : chain) {
        const Vec2 point = shape.artboard_from_user(user_point);
        if (rules::is_coordinate(point)) rough.extend(point);
      }
    }
    if (context_.cancelled()) return context_.cancel_status();
  }
  Box& artboard = plain_.document.artboard;
  Box box;
  const double tolerance = rough.empty() ? 0 : tolerance_for(united(rough, {{0, 0}, {1, 1}}));
  for (const svg::PlainShape& shape : plain_.content.shapes) {
    SFUMATO_TRY(shape.fill ? extend_by({&shape, false}, tolerance, box) : ok_status());
    if (shape.stroke) SFUMATO_TRY(extend_by({&shape, true}, tolerance, box));
  }
  if (box.empty()) return ok_status();
  const svg::OpenSize& size = *plain_.open_size;
  if (!size.width && box.width() > 0) {
    artboard.min.x = box.min.x;
    artboard.max.x = box.max.x;
  }
  if (!size.height && box.height() > 0) {
    artboard.min.y = box.min.y;
    artboard.max.y = box.max.y;
  }
  tolerance_ = tolerance_for(artboard);
  return ok_status();
}

Status Importer::run() {
  Status status = plain_.open_size ? fit_artboard() : ok_status();
  return status ? paint_all() : status;
}

Status Importer::paint_all() {
  Document& document = plain_.document;
  TableMemory memory("the shapes");
  std::vector<Source> source_of;  // by layer
  SFUMATO_TRY(memory.resize(context_, source_of, document.layers.size()));
  for (const svg::PlainShape& shape : plain_.content.shapes) {
    if (shape.fill) source_of[shape.fill_layer] = {&shape, false};
    if (shape.stroke) source_of[shape.stroke_layer] = {&shape, true};
  }
  std::map<std::uint32_t, std::uint32_t> kept;  // layers of Sfumato's own attributes
  std::size_t painted = 0;
  for (const StackItem& item : document.stack) {
    if (context_.cancelled()) return context_.cancel_status();
    if (context_.progress) {
      context_.progress->report(
          "import", static_cast<double>(painted++) / static_cast<double>(document.stack.size()));
    }
    const auto* instance = std::get_if<LayerInstance>(&item);
    if (instance && source_of[instance->layer].shape) {
      SFUMATO_TRY(paint(*instance, source_of[instance->layer]));
      continue;
    }
    close_layers();
    SFUMATO_TRY(memory_.push_back(context_, stack_, item));
    forget_empty_groups();
    if (!instance) continue;
    const auto [entry, is_new] =
        kept.emplace(instance->layer, static_cast<std::uint32_t>(layers_.size()));
    if (is_new) {
      SFUMATO_TRY(
          memory_.push_back(context_, layers_, std::move(document.layers[instance->layer])));
    }
    std::get<LayerInstance>(stack_.back()).layer = entry->second;
  }
  close_layers();
  document.layers = std::move(layers_);
  document.stack = std::move(stack_);
  return validate(context_, document);
}

/// Draws the tiles of patterns and masks into their textures, those within others first.
Status paint_tiles(Context& context, svg::PlainSvg& plain, std::string_view text,
                   const std::string& file, const std::optional<TilePainter>& painter) {
  for (std::size_t i = plain.tiles.size(); i-- > 0;) {
    svg::PlainTile& tile = plain.tiles[i];
    svg::PlainSvg content{std::move(tile.document), std::move(tile.content), {}, {}, {}, {}};
    Importer importer(context, std::move(content), text, file, painter);
    SFUMATO_TRY(importer.run());
    ImportedSvg made = importer.take();
    std::ranges::move(made.warnings, std::back_inserter(plain.warnings));
    if (made.document.stack.empty()) continue;
    const bool is_top = tile.owner == 0;
    svg::PlainTile* around = is_top ? nullptr : &plain.tiles[tile.owner - 1];
    std::vector<Shader>& shaders =
        tile.use == svg::TileUse::paint
            ? (is_top ? plain.document.shaders : around->document.shaders)
            : (is_top ? plain.content.mask_shaders : around->content.mask_shaders);
    auto& texture = std::get<Texture>(shaders[tile.shader].paint);
    SFUMATO_TRY_ASSIGN(const Image& image,
                       (*painter)(context, made.document, texture.width, texture.height));
    if (image.bytes.size() != texture.rgba.size()) {
      return make_error(StatusCode::bad_input, "the painter of tiles gave no image of that size");
    }
    std::ranges::copy(image.bytes, texture.rgba.begin());
    SFUMATO_TRY(svg_import::make_opacity(context, tile.use, texture));
  }
  return ok_status();
}

Result<ImportedSvg> import_text(Context& context, std::string_view text, const std::string& file,
                                const ResourceLoader* loader,
                                const std::optional<TilePainter>& painter) {
  TableMemory memory("unpacked gzip");
  std::string unpacked;
  if (codecs::is_gzip(text)) {
    SFUMATO_TRY_ASSIGN(unpacked, codecs::gunzip(context, text, memory));
    text = unpacked;
  }
  SFUMATO_TRY_ASSIGN(auto&& plain,
                     svg::read_plain_svg(context, text, file, loader, painter.has_value()));
  Status status = painter ? paint_tiles(context, plain, text, file, painter) : ok_status();
  if (status) {
    Importer importer(context, std::move(plain), text, file, painter);
    status = importer.run();
    if (status) return importer.take();
  }
  if (status.where.file.empty()) status.where.file = file;
  return status;
}

}  // namespace

Result<ImportedSvg> import_svg(Context& context, std::string_view text, const std::string& file,
                               const ResourceLoader* loader, std::optional<TilePainter> painter) {
  return public_verb(context, [&] { return import_text(context, text, file, loader, painter); });
}

}  // namespace sfumato
