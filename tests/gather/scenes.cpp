#include "gather/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "gather/gather_reference.hpp"
#include "mesh/mesher.hpp"

namespace sfumato::gather::test {
namespace {

double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

Vec2 on_grid(Vec2 p) {
  return {std::round(p.x * 16) / 16, std::round(p.y * 16) / 16};
}

double distance_to_segment(Vec2 a, Vec2 b, Vec2 p) {
  const double t = std::clamp(dot(p - a, b - a) / length_squared(b - a), 0.0, 1.0);
  return length(lerp(a, b, t) - p);
}

bool cross_each_other(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return (cross(b - a, c - a) > 0) != (cross(b - a, d - a) > 0) &&
         (cross(d - c, a - c) > 0) != (cross(d - c, b - c) > 0);
}

bool keeps_clear(const std::vector<Line>& lines, Vec2 a, Vec2 b) {
  for (const Line& line : lines) {
    const Vec2 c = line.points[0], d = line.points[1];
    if (cross_each_other(a, b, c, d)) return false;
    const double gap = std::min({distance_to_segment(a, b, c), distance_to_segment(a, b, d),
                                 distance_to_segment(c, d, a), distance_to_segment(c, d, b)});
    if (gap < 2) return false;
  }
  return true;
}

Rgb random_color(std::mt19937& random) {
  return {static_cast<float>(uniform(random, 0, 1)), static_cast<float>(uniform(random, 0, 1)),
          static_cast<float>(uniform(random, 0, 1))};
}

ShaderKind random_kind(std::mt19937& random, double open_share, double barrier_share) {
  const double pick = uniform(random, 0, 1);
  if (pick < open_share) return ShaderKind::open;
  return pick < open_share + barrier_share ? ShaderKind::barrier : ShaderKind::curve_domain;
}

void append(const Line& line, std::uint32_t curve, Drawing& drawing) {
  curves::FlatCurves& flat = drawing.flat;
  double length_so_far = 0;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    if (i > 0) length_so_far += length(line.points[i] - line.points[i - 1]);
    flat.vertex.push_back(line.points[i]);
    flat.parameter.push_back(static_cast<double>(i));
    flat.arc_length.push_back(length_so_far);
    flat.vertex_curve.push_back(curve);
    curves::SegmentSide left{line.left_kind, line.left_shader, {}, line.blur_radius};
    curves::SegmentSide right{line.right_kind, line.right_shader, {}, line.blur_radius};
    if (i + 1 < line.points.size()) {
      left.value = {line.left[i], line.left[i + 1]};
      right.value = {line.right[i], line.right[i + 1]};
    }
    drawing.attributes.left.push_back(left);
    drawing.attributes.right.push_back(right);
    drawing.attributes.weight.push_back(line.weight);
    drawing.attributes.vertex.push_back(line.points[i]);
    drawing.attributes.curve.push_back(curve);
  }
  flat.curve_begin.push_back(static_cast<std::uint32_t>(flat.vertex.size()));
}

}  // namespace

Line plain_line(std::vector<Vec2> points, Rgb color) {
  Line line{.points = std::move(points), .left = {}, .right = {}};
  line.left.assign(line.points.size(), color);
  line.right = line.left;
  return line;
}

Drawing draw(std::vector<Line> lines, Box frame) {
  Drawing drawing;
  drawing.frame = frame;
  drawing.lines = std::move(lines);
  drawing.flat.curve_begin = {0};
  for (const Line& line : drawing.lines) {
    const std::uint32_t shaders = std::max(line.left_shader, line.right_shader) + 1;
    const bool has_image =
        line.left_kind == ShaderKind::image_domain || line.right_kind == ShaderKind::image_domain;
    while (has_image && drawing.attributes.shader.size() < shaders) {
      drawing.attributes.shader.push_back(
          static_cast<std::uint32_t>(drawing.attributes.shader.size()));
    }
  }
  for (std::size_t i = 0; i < drawing.lines.size(); ++i) {
    append(drawing.lines[i], static_cast<std::uint32_t>(i), drawing);
  }
  Context context;
  mesh::MeshOptions options;
  options.frame = frame;
  options.unit_size = std::max(frame.width(), frame.height()) / 1024;
  Result<mesh::Mesher> mesher = mesh::Mesher::build(context, drawing.flat, options);
  EXPECT_TRUE(mesher.ok()) << mesher.status().message;
  if (mesher) drawing.mesh = *mesher->visibility_mesh({});
  return drawing;
}

