#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato {

/// The source of the blur radii of curves.
enum class TraceBlur : std::uint8_t {
  fitted,     ///< from the picture, then improved together with the colours
  estimated,  ///< from the picture alone
  sharp       ///< no blur
};

/// The amount of colour stops that are left out, least useful first.
enum class TraceStops : std::uint8_t {
  few,     ///< about 60 in 100
  normal,  ///< about 35 in 100
  many     ///< none
};

/// The progress of a trace.
struct TraceState {
  int round = 0;                   ///< 0: only edges of the picture; then edges that are missing
  int round_count = 0;             ///< largest number of rounds, including round 0
  std::size_t curves = 0;          ///< including the frame along the picture's border
  std::size_t control_points = 0;  ///< 3 n + 1 of each curve of n Bézier pieces
  std::size_t stops = 0;           ///< colours on all sides
  /// 10 log₁₀ (1 / the mean square difference of sRGB code values from 0 to 1) to the picture at
  /// the size of the trace, as the gather predicts it at the fitted pixels. Where the picture has
  /// opacity, the squares of colours are multiplied by the square of opacity, and the squares of
  /// opacity are added: about the look on the background where it differs most.
  double psnr_db = 0;
  double seconds = 0;  ///< since the start
};

/// Receives the progress of a trace, after each round, on the thread that called. It also receives
/// a first drawing when the edges of the picture are found: its colours are sampled and not fitted
/// yet, and TraceState::psnr_db is 0.
class TraceWatch {
 public:
  virtual ~TraceWatch() = default;
  /// Receives the state. `drawing` is the result of trace() if it ended here, except that no stops
  /// are left out.
  virtual void reached(const TraceState& state, const Document& drawing) = 0;
};

/// Options of trace(). The defaults suit photos.
struct TraceOptions {
  /// The largest smooth_px.
  static constexpr double kMostSmooth = 32;

  /// Largest number of control points, including the frame; 0: 2,000 for a picture of 640 × 480,
  /// and in proportion to the square root of the number of pixels for others.
  int points = 0;
  int max_curves = 0;  ///< largest number of curves, including the frame; 0: no limit
  double psnr_db = 0;  ///< ends as soon as this is reached; 0: never
  /// Begins no further round after this time; 0: no limit. Context::deadline ends running work: the
  /// result is then the drawing of the last complete round, or the error if there is none.
  double max_seconds = 0;
  TraceBlur blur = TraceBlur::fitted;     ///< the source of blur radii
  TraceStops stops = TraceStops::normal;  ///< the amount that is left out
  /// Standard deviation of a Gaussian, pixels of the picture: finer details count as texture, which
  /// no curve follows; 0: no texture.
  double smooth_px = 0;
  /// Longer side in pixels of the traced picture: a larger one is scaled down. The drawing always
  /// has the size of the picture.
  int max_side = 1024;
  std::uint64_t seed = 0;   ///< for the choice of pixels that colours are fitted to
  bool edges_only = false;  ///< ends after round 0: a draft
  bool has_opacity = true;  ///< draw transparency as opacity; else put the picture on white
  /// Whether the details that the curves miss become a texture, in a separate layer on top, blended
  /// by hard light: one texel for each traced pixel. Use it with few curves to keep all details;
  /// its file is about as large as the picture's as PNG.
  bool has_texture = false;
  TraceWatch* watch = nullptr;  ///< null: no reports
};

/// Figures of a trace.
struct TraceStats {
  std::vector<TraceState> rounds;  ///< after each round, and last as returned
  bool ended_early = false;        ///< time was over: another machine may give another drawing
  double scale = 1;                ///< traced pixels per pixel of the picture
  double noise = 0;                ///< standard deviation of the picture's noise, OKLab L
  double median_length_px = 0;     ///< of the curves, without the frame, pixels of the picture
  /// The number of most useful curves that together make 9/10 of the improvement.
  std::size_t curves_of_nine_tenths = 0;
  /// With TraceOptions::has_texture: TraceState::psnr_db of the drawing with its texture, as
  /// rasterize() draws it, against the picture's opaque pixels. The rounds count the drawing
  /// without texture.
  std::optional<double> textured_psnr_db{};
  /// For a picture of thin strokes, such as a page of text: about how many control points
  /// that all strokes need, if that is more than the limit; otherwise 0.
  std::size_t points_needed = 0;
};

