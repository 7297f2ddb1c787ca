#include "options/settle.hpp"

#include <array>
#include <span>

namespace sfumato::options {
namespace {

constexpr double kMaxErrorOf16Bits = 0.25;
constexpr int kDefaultQuality = 90;

/// A rule: what must hold, and the conflict where it does not.
struct Rule {
  bool holds;
  Conflict conflict;
};

Conflict first_broken(std::span<const Rule> rules) {
  for (const Rule& rule : rules) {
    if (!rule.holds) return rule.conflict;
  }
  return {};
}

/// Returns the first given option that only pages and meshes have.
Conflict conflict_without_page(const Settings& given) {
  constexpr std::string_view kComplaint = "works with HTML, PDF, EPS, SVG and GLB only";
  return first_broken(std::array<Rule, 3>{{{!given.output.detail, {"@detail", kComplaint}},
                                           {!given.output.dpi, {"@dpi", kComplaint}},
                                           {given.output.title.empty(), {"@title", kComplaint}}}});
}

std::string_view dither_key(const Settings& given) {
  return given.dither.value_or(true) ? "@dither" : "@no-dither";
}

/// Returns the first given option that only images have.
Conflict conflict_with_drawing(const Settings& given) {
  constexpr std::string_view kComplaint = "works with images only, such as PNG, JPEG and WebP";
  return first_broken(std::array<Rule, 7>{
      {{given.method != Method::pixels, {"@method=pixels", kComplaint}},
       {!given.window, {"@window", kComplaint}},
       {given.device == Device::cpu, {"@device=gpu", kComplaint}},
       {!given.raster.mesh_overlay, {"@mesh-overlay", kComplaint}},
       {!given.dither, {dither_key(given), kComplaint}},
       {given.raster.antialias, {"@no-antialias", kComplaint}},
       {!(given.size.width && given.size.height),
        {"@height", "cannot be combined with @width here: only images are stretched"}}}});
}

/// Returns the bits of a channel. The names of raw frames determine them.
int bits(const Settings& given, OutputKind kind) {
  return is_deep_frame(kind) ? 16 : given.depth;
}

/// Returns the first given option that this format does not have.
Conflict conflict_with_format(const Settings& given, OutputKind kind) {
  const OutputOptions& output = given.output;
  const bool is_svg = kind == OutputKind::svg, is_webp = kind == OutputKind::webp;
  const bool has_quality = kind == OutputKind::jpeg || (is_webp && !output.lossless);
  const bool takes_depth = kind == OutputKind::png || is_deep_frame(kind);
  return first_broken(std::array<Rule, 8>{
      {{is_svg || !output.svg, {"@svg", "works with SVG only"}},
       {!output.force || (is_svg && output.svg == SvgMode::vector),
        {"@force", "works with @svg=vector only"}},
       {!output.lossless || is_webp, {"@lossless", "works with WebP only"}},
       {!output.quality || has_quality, {"@quality", "works with JPEG and lossy WebP only"}},
       {given.depth == 8 || takes_depth,
        {"@depth", is_frame(kind) ? "16 bits given, which works with PNG, rgb48le and rgba64le only"
                                  : "16 bits given, which works with PNG only"}},
       {!given.no_background || kind != OutputKind::jpeg,
        {"@background", "JPEG has no alpha channel; use an opaque colour"}},
       {!given.no_background || !is_frame(kind) || knows_alpha(kind),
        {"@background",
         "these frames have no alpha channel; use an opaque colour, or rgba or rgba64le"}},
       {!given.dither || bits(given, kind) == 8,
        {dither_key(given), "works with @depth=8 only"}}}});
}

Conflict conflict_among(const Settings& given) {
  const bool has_mesh = given.method != Method::pixels;
  return first_broken(
      std::array<Rule, 6>{{{!given.size.scale || !(given.size.width || given.size.height),
                            {"@scale", "cannot be combined with @width and @height"}},
                           {!given.raster.mesh_overlay || has_mesh,
                            {"@mesh-overlay", "@method=pixels has no mesh to draw"}},
                           {!given.coherent || given.method == Method::exact,
                            {"@coherent", "works with @method=exact only"}},
                           {given.gather == Device::cpu || given.method != Method::rays,
                            {"@gather", "@method=rays runs on the CPU only"}},
                           {given.device == Device::cpu || has_mesh,
                            {"@device", "@method=pixels runs on the CPU only"}},
                           {given.device == Device::cpu || !given.window,
                            {"@device", "@window is drawn on the CPU only"}}}});
}

}  // namespace

Conflict find_conflict(const Settings& given, OutputKind kind) {
  Conflict found;
  if (!is_image(kind)) found = conflict_with_drawing(given);
  if (found.key.empty() && (is_image(kind) || is_table(kind))) found = conflict_without_page(given);
  if (found.key.empty()) found = conflict_with_format(given, kind);
  return found.key.empty() ? conflict_among(given) : found;
}

Conflict find_solve_conflict(const Settings& given) {
  if (given.method == Method::pixels) {
    return {"@method=pixels", "makes no solved picture; use exact or rays"};
  }
  return conflict_among(given);
}

void settle(Settings& settings, OutputKind kind) {
  OutputOptions& output = settings.output;
  output.quality = output.quality.value_or(kDefaultQuality);
  output.svg = output.svg.value_or(SvgMode::image);
  // Triangles of a vector SVG are expensive.
  output.detail = output.detail.value_or(*output.svg == SvgMode::vector || is_table(kind) ? 1 : 2);
  // A JPEG keeps too little of the noise to be worth its bytes.
  const bool is_jpeg = kind == OutputKind::jpeg;
  settings.depth = bits(settings, kind);
  settings.raster.dither = settings.depth == 8 && settings.dither.value_or(!is_jpeg);
  settings.raster.format = settings.depth == 8 ? PixelFormat::rgb8 : PixelFormat::rgb16;
  // An error of one 8-bit code value shows in 16 bits, which have 257 steps for each.
  if (settings.depth == 16 && !settings.sets_max_error) {
    settings.diffuse.max_error = kMaxErrorOf16Bits;
  }
}

}  // namespace sfumato::options
