#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/trace/trace.hpp"
#include "trace/curves/drawing_layers.hpp"
#include "trace/fit/sparse.hpp"
#include "trace/fit/stack_points.hpp"
#include "trace/fit/stop_ranges.hpp"
#include "trace/image/picture.hpp"
#include "trace/image/sample_pixels.hpp"

namespace sfumato::tracing {

/// Fits the colours of an existing drawing's stops, and factors of its radii of blur, to a picture.
///
/// A pixel shows an instance's colour times a coefficient. The colour is linear in the stops in the
/// drawing's interpolation space. Every instance gets, in that space, the change of its present
/// colour that adds the pixel's missing code values; all instances get the same change. In sRGB
/// that is least squares for all layers at once. In another space it is least squares in that space
/// where pixels show one layer alone, and elsewhere a step towards the missing values, after which
/// improve_colors() minimises the squares of code values.
class StopFit {
 public:
  /// picture   opaque: code values as the drawing is to look
  /// drawing   a valid one
  /// only      the curves that are fitted, all of them there; empty: all
  /// All outlive this.
  StopFit(Context& context, const Picture& picture, const Document& drawing,
          std::span<const CurveOfLayer> only);

  /// Gathers the rows of pixels. backdrop: behind all items. Errors: limit, cancelled.
  Status prepare(const Rgb& backdrop, std::uint64_t seed);

  /// Solves once for all stops. Precondition of this and the following functions: prepare(). Errors
  /// of all: limit (memory), cancelled.
  Status fit_colors();

  /// One step of Gauss and Newton's method for the colours of all stops, for a space other than
  /// sRGB. Precondition: fit_colors().
  Status improve_colors();

  /// One step of Gauss and Newton's method for the factors of radii.
  Status fit_radii();

  /// Takes colours and radii from a drawing that differs in nothing else.
  Status look_at(const Document& drawing);

  /// Writes the results to a copy of the drawing, in short numbers. Stops that the picture does not
  /// show stay.
  Status write(Document& drawing) const;

  /// As TraceState::psnr_db, of the values that were found or taken last.
  double psnr_db() const { return psnr_db_; }

 private:
  /// Pixels.
  static constexpr float kLeastWeight = 1e-3f;
  /// Weights of the two regularisers of colours.
  static constexpr float kPull = 0.3f;
  static constexpr float kEven = 0.3f;

  /// The derivative of code value c by coordinate k is at 3 c + k.
  using Slopes = std::array<float, 9>;

  /// The part of an instance that a point shows.
  struct Part {
    std::uint32_t shown;  ///< index into StackPoints::shown
    std::uint32_t row;    ///< of its rows
  };
  /// The code values that a pixel lacks.
  struct Missing {
    FourFloats code;   ///< in code values
    FourFloats color;  ///< in the interpolation space
  };

  Status choose_points(std::uint64_t seed);
  Status list_stops();
  Status choose_curves();
  Status list_parts();
  Status list_moving_curves();
  Status convert_picture();
  Status count_weights();
  Status find_bounds();
  Status narrow_bounds(std::uint32_t layer, SolidBlocks& blocks, std::vector<float>& counts);
  Status build_matrix();
  Status find_missing();
  Missing missing_of(std::size_t pixel) const;
  double radius_of(const ShownInstance& shown, const gather::RowSource& source,
                   const gather::RowTerm& term) const;
  Rgb color_of(const Part& part) const;
  void add_radius_terms(const Part& part, double share, std::size_t channel, RowSummer& sum) const;
  Result<SparseMatrix> radius_rows() const;
  Status find_slopes(std::span<Slopes> slopes) const;
  Result<SparseMatrix> slope_rows() const;

  /// Calls visit(part, share, coefficient) for all parts that a pixel shows: the share of the pixel
  /// that shows the part, and the part's weight there.
  template <class Visit>
  void for_each_part(std::size_t pixel, Visit&& visit) const {
    const std::uint32_t first = pixels_.point_begin[pixel], end = pixels_.point_begin[pixel + 1];
    for (std::uint32_t k = part_begin_[first]; k < part_begin_[end]; ++k) {
      const Part& part = part_[k];
      visit(part, 1.0 / (end - first), points_.shown[part.shown].coefficient[part.row]);
    }
  }
  /// Calls visit(column, weight) for the fitted stops that give a part its colour.
  template <class Visit>
  void for_each_stop(const Part& part, Visit&& visit) const {
    const ShownInstance& shown = points_.shown[part.shown];
    const std::uint32_t first = first_stop_[shown.layer];
    const gather::Rows& rows = shown.sight.rows;
    for (std::uint32_t k = rows.begin[part.row]; k < rows.begin[part.row + 1]; ++k) {
      const gather::RowTerm& term = rows.term[k];
      const gather::RowSource& source = rows.source[term.source];
      gather::for_each_entry(source, term, radius_of(shown, source, term),
                             [&](std::uint32_t column, double weight) {
                               if (is_free_[first + column]) visit(first + column, weight);
                             });
    }
  }
  /// Returns whether the picture shows enough of a stop to determine its colour.
  bool is_shown(std::size_t column) const { return weight_[column] > kLeastWeight; }
  bool is_in_srgb() const { return drawing_.interpolation == InterpolationSpace::srgb; }

  Context& context_;
  const Picture& picture_;
  const Document& drawing_;
  std::span<const CurveOfLayer> only_;
  LaidPicture laid_;
  std::vector<std::optional<DrawnLayer>> layers_;
  std::vector<std::uint32_t> first_stop_, first_curve_;  ///< per layer
  SamplePixels pixels_;
  StackPoints points_;
  std::vector<std::uint32_t> part_begin_;  ///< per point, and one more: into part_
  std::vector<Part> part_;
  Channels color_;                       ///< the picture in a space that is not sRGB
  std::vector<FourFloats> x_;            ///< per stop: its colour in the interpolation space
  std::vector<FourFloats> low_, high_;   ///< per stop
  std::vector<std::uint8_t> is_free_;    ///< per stop: whether it is fitted
  std::vector<std::uint8_t> is_chosen_;  ///< per curve: whether it is fitted
  std::vector<std::uint8_t> has_next_;   ///< per stop: whether the next is to be like it
  std::vector<float> weight_;            ///< per stop: its column's sum of squares
  std::vector<float> factor_;            ///< per curve: of its radii
  std::vector<float> radius_px_;         ///< per curve: its largest radius; 0: it does not change
  SparseMatrix matrix_;                  ///< values of stops to pixels, with the present radii
  std::vector<Missing> missing_;         ///< per pixel
  double psnr_db_ = 0;
  TableMemory memory_{"the colours of a fit"};
};

}  // namespace sfumato::tracing
