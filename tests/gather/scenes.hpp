#pragma once

#include <cstdint>
#include <vector>

#include "curves/attributes.hpp"
#include "curves/flatten.hpp"
#include "gather/gather.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::gather::test {

/// A polyline with a colour at each vertex on both sides.
struct Line {
  std::vector<Vec2> points;
  std::vector<Rgb> left;
  std::vector<Rgb> right;
  ShaderKind left_kind = ShaderKind::curve_domain;
  ShaderKind right_kind = ShaderKind::curve_domain;
  float weight = 1;
  std::uint32_t left_shader = 0;  ///< if the kind is image_domain
  std::uint32_t right_shader = 0;
  curves::SegmentValues<float> blur_radius{};  ///< of every segment, both sides
};

inline constexpr Rgb kWhite{1, 1, 1};
inline constexpr Rgb kBlack{0, 0, 0};

/// Returns a line of one colour on both sides.
Line plain_line(std::vector<Vec2> points, Rgb color);

struct Drawing {
  std::vector<Line> lines;
  curves::FlatCurves flat;
  curves::SegmentAttributes attributes;
  mesh::TriangleMesh mesh;  ///< the visibility mesh
  Box frame;
};

/// Meshes the lines. Coordinates should be multiples of 1/16, which are kept exactly.
Drawing draw(std::vector<Line> lines, Box frame = {{0, 0}, {512, 512}});

/// Returns `count` segments that keep clear of each other, with random colours, kinds and weights.
/// open_share and barrier_share are shares of sides without colour.
std::vector<Line> random_lines(std::uint32_t seed, int count, double open_share,
                               double barrier_share);

/// Returns lines of half a unit at random places in [0, 512]².
std::vector<Line> specks(std::uint32_t seed, int count);

/// Gives each line blur radii from 0 to `largest_radius`, and gives a third of the sides one of
/// `shader_count` image-domain shaders.
std::vector<Line> with_blends(std::vector<Line> lines, std::uint32_t seed, float largest_radius,
                              std::uint32_t shader_count);

/// Returns points inside the frame, at least `clearance` from every line, in zigzag order.
std::vector<Vec2> random_points(const Drawing& drawing, std::uint32_t seed, int count,
                                double clearance);

/// Returns the smallest distance from p to a line.
double distance_to_lines(const std::vector<Line>& lines, Vec2 p);

struct Gathered {
  std::vector<float> value;  ///< SegmentAttributes::channel_count per point
  std::vector<std::uint8_t> hit;
};

Gathered gather_at(Context& context, const Drawing& drawing, const std::vector<Vec2>& points,
                   const GatherOptions& options = {});

/// The root mean square and the largest of differences, in code values of 255.
struct Difference {
  double rms = 0;
  double largest = 0;
};
Difference difference(const std::vector<float>& a, const std::vector<float>& b);

/// Returns the values of gather_reference at the same points.
std::vector<float> reference_at(const Drawing& drawing, const std::vector<Vec2>& points);

}  // namespace sfumato::gather::test
