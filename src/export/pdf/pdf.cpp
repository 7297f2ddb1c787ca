#include "sfumato/export/pdf/pdf.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <tuple>
#include <utility>
#include <variant>

#include "base/public_verb.hpp"
#include "base/try.hpp"
#include "export/page.hpp"
#include "export/pdf/pdf_content.hpp"
#include "export/pdf/pdf_layer.hpp"
#include "export/pdf/pdf_paint.hpp"
#include "export/pixel_part.hpp"
#include "picture/check_picture.hpp"

namespace sfumato {
namespace outputs {
namespace {

using Resource = PdfContent::Resource;

/// The largest side of a page in its own units; larger pages have larger units.
constexpr double kMostPageUnits = 14400;

/// Poppler's Splash takes 0.4 to 1 ms for a patch (34,000 of blur.svg 13 s): more of them are too
/// many…
constexpr double kManyPatches = 50'000;
/// …and so few a matter of seconds.
constexpr double kFewPatches = 10'000;

bool is_composited(float opacity, BlendMode blend) {
  return opacity < 1 || blend != BlendMode::normal;
}

/// The paint of a layer's instance: its colours, its opacity, and a mask for each shader.
double painted_patches(const PatchLayer& layer) {
  const std::size_t meshes = 1 + (layer.opacity.channel_count > 0 ? 1 : 0) +
                             layer.color.shader.size() + layer.opacity.shader.size();
  return 1.0 * layer.triangle_count() * static_cast<double>(meshes);
}

/// Writes a picture's stack, bottom first.
class PdfWriter {
 public:
  PdfWriter(Context& context, const Picture& picture, const PdfOptions& options,
            double points_per_unit, ExportNotes* notes)
      : context_(context),
        picture_(picture),
        options_(options),
        points_per_unit_(points_per_unit),
        notes_(notes),
        file_(context) {
    levels_.push_back({{}, PdfContent(context)});
  }

  Result<std::vector<std::uint8_t>> write();

  void operator()(const PatchInstance& instance);
  void operator()(const LocalStroke&) { ++stroke_count_; }
  void operator()(const GroupBegin& group);
  void operator()(const GroupEnd&);

 private:
  void add_layers();
  void choose_pixels(const std::vector<double>& patches, std::vector<PdfLayerOptions>* layers);
  void paint_strokes();
  void add_state(float opacity, BlendMode blend, std::string* operators);
  void paint_background();
  void begin_page();
  PdfRef add_page();

  /// An open group and its content; the first is the page.
  struct Level {
    GroupBegin group;
    PdfContent content;
  };

