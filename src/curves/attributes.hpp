#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "curves/flatten.hpp"
#include "sfumato/base/color.hpp"
#include "sfumato/base/color_space.hpp"
#include "sfumato/document/stop_place.hpp"

namespace sfumato::curves {

/// The values of an attribute at both ends of a segment, from within the segment (a step at an end
/// belongs to the neighbour). Linear in between.
template <class Value>
struct SegmentValues {
  Value start{};
  Value end{};
};

/// A value of a field in the first SegmentAttributes::base_channels numbers: a colour, an opacity,
/// or both.
struct FieldValue {
  static constexpr int kChannels = 4;
  std::array<float, kChannels> channel{};

  FieldValue() = default;
  FieldValue(const Rgb& color) : channel{color.r, color.g, color.b, 0} {}
  explicit FieldValue(float opacity) : channel{opacity, 0, 0, 0} {}

  friend bool operator==(const FieldValue&, const FieldValue&) = default;

  friend FieldValue lerp(const FieldValue& a, const FieldValue& b, float t) {
    FieldValue value;
    for (std::size_t c = 0; c < kChannels; ++c) {
      value.channel[c] = sfumato::lerp(a.channel[c], b.channel[c], t);
    }
    return value;
  }
};

/// The effect of one side of one segment on the rays of one attribute.
struct SegmentSide {
  ShaderKind kind = ShaderKind::open;
  std::uint32_t shader = 0;            ///< index into SegmentAttributes::shader
  SegmentValues<FieldValue> value{};   ///< for curve_domain
  SegmentValues<float> blur_radius{};  ///< user units; 0: sharp
  SegmentValues<float> fine_radius{};  ///< radius of a blur too fine for a mesh; else 0
};

/// One attribute on every segment of `flat` (index = segment = its first vertex; the entries of
/// vertices that begin no segment are open).
struct SegmentAttributes {
  int base_channels = 3;  ///< 3 for a colour, 1 for an opacity, 4 for both; plus one for a response
  InterpolationSpace space = InterpolationSpace::srgb;  ///< of colours
  std::vector<SegmentSide> left;
  std::vector<SegmentSide> right;
  std::vector<float> weight;         ///< weight of the curve
  std::vector<Vec2> vertex;          ///< FlatCurves::vertex: segment s joins s and s + 1
  std::vector<std::uint32_t> curve;  ///< index of the curve; later ones are drawn over earlier
  /// The image-domain shaders on sides, as indices into Document::shaders in the order of their
  /// first use.
  std::vector<std::uint32_t> shader;
  bool has_response = false;  ///< the last base channel is a response (curves/response.hpp)

  int channel_count() const { return base_channels + static_cast<int>(shader.size()); }
};

/// Samples the colours on the sides of the curves, interpolated between stops and given in `space`,
/// in tables allocated from `memory`. Errors: limit (memory), cancelled.
Result<SegmentAttributes> sample_colors(const Context& context, const FlatCurves& flat,
                                        std::span<const Curve> curves, InterpolationSpace space,
                                        TableMemory& memory);

/// Does the same for opacities.
Result<SegmentAttributes> sample_opacities(const Context& context, const FlatCurves& flat,
                                           std::span<const Curve> curves, TableMemory& memory);

/// Returns the number of stops of one attribute on the sides of the curves, without sides that are
/// not curve_domain.
std::size_t stop_count(std::span<const Curve> curves, StopAttribute attribute);

/// The largest number of stops, and of curves, whose indices are exact in a float.
inline constexpr std::size_t kMostStopPlaces = std::size_t{1} << 24;

/// Samples places instead of values: where each segment lies among the stops of an attribute.
/// Channels:
///
///   0   the fraction of the way from a stop to the next one of its side; a segment lies between
///       two. 0 before the first stop and behind the last.
///   1   the column of that stop: its index among the stops that stop_count() counts, curve by
///       curve, on the left then the right, stop by stop
///   2   the index of the curve, also on sides without stops
///
/// Errors: limit (memory, kMostStopPlaces), cancelled.
Result<SegmentAttributes> sample_stop_places(const Context& context, const FlatCurves& flat,
                                             std::span<const Curve> curves, StopAttribute attribute,
                                             TableMemory& memory);

/// Returns whether a side has a colour or an opacity, its own or an image's.
template <class Value>
bool has_value(const SideShader<Value>& shader) {
  return shader.kind == ShaderKind::curve_domain || shader.kind == ShaderKind::image_domain;
}

/// Returns whether the side has a blur radius above 0 anywhere.
bool is_blurred(const Side& side);

/// Returns whether a side of the curve is not open to opacity.
bool bears_opacity(const Curve& curve);

/// Returns whether each side of each curve has a colour where it has an opacity, none of them
/// image-domain: the rays of both attributes are then the same.
bool opacity_goes_with_color(std::span<const Curve> curves);

/// Samples both at once. Precondition: opacity_goes_with_color.
Result<SegmentAttributes> sample_colors_and_opacities(const Context& context,
                                                      const FlatCurves& flat,
                                                      std::span<const Curve> curves,
                                                      InterpolationSpace space,
                                                      TableMemory& memory);

/// Replaces the entries from `first` on by `tail`, which was sampled for some curves alone and has
/// no shaders. The first of these curves has the index `first_curve` now. The tables belong to
/// `memory`. Errors: limit (memory), cancelled; `attributes` is then unusable.
Status replace_tail(const Context& context, std::size_t first, std::uint32_t first_curve,
                    const SegmentAttributes& tail, TableMemory& memory,
                    SegmentAttributes& attributes);

/// Makes all sides sharp.
void remove_blur(SegmentAttributes& attributes);

/// Turns the radii of segments whose radii are at most `radius` into fine ones.
void set_fine_blur(SegmentAttributes& attributes, double radius);

}  // namespace sfumato::curves
