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

/// Where the blur radii of curves come from.
enum class TraceBlur : std::uint8_t {
  fitted,     ///< from the picture, then improved together with the colours
  estimated,  ///< from the picture alone
  sharp       ///< there are none
};

/// How many of the colour stops that do least for the picture are left out.
enum class TraceStops : std::uint8_t {
  few,     ///< about 60 in 100
  normal,  ///< about 35 in 100
  many     ///< none
};

/// What a trace has reached.
struct TraceState {
  int round = 0;                   ///< 0: only edges of the picture; then edges of what is missing
  int round_count = 0;             ///< rounds that there will be at most, with round 0
  std::size_t curves = 0;          ///< the frame along the picture's border included
  std::size_t control_points = 0;  ///< 3 n + 1 of each curve of n Bézier pieces
  std::size_t stops = 0;           ///< colours on all sides
  /// 10 log₁₀ (1 / the mean square difference of sRGB code values from 0 to 1) to the picture at
  /// the size it is traced at, as the gather predicts it at the pixels that were fitted.
  double psnr_db = 0;
  double seconds = 0;  ///< since the beginning
};

/// Is told what a trace has reached, after each round, from the thread that called. Once before
/// that, too, when edges of the picture were found: their colours are sampled and not fitted yet,
/// and TraceState::psnr_db is 0.
class TraceWatch {
 public:
  virtual ~TraceWatch() = default;
  /// `drawing` is what trace() would return if it ended here, but that no stops are left out.
  virtual void reached(const TraceState& state, const Document& drawing) = 0;
};

/// How to trace(). The defaults suit photos.
struct TraceOptions {
  /// The largest smooth_px.
  static constexpr double kMostSmooth = 32;

  /// Control points at most, with those of the frame; 0: 2,000 for a picture of 640 × 480, and in
  /// proportion to the square root of the number of pixels for others.
  int points = 0;
  int max_curves = 0;                     ///< curves at most, with the frame; 0: no limit
  double psnr_db = 0;                     ///< ends as soon as this is reached; 0: never
  double max_seconds = 0;                 ///< begins no further round after this time; 0: no limit
  TraceBlur blur = TraceBlur::fitted;     ///< where it comes from
  TraceStops stops = TraceStops::normal;  ///< how many are left out
  /// Standard deviation of a Gaussian, pixels of the picture: what is finer is taken as texture,
  /// which no curve follows; 0: none is.
  double smooth_px = 0;
  /// Longer side in pixels at which the picture is looked at: a larger one is scaled down. The
  /// drawing has the size of the picture in any case.
  int max_side = 1024;
  std::uint64_t seed = 0;   ///< of the choice of pixels that colours are fitted to
  bool edges_only = false;  ///< ends after round 0: a draft
  bool has_opacity = true;  ///< transparent pictures become drawings with opacity; else as on white
  /// What the curves miss becomes a texture, in a layer of its own on top, which is blended by hard
  /// light: a texel to a pixel looked at. With few curves, it bears what these leave out; its file
  /// is about as large as the picture's as PNG.
  bool has_texture = false;
  TraceWatch* watch = nullptr;  ///< null: nobody is told
};

/// How a trace went.
struct TraceStats {
  std::vector<TraceState> rounds;  ///< after each round, and last as returned
  double scale = 1;                ///< pixels looked at per pixel of the picture
  double noise = 0;                ///< standard deviation of the picture's noise, OKLab L
  double median_length_px = 0;     ///< of the curves, without the frame, pixels of the picture
  /// How many curves, those of most benefit first, bear 9/10 of the benefit.
  std::size_t curves_of_nine_tenths = 0;
  /// With TraceOptions::has_texture: as TraceState::psnr_db, but of the drawing with its texture,
  /// as rasterize() draws it, to the picture's opaque pixels. The rounds are those without it.
  std::optional<double> textured_psnr_db{};
};

/// Makes a drawing of a picture: curves along its edges, whose colours and radii of blur are fitted
/// so that the drawing looks like it (docs/tracing.md; method of Orzan et al. 2008, with least
/// squares through the exact gather in place of sampled colours).
///
/// The drawing's artboard is the picture, a user unit to a pixel; its layer has a frame along the
/// border, whose inner side bears colours, and below that the curves in the order in which they
/// were found; TraceOptions::has_texture adds a layer. The same picture and options make the same
/// drawing, whatever the threads and the instruction set, but for max_seconds.
///
/// Errors: bad_input (options out of range, a picture that is not valid), limit, cancelled,
/// out_of_memory.
/// Cost: 640 × 480 pixels and 2,000 control points take a few seconds on two cores, most of it for
/// rows of the gather; in proportion to the pixels looked at.
Result<Document> trace(Context& context, const Image& picture, const TraceOptions& options = {},
                       TraceStats* stats = nullptr);

/// A curve of a drawing by its numbers.
struct CurveOfLayer {
  std::uint32_t layer = 0;  ///< index into Document::layers
  std::uint32_t curve = 0;  ///< index into Layer::curves

  /// Exact comparison of all members.
  friend bool operator==(const CurveOfLayer&, const CurveOfLayer&) = default;
};

/// How fit_colors() changes a drawing.
struct ColorFit {
  /// fitted: each curve's radii of blur are multiplied by a number of its own; else they stay.
  TraceBlur blur = TraceBlur::fitted;  ///< where it comes from
  int max_side = 1024;                 ///< as TraceOptions, 1 to limits::kImageSide
  std::uint64_t seed = 0;              ///< as TraceOptions
  bool keeps_colors = false;           ///< radii alone are fitted
  /// The curves that are fitted, others stay as they are; empty: all.
  std::vector<CurveOfLayer> only{};

  /// Exact comparison of all members.
  friend bool operator==(const ColorFit&, const ColorFit&) = default;
};

/// Gives the stops of a drawing's curves the colours with which it looks most like a picture, which
/// is laid over its artboard and fills it. A transparent picture counts as it looks on the
/// drawing's background, or if there is none on white.
///
/// All layers are fitted at once, through all that lies above them, by least squares of code values
/// (docs/mathematics.md, "Colours from a picture"). Only colours of stops change, to ones of 8
/// bits, and radii if they are fitted. These stay as they are:
///
/// - curves, places of stops, opacities, image-domain shaders, local curves, the stack, the
///   background: they are looked past
/// - stops of which the picture shows nothing, as in a layer below an opaque one
/// - layers that are anywhere mixed with those below by another mode than normal, themselves or in
/// a
///   group. What lies below `multiply` and `screen` outside of groups is fitted through them. Where
///   another mode shows, or one within a group, nothing is fitted to the pixels
/// - the radii of curves that bear opacity, and of those without blur
///
/// If nothing looks more like the picture, the drawing is returned as it is.
///
/// The same input gives the same drawing, whatever the threads and the instruction set.
///
/// stats    unless null: `scale`, and two rounds, the drawing as it was and as returned, whose
///          numbers are those of the layers that are painted
/// Errors   bad_input (options out of range, a picture or a drawing that is not valid, no curve
/// that
///          is painted has colours, a curve of `only` that is not there), limit, cancelled,
///          out_of_memory
/// Cost     for each instance a gather of 1 to 4 µs at each of about 60,000 to 100,000 points at
///          which it may show, and a quarter of a second for the equations of 4,000 stops, thrice;
///          in other spaces than sRGB several times that. On one core drawings of 100 to 500 curves
///          take 0.5 to 10 s
Result<Document> fit_colors(Context& context, const Document& drawing, const Image& picture,
                            const ColorFit& options = {}, TraceStats* stats = nullptr);

}  // namespace sfumato
