#include "cli/files/picture_file.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>

#include "base/charge.hpp"
#include "base/stopwatch.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "cli/messages.hpp"
#include "output/export_picture.hpp"
#include "output/image_output.hpp"
#include "output/output_size.hpp"
#include "picture/picture_counts.hpp"
#include "sfumato/api/render_pixels.hpp"
#include "sfumato/gpu/render.hpp"

namespace sfumato::cli {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Draws a document for one output.
class PictureMaker {
 public:
  PictureMaker(Context& context, const RenderArguments& arguments, RenderStats& stats,
               std::optional<Solution>* kept)
      : context_(context),
        arguments_(arguments),
        settings_(arguments.settings),
        stats_(stats),
        kept_(kept) {}

  Result<Bytes> make(Document& document);
  Result<Bytes> make(SolvedInput solved);

 private:
  void choose_background(std::optional<Rgb>& background) const;
  bool is_for_pixel_grid() const;
  Status choose_options(const Box& shown, Vec2 own_scale, bool has_background);
  Result<Image> draw_pixels(const Document& document);
  Result<Image> draw_picture(const Picture& picture);
  Result<const Picture*> solve(Document& document);
  Result<const Picture*> solve_kept(Document document);
  Result<Bytes> make_image(Document& document);
  Result<Bytes> make_image(const Picture& picture);
  Result<Bytes> make_drawing(const Picture& picture);
  Result<Bytes> encode(Result<Image> image);
  void warn_of_scale(double solved_scale) const;
  std::string title() const;
  void warn(const std::string& what) const;