std::vector<Line> random_lines(std::uint32_t seed, int count, double open_share,
                               double barrier_share) {
  std::mt19937 random(seed);
  std::vector<Line> lines;
  while (static_cast<int>(lines.size()) < count) {
    const Vec2 a = on_grid({uniform(random, 4, 508), uniform(random, 4, 508)});
    const double angle = uniform(random, 0, 6.2831853), size = uniform(random, 4, 90);
    const Vec2 b = on_grid(a + size * Vec2{std::cos(angle), std::sin(angle)});
    if (b.x < 4 || b.y < 4 || b.x > 508 || b.y > 508 || !keeps_clear(lines, a, b)) continue;
    Line line{.points = {a, b},
              .left = {random_color(random), random_color(random)},
              .right = {random_color(random), random_color(random)}};
    line.left_kind = random_kind(random, open_share, barrier_share);
    line.right_kind = random_kind(random, open_share, barrier_share);
    line.weight = static_cast<float>(1 << random() % 3);
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<Line> specks(std::uint32_t seed, int count) {
  std::mt19937 random(seed);
  std::vector<Line> lines;
  for (int i = 0; i < count; ++i) {
    const Vec2 a{uniform(random, 4, 508), uniform(random, 4, 508)};
    const double angle = uniform(random, 0, 6.2831853);
    lines.push_back({.points = {a, a + 0.5 * Vec2{std::cos(angle), std::sin(angle)}},
                     .left = {random_color(random), random_color(random)},
                     .right = {random_color(random), random_color(random)}});
  }
  return lines;
}

std::vector<Line> with_blends(std::vector<Line> lines, std::uint32_t seed, float largest_radius,
                              std::uint32_t shader_count) {
  std::mt19937 random(seed);
  for (Line& line : lines) {
    line.blur_radius = {static_cast<float>(uniform(random, 0, largest_radius)),
                        static_cast<float>(uniform(random, 0, largest_radius))};
    if (random() % 4 == 0) line.blur_radius = {};
    if (shader_count > 0 && random() % 3 == 0) line.left_kind = ShaderKind::image_domain;
    if (shader_count > 0 && random() % 3 == 0) line.right_kind = ShaderKind::image_domain;
    line.left_shader = shader_count > 0 ? random() % shader_count : 0;
    line.right_shader = shader_count > 0 ? random() % shader_count : 0;
  }
  return lines;
}

double distance_to_lines(const std::vector<Line>& lines, Vec2 p) {
  double least = 1e300;
  for (const Line& line : lines) {
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
      least = std::min(least, distance_to_segment(line.points[i], line.points[i + 1], p));
    }
  }
  return least;
}

std::vector<Vec2> random_points(const Drawing& drawing, std::uint32_t seed, int count,
                                double clearance) {
  std::mt19937 random(seed);
  std::vector<Vec2> points;
  while (static_cast<int>(points.size()) < count) {
    const Vec2 p{uniform(random, drawing.frame.min.x + 1, drawing.frame.max.x - 1),
                 uniform(random, drawing.frame.min.y + 1, drawing.frame.max.y - 1)};
    if (distance_to_lines(drawing.lines, p) >= clearance) points.push_back(p);
  }
  const auto row = [](Vec2 p) { return static_cast<int>(p.y / 16); };
  std::sort(points.begin(), points.end(),
            [&](Vec2 a, Vec2 b) { return row(a) != row(b) ? row(a) < row(b) : a.x < b.x; });
  return points;
}

Gathered gather_at(Context& context, const Drawing& drawing, const std::vector<Vec2>& points,
                   const GatherOptions& options) {
  Gathered result{std::vector<float>(drawing.attributes.channel_count() * points.size(), -1.0f),
                  std::vector<std::uint8_t>(points.size(), 7)};
  const Result<Gatherer> gatherer = Gatherer::create(context, drawing.mesh, drawing.attributes);
  EXPECT_TRUE(gatherer.ok()) << gatherer.status().message;
  if (!gatherer) return result;
  const Status status = gatherer->gather(context, points, options, result.value, result.hit);
  EXPECT_TRUE(status.ok()) << status.message;
  return result;
}

Difference difference(const std::vector<float>& a, const std::vector<float>& b) {
  Difference result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = 255 * std::fabs(double{a[i]} - double{b[i]});
    result.rms += d * d / static_cast<double>(a.size());
    // A NaN must not pass as a small difference.
    if (!(d <= result.largest)) result.largest = d;
  }
  result.rms = std::sqrt(result.rms);
  return result;
}

std::vector<float> reference_at(const Drawing& drawing, const std::vector<Vec2>& points) {
  std::vector<float> values;
  for (Vec2 p : points) {
    const std::int32_t triangle = find_triangle(drawing.mesh, p);
    EXPECT_NE(triangle, mesh::kNone);
    const ReferenceSums sums =
        gather_reference(drawing.mesh, drawing.attributes, p, static_cast<std::uint32_t>(triangle));
    for (double value : sums.value()) values.push_back(static_cast<float>(value));
    for (double share : sums.shares()) values.push_back(static_cast<float>(share));
  }
  return values;
}

}  // namespace sfumato::gather::test