  Context& context_;
  const Picture& picture_;
  const PdfOptions& options_;
  double points_per_unit_;
  ExportNotes* notes_;
  PdfFile file_;
  std::vector<PdfRef> layer_;  ///< 0: shows nothing
  std::vector<std::tuple<float, BlendMode, PdfRef>> states_;
  std::vector<Level> levels_;
  std::size_t item_ = 0;          ///< of the stack
  std::size_t stroke_count_ = 0;  ///< local curves before it that are not painted yet
};

/// Layers that are painted, each for its largest instance.
void PdfWriter::add_layers() {
  std::vector<PdfLayerOptions> layers(picture_.layers.size());
  std::vector<double> patches(picture_.layers.size(), 0.0);  // that are painted, all instances'
  for (PdfLayerOptions& layer : layers) {
    layer = {options_.max_error / 255, 0, options_.dpi, false,
             options_.flatten == PdfFlatten::always};
  }
  for (const PictureItem& item : picture_.stack) {
    const PatchInstance* instance = std::get_if<PatchInstance>(&item);
    if (!instance) continue;
    PdfLayerOptions& layer = layers[instance->layer];
    const double scale = instance_scale(instance->artboard_from_layer);
    layer.points_per_unit = std::max(layer.points_per_unit, scale * points_per_unit_);
    patches[instance->layer] += painted_patches(picture_.layers[instance->layer]);
    layer.is_group = layer.is_group || is_composited(instance->opacity, instance->blend);
  }
  if (options_.flatten == PdfFlatten::automatic) choose_pixels(patches, &layers);
  for (std::uint32_t i = 0; i < layers.size(); ++i) {
    const bool is_seen = layers[i].points_per_unit > 0 && std::isfinite(layers[i].points_per_unit);
    layer_.push_back(is_seen ? add_layer(context_, &file_, picture_, i, layers[i], notes_) : 0);
  }
}

/// Where there are many patches, makes the layers that paint most of them pixels until few are
/// left.
void PdfWriter::choose_pixels(const std::vector<double>& patches,
                              std::vector<PdfLayerOptions>* layers) {
  double rest = std::accumulate(patches.begin(), patches.end(), 0.0);
  if (rest <= kManyPatches) return;
  std::vector<std::size_t> order(patches.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return patches[i]; });
  std::size_t count = 0;
  for (; rest > kFewPatches && count < order.size(); ++count) {
    (*layers)[order[count]].as_pixels = true;
    rest -= patches[order[count]];
  }
  notes_->lost.push_back(std::to_string(count) + (count == 1 ? " layer is" : " layers are") +
                         " stored as pixels: as triangles they would take some programs minutes");
}

/// Appends "/R12 gs " where an item is not just painted over the rest.
void PdfWriter::add_state(float opacity, BlendMode blend, std::string* operators) {
  if (!is_composited(opacity, blend)) return;
  const auto same = std::find_if(states_.begin(), states_.end(), [&](const auto& state) {
    return std::get<0>(state) == opacity && std::get<1>(state) == blend;
  });
  PdfRef ref = same == states_.end() ? 0 : std::get<2>(*same);
  if (ref == 0) {
    ref = add_compositing(&file_, opacity, blend);
    states_.emplace_back(opacity, blend, ref);
  }
  *operators += levels_.back().content.name(Resource::graphics_state, ref) + " gs ";
}

void PdfWriter::operator()(const PatchInstance& instance) {
  paint_strokes();
  const PdfRef layer = layer_[instance.layer];
  if (layer == 0) return;
  PdfContent& content = levels_.back().content;
  std::string operators = "q ";
  add_state(instance.opacity, instance.blend, &operators);
  if (!(instance.artboard_from_layer == Affine{}))
    operators += pdf_matrix(instance.artboard_from_layer) + " cm ";
  content.add(operators + content.name(Resource::form, layer) + " Do Q");
}

void PdfWriter::operator()(const GroupBegin& group) {
  paint_strokes();
  levels_.push_back({group, PdfContent(context_)});
}

void PdfWriter::operator()(const GroupEnd&) {
  paint_strokes();
  const Level level = std::move(levels_.back());
  levels_.pop_back();
  if (level.content.empty()) return;
  const PdfRef form = level.content.make_form(&file_, picture_.viewport, true);
  PdfContent& content = levels_.back().content;
  std::string operators = "q ";
  add_state(level.group.opacity, level.group.blend, &operators);
  content.add(operators + content.name(Resource::form, form) + " Do Q");
}

/// Local curves that follow one another are one image.
void PdfWriter::paint_strokes() {
  if (stroke_count_ == 0) return;
  const auto strokes = std::span(picture_.stack).subspan(item_ - stroke_count_, stroke_count_);
  stroke_count_ = 0;
  const Result<PixelPart> part =
      stroke_pixels(context_, strokes, picture_.interpolation, picture_.viewport,
                    points_per_unit_ * options_.dpi / 72);
  if (!part) return file_.fail(part.status());
  if (part->box.empty()) return;
  paint_image(add_image(context_, &file_, part->image), part->box, &levels_.back().content);
}

void PdfWriter::paint_background() {
  if (!picture_.background) return;
  const Rgb& color = *picture_.background;
  const Box& box = picture_.viewport;
  levels_.back().content.add(pdf_number(color.r) + " " + pdf_number(color.g) + " " +
                             pdf_number(color.b) + " rg " + pdf_number(box.min.x) + " " +
                             pdf_number(box.min.y) + " " + pdf_number(box.width()) + " " +
                             pdf_number(box.height()) + " re f");
}

/// Returns how much larger than a point the page's unit is.
double user_unit_of(const Page& page) {
  return std::max(1.0, std::max(page.width, page.height) / kMostPageUnits);
}

void PdfWriter::begin_page() {
  const Page page = make_page(picture_.viewport, points_per_unit_);
  const double scale = 1 / user_unit_of(page);
  const Affine up{scale, 0, 0, -scale, 0, page.height / user_unit_of(page)};
  levels_.front().content.add("q " + pdf_matrix(up * page.page_from_artboard) + " cm");
  paint_background();
}

PdfRef PdfWriter::add_page() {
  const Page page = make_page(picture_.viewport, points_per_unit_);
  const double user_unit = user_unit_of(page);
  const Vec2 size{page.width / user_unit, page.height / user_unit};
  PdfContent& content = levels_.front().content;
  content.add("Q");
  if (!content.status()) file_.fail(content.status());
  const PdfRef stream = file_.add_stream("", content.text());
  std::string object = "<< /Type /Page /Parent " + pdf_reference(stream + 2) + " /MediaBox " +
                       pdf_rectangle({{0, 0}, size});
  if (user_unit > 1) object += " /UserUnit " + pdf_number(user_unit);
  object += " /Group << /S /Transparency /CS /DeviceRGB >> /Contents " + pdf_reference(stream) +
            " " + content.resources() + " >>";
  return file_.add(object);
}

Result<std::vector<std::uint8_t>> PdfWriter::write() {
  add_layers();
  begin_page();
  for (; item_ < picture_.stack.size(); ++item_) {
    if (!file_.status()) return file_.status();
    std::visit(*this, picture_.stack[item_]);
  }
  paint_strokes();
  const PdfRef page = add_page();
  const PdfRef pages = file_.add("<< /Type /Pages /Count 1 /Kids [" + pdf_reference(page) + "] >>");
  const PdfRef root = file_.add("<< /Type /Catalog /Pages " + pdf_reference(pages) + " >>");
  std::string info = "<< /Producer (Sfumato)";
  if (!options_.title.empty()) info += " /Title " + pdf_text(options_.title);
  return file_.finish(root, file_.add(info + " >>"));
}

Status check(const Context& context, const Picture& picture, const PdfOptions& options) {
  SFUMATO_TRY(check_viewport(picture.viewport));
  if (!(options.page_width_pt.value_or(1) > 0))
    return make_error(StatusCode::bad_input, "the width of a page must be a positive number");
  if (!is_positive(options.dpi) || !is_positive(options.max_error))
    return make_error(StatusCode::bad_input,
                      "the resolution and the error must be positive numbers");
  if (options.flatten > PdfFlatten::never)
    return make_error(StatusCode::bad_input, "an unknown way to flatten a PDF");
  SFUMATO_TRY(
      check_page(picture.viewport, points_per_unit(options.page_width_pt, picture.viewport)));
  return picture::check_picture(context, picture);
}

Result<std::vector<std::uint8_t>> write(Context& context, const Picture& picture,
                                        const PdfOptions& options, ExportNotes* notes) {
  SFUMATO_TRY(check(context, picture, options));
  ExportNotes unread;
  return PdfWriter(context, picture, options,
                   points_per_unit(options.page_width_pt, picture.viewport),
                   notes ? notes : &unread)
      .write();
}

}  // namespace
}  // namespace outputs

Result<std::vector<std::uint8_t>> export_pdf(Context& context, const Picture& picture,
                                             const PdfOptions& options, ExportNotes* notes) {
  return public_verb(context, [&] { return outputs::write(context, picture, options, notes); });
}

}  // namespace sfumato