  Context& context_;
  const RenderArguments& arguments_;
  const options::Settings& settings_;
  RenderStats& stats_;
  std::optional<Solution>* kept_;
  Picture picture_;      ///< where no solution is kept
  ScopedCharge charge_;  ///< of what is held: the document, then its picture, then the image
  DiffuseOptions diffuse_;
  RasterOptions raster_;
  double scale_ = 1;  ///< output pixels per user unit
};

/// The requested background takes precedence over the drawing's own. Formats without alpha have a
/// white background.
void PictureMaker::choose_background(std::optional<Rgb>& background) const {
  if (settings_.raster.background) background = settings_.raster.background;
  if (settings_.no_background) background.reset();
  if (!options::knows_alpha(arguments_.kind) && !background) background = Rgb{1, 1, 1};
}

/// shown: the part to draw if no other part was requested.
Status PictureMaker::choose_options(const Box& shown, Vec2 own_scale, bool has_background) {
  const Box viewport = settings_.diffuse.viewport.value_or(shown);
  scale_ = output::output_scale(settings_.size, viewport, own_scale);
  diffuse_ = settings_.diffuse;
  diffuse_.viewport = viewport;
  diffuse_.exact_fields = arguments_.kind == OutputKind::html;
  if (!options::is_image(arguments_.kind)) {
    diffuse_.pixels_per_unit = scale_ * *settings_.output.detail;
    return ok_status();
  }
  SFUMATO_TRY_ASSIGN(const output::OutputSize& size,
                     output::output_size(context_.limits, settings_.size, viewport, own_scale,
                                         settings_.window.has_value()));
  diffuse_.pixels_per_unit = size.pixels_per_unit;
  diffuse_.pixel_grid = is_for_pixel_grid();
  raster_ = settings_.raster;
  raster_.format = output::drawn_format(raster_.format, arguments_.kind, has_background);
  raster_.viewport = viewport;
  output::set_size(size, settings_.window, raster_);
  return ok_status();
}

/// Returns whether to solve only for the pixels of the image. --mesh-overlay shows the mesh of the
/// other outputs instead, and the frames of a film share one mesh.
bool PictureMaker::is_for_pixel_grid() const {
  return settings_.depth == 8 && settings_.raster.antialias && !settings_.raster.mesh_overlay &&
         settings_.method == options::Method::exact && settings_.device == options::Device::cpu &&
         !settings_.coherent;
}

void PictureMaker::warn(const std::string& what) const {
  if (arguments_.quiet) return;
  report_warning({what, {display_name(arguments_.input)}});
}

/// There is no mesh; the time outside the gather counts as raster.
Result<Image> PictureMaker::draw_pixels(const Document& document) {
  const Stopwatch watch;
  DiffuseStats& solved = stats_.diffuse;
  Result<Image> image = render_pixels(context_, document, diffuse_, raster_, &solved);
  const double rest = watch.seconds() - solved.geometry_seconds - solved.triangulation_seconds -
                      solved.gather_seconds;
  stats_.rasterise_seconds = std::max(0.0, rest);
  return image;
}

/// If no GPU is available, the CPU draws the same picture.
Result<Image> PictureMaker::draw_picture(const Picture& picture) {
  if (settings_.device == options::Device::gpu) {
    Result<Image> image = render_on_gpu(context_, picture, raster_);
    if (image || image.status().code != StatusCode::unavailable) return image;
    warn(image.status().message + "; the CPU draws instead");
  }
  return rasterize(context_, picture, raster_);
}

/// Solves the document. Only one of the document and its picture is in memory, both only while one
/// becomes the other; a solution that is kept holds both.
Result<const Picture*> PictureMaker::solve(Document& document) {
  if (kept_) return solve_kept(std::exchange(document, {}));
  SFUMATO_TRY_ASSIGN(picture_, diffuse(context_, document, diffuse_, &stats_.diffuse));
  document = {};
  charge_ = {};
  SFUMATO_TRY(charge_.add(context_, bytes_of(picture_), "the picture"));
  return &picture_;
}

/// A solution charges its own memory.
Result<const Picture*> PictureMaker::solve_kept(Document document) {
  charge_ = {};
  if (*kept_) {
    SFUMATO_TRY((*kept_)->apply(context_, ReplaceDocument{std::move(document)}));
  } else {
    SFUMATO_TRY_ASSIGN(*kept_, Solution::create(context_, std::move(document)));
  }
  if (settings_.coherent) {
    SFUMATO_TRY(
        (*kept_)->solve_next(context_, diffuse_, &stats_.layers.emplace(), &stats_.diffuse));
  } else {
    SFUMATO_TRY((*kept_)->solve(context_, diffuse_, &stats_.diffuse));
  }
  return &(*kept_)->picture();
}

Result<Bytes> PictureMaker::make_image(Document& document) {
  if (settings_.method == options::Method::pixels) return encode(draw_pixels(document));
  const Result<const Picture*> picture = solve(document);
  return picture ? make_image(**picture) : picture.status();
}

Result<Bytes> PictureMaker::make_image(const Picture& picture) {
  if (output::drops_opaque_alpha(settings_, arguments_.kind))
    raster_.format = output::needed_format(raster_.format, picture, *raster_.viewport);
  const Stopwatch watch;
  const std::uint64_t read_before = picture::count_read_points(picture);
  Result<Image> image = draw_picture(picture);
  stats_.rasterise_seconds = watch.seconds();
  stats_.diffuse.nodes += picture::count_read_points(picture) - read_before;
  picture_ = {};
  return encode(std::move(image));
}

Result<Bytes> PictureMaker::encode(Result<Image> image) {
  SFUMATO_TRY(image);
  stats_.width = image->width;
  stats_.height = image->height;
  charge_ = {};
  SFUMATO_TRY(charge_.add(context_, capacity_bytes(image->bytes), "the image"));
  const Stopwatch watch;
  if (output::drops_opaque_alpha(settings_, arguments_.kind)) {
    SFUMATO_TRY(output::drop_opaque_alpha(context_, *image));
  }
  Result<Bytes> file = output::encode_image(context_, *image, arguments_.kind, settings_.output);
  stats_.write_seconds = watch.seconds();
  return file;
}

std::string PictureMaker::title() const {
  if (!settings_.output.title.empty()) return settings_.output.title;
  if (arguments_.input == "-") return "Sfumato";
  return std::filesystem::path(arguments_.input).stem().string();
}

Result<Bytes> PictureMaker::make_drawing(const Picture& picture) {
  const Stopwatch watch;
  ExportNotes notes;
  output::DrawingOptions drawing{arguments_.kind, settings_.output, scale_, diffuse_.max_error};
  drawing.output.title = title();
  Result<Bytes> file = output::export_picture(context_, picture, drawing, &notes);
  stats_.export_seconds = watch.seconds();
  for (const std::string& lost : notes.lost) warn(lost);
  return file;
}

Result<Bytes> PictureMaker::make(Document& document) {
  choose_background(document.background);
  SFUMATO_TRY(choose_options(document.artboard, output::own_scale(document),
                             document.background.has_value()));
  SFUMATO_TRY(charge_.add(context_, bytes_of(document), "the document"));
  if (options::is_image(arguments_.kind)) return make_image(document);
  const Result<const Picture*> picture = solve(document);
  return picture ? make_drawing(**picture) : picture.status();
}

/// If no more was solved than the eye sees, blur and curves are coarser than they could be.
void PictureMaker::warn_of_scale(double solved_scale) const {
  const std::string complaint = complaint_about_scale(solved_scale, scale_);
  if (!complaint.empty()) warn(complaint);
}

Result<Bytes> PictureMaker::make(SolvedInput solved) {
  picture_ = std::move(solved.picture);
  const picture::PictureCounts counts = picture::count_tables(picture_);
  stats_.diffuse.triangles = counts.triangles;
  stats_.diffuse.vertices = counts.vertices;
  stats_.diffuse.nodes = counts.nodes;
  choose_background(picture_.background);
  SFUMATO_TRY(
      choose_options(picture_.viewport, solved.origin.own_scale, picture_.background.has_value()));
  SFUMATO_TRY(charge_.add(context_, bytes_of(picture_), "the picture"));
  diffuse_.max_error = solved.origin.max_error;
  warn_of_scale(solved.origin.pixels_per_unit);
  return options::is_image(arguments_.kind) ? make_image(picture_) : make_drawing(picture_);
}

}  // namespace

Result<Bytes> make_picture_file(Context& context, Document& document,
                                const RenderArguments& arguments, RenderStats& stats,
                                std::optional<Solution>* kept) {
  return PictureMaker(context, arguments, stats, kept).make(document);
}

Result<Bytes> make_picture_file(Context& context, SolvedInput solved,
                                const RenderArguments& arguments, RenderStats& stats) {
  return PictureMaker(context, arguments, stats, nullptr).make(std::move(solved));
}

}  // namespace sfumato::cli