/// Makes a drawing of a picture: curves along its edges, with colours and blur radii fitted to the
/// picture (docs/tracing.md; method of Orzan et al. 2008, with least squares through the exact
/// gather instead of sampled colours).
///
/// The drawing's artboard is the picture, one user unit for a pixel. Its layer has a frame along
/// the border, with colours on its inner side, and below that the curves in the order of their
/// discovery; TraceOptions::has_texture adds a layer. The same picture and options make the same
/// drawing for any threads and instruction set, unless max_seconds ends it.
///
/// Errors: bad_input (options out of range, a picture that is not valid), limit, cancelled,
/// out_of_memory. Where Context::deadline passes after a complete round, the result is that round's
/// drawing, without texture, and TraceStats::ended_early is true.
/// Cost: 640 × 480 pixels and 2,000 control points take a few seconds on two cores, most of it for
/// rows of the gather. The number of control points bounds the stops, the fitted pixels and the
/// equations for any picture; edges are searched in all pixels.
Result<Document> trace(Context& context, const Image& picture, const TraceOptions& options = {},
                       TraceStats* stats = nullptr);

/// A curve of a drawing by its numbers.
struct CurveOfLayer {
  std::uint32_t layer = 0;  ///< index into Document::layers
  std::uint32_t curve = 0;  ///< index into Layer::curves

  /// Compares all members exactly.
  friend bool operator==(const CurveOfLayer&, const CurveOfLayer&) = default;
};

/// Options of fit_colors().
struct ColorFit {
  /// fitted: each curve's radii of blur are multiplied by a factor of the curve; else they stay.
  TraceBlur blur = TraceBlur::fitted;  ///< the source of blur radii
  int max_side = 1024;                 ///< as TraceOptions, 1 to limits::kImageSide
  std::uint64_t seed = 0;              ///< as TraceOptions
  bool keeps_colors = false;           ///< only radii are fitted
  /// The curves that are fitted, others stay as they are; empty: all.
  std::vector<CurveOfLayer> only{};

  /// Compares all members exactly.
  friend bool operator==(const ColorFit&, const ColorFit&) = default;
};

/// Fits the colours of a drawing's stops to a picture that fills its artboard, so that the drawing
/// looks as similar as possible. A transparent picture is put on the drawing's background, or if
/// there is none on white.
///
/// All layers are fitted at once, through all layers above them, by least squares of code values
/// (docs/mathematics.md, "Colours from a picture"). Only colours of stops change, to ones of 8
/// bits, and radii if they are fitted. These stay as they are:
///
/// - curves, places of stops, opacities, image-domain shaders, local curves, the stack, the
///   background: the fit takes them as they are
/// - stops that the picture does not show, as in a layer below an opaque one
/// - layers that are mixed by another mode than normal anywhere, themselves or in a group. Layers
///   below `multiply` and `screen` outside of groups are fitted through them. Where another mode
///   shows, or one within a group, nothing is fitted to the pixels
/// - the radii of curves that have opacity, and of curves without blur
///
/// Returns the drawing unchanged if no colours look more similar. The same input gives the same
/// drawing, for any threads and instruction set.
///
/// - `stats`: unless null, receives `scale`, and two rounds, before and after the fit, whose
///   numbers count the painted layers
///
/// Errors: bad_input (options out of range, an invalid picture or drawing, no painted curve has
/// colours, an unknown curve in `only`), limit, cancelled, out_of_memory.
/// Cost: for each instance a gather of 1 to 4 µs at each of about 60,000 to 100,000 points where it
/// may show, and a quarter of a second for the equations of 4,000 stops, three times; in other
/// spaces than sRGB several times that. On one core drawings of 100 to 500 curves take 0.5 to 10 s.
Result<Document> fit_colors(Context& context, const Document& drawing, const Image& picture,
                            const ColorFit& options = {}, TraceStats* stats = nullptr);

}  // namespace sfumato
