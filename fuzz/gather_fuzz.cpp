// The packet kernels of every instruction set give the same bits, within the range of the colours.
// Away from curves the bits match the slow reference in double precision.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "fuzz.hpp"
#include "gather/gather.hpp"
#include "gather/gather_reference.hpp"
#include "mesh/mesher.hpp"

using namespace sfumato;

namespace {

constexpr double kSide = 256;
constexpr unsigned kPoints = 24;
/// Points closer to a curve than this, and scenes with shorter pieces, are not compared with the
/// reference: single precision cannot distinguish the sides there.
constexpr double kClearance = 1;
constexpr double kTolerance = 1.0 / 255;
/// Points that see next to nothing are not compared either. If a curve is seen along its length,
/// the kernels may see a trace of it and the reference nothing; dividing by that trace gives any
/// colour. For comparison: a curve all around at a distance of 100 weighs 0.06.
constexpr double kLeastWeight = 1e-4;

struct Drawing {
  curves::FlatCurves flat;
  curves::SegmentAttributes attributes;
  mesh::TriangleMesh mesh;
};

class DrawingReader {
 public:
  explicit DrawingReader(fuzz::Bytes bytes) : reader_(bytes) {}

  std::vector<Vec2> points() {
    std::vector<Vec2> points;
    for (unsigned i = 0; i < kPoints; ++i) {
      const double x = 1 + reader_.unit() * (kSide - 2), y = 1 + reader_.unit() * (kSide - 2);
      points.push_back({x, y});
    }
    return points;
  }

  Drawing drawing() {
    Drawing drawing;
    drawing.flat.curve_begin = {0};
    const unsigned style = reader_.byte();
    drawing.attributes.base_channels = std::array{3, 1, 4, 3}[style % 4];
    if ((style & 16) != 0) drawing.attributes.shader = {0, 1};
    has_blur_ = (style & 32) != 0;
    is_mostly_open_ = (style & 64) != 0;
    while (!reader_.at_end() && drawing.flat.vertex.size() < 400) add_line(drawing);
    return drawing;
  }

 private:
  curves::FieldValue value() {
    curves::FieldValue value;
    for (float& channel : value.channel) channel = static_cast<float>(reader_.below(16)) / 15;
    return value;
  }

  curves::SegmentSide side(const curves::SegmentAttributes& attributes) {
    curves::SegmentSide side;
    const unsigned pick = reader_.below(10);
    side.kind = pick == 0 || (is_mostly_open_ && pick < 7) ? ShaderKind::open
                : pick == 1                                ? ShaderKind::barrier
                                                           : ShaderKind::curve_domain;
    if (pick > 7 && !attributes.shader.empty()) {
      side.kind = ShaderKind::image_domain;
      side.shader = reader_.below(2);
    }
    side.value = {value(), value()};
    if (has_blur_) {
      const auto radius = static_cast<float>(reader_.below(32));
      side.blur_radius = {radius, static_cast<float>(reader_.below(32))};
    }
    return side;
  }

  Vec2 point(const Drawing& drawing) {
    const unsigned pick = reader_.below(8);
    if (pick == 0 && !drawing.flat.vertex.empty()) {
      return drawing.flat.vertex[reader_.byte() % drawing.flat.vertex.size()];
    }
    const double x = reader_.byte(), y = reader_.byte();
    return {x, y};
  }

  void add_line(Drawing& drawing) {
    const unsigned count = 1 + reader_.below(3);
    const auto curve = static_cast<std::uint32_t>(drawing.flat.curve_begin.size() - 1);
    const auto weight = static_cast<float>(1u << reader_.below(3));
    double arc = 0;
    for (unsigned i = 0; i <= count; ++i) {
      const Vec2 p = point(drawing);
      if (i > 0) arc += length(p - drawing.flat.vertex.back());
      drawing.flat.vertex.push_back(p);
      drawing.flat.parameter.push_back(i);
      drawing.flat.arc_length.push_back(arc);
      drawing.flat.vertex_curve.push_back(curve);
      drawing.attributes.left.push_back(i < count ? side(drawing.attributes)
                                                  : curves::SegmentSide{});
      drawing.attributes.right.push_back(i < count ? side(drawing.attributes)
                                                   : curves::SegmentSide{});
      drawing.attributes.weight.push_back(weight);
      drawing.attributes.vertex.push_back(p);
      drawing.attributes.curve.push_back(curve);
    }
    drawing.flat.curve_begin.push_back(static_cast<std::uint32_t>(drawing.flat.vertex.size()));
  }

  fuzz::ByteReader reader_;
  bool has_blur_ = false;
  bool is_mostly_open_ = false;
};

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const double length2 = length_squared(b - a);
  const double t = length2 > 0 ? std::clamp(dot(p - a, b - a) / length2, 0.0, 1.0) : 0;
  return length(lerp(a, b, t) - p);
}

/// Includes vertices, which are all that curves of no length leave behind.
double distance_to_curves(const mesh::TriangleMesh& mesh, Vec2 p) {
  double least = kSide;
  for (const Vec2 vertex : mesh.vertex_position) least = std::min(least, length(vertex - p));
  for (const mesh::Constraint& c : mesh.constraint) {
    if (mesh.pieces(c).empty()) continue;
    least = std::min(
        least, distance_to_segment(p, mesh.vertex_position[c.from], mesh.vertex_position[c.to]));
  }
  return least;
}

double shortest_piece(const mesh::TriangleMesh& mesh) {
  double least = kSide;
  for (const mesh::Constraint& c : mesh.constraint) {
    least = std::min(least, length(mesh.vertex_position[c.to] - mesh.vertex_position[c.from]));
  }
  return least;
}

std::vector<float> gather_at(SimdLevel level, const Drawing& drawing,
                             const std::vector<Vec2>& points) {
  Context context{.budget = Budget(fuzz::kBudgetBytes), .simd = level};
  const auto channels = static_cast<std::size_t>(drawing.attributes.channel_count());
  std::vector<float> values(channels * points.size(), -1.0f);
  std::vector<std::uint8_t> hit(points.size(), 7);
  const Result<gather::Gatherer> gatherer =
      gather::Gatherer::create(context, drawing.mesh, drawing.attributes);
  fuzz::require_ok(gatherer.status(), "no gatherer");
  fuzz::require_ok(gatherer->gather(context, points, {}, values, hit), "no gather");
  for (const std::uint8_t flag : hit) fuzz::require(flag <= 1, "a hit was not written");
  return values;
}

void check_range(const std::vector<float>& values) {
  for (const float value : values) {
    fuzz::require(value >= -1e-4f && value <= 1 + 1e-4f, "a value out of the colours' range");
  }
}

void check_reference(const Drawing& drawing, const std::vector<Vec2>& points,
                     const std::vector<float>& values) {
  if (shortest_piece(drawing.mesh) < kClearance) return;
  const auto channels = static_cast<std::size_t>(drawing.attributes.channel_count());
  const auto base = static_cast<std::size_t>(drawing.attributes.base_channels);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (distance_to_curves(drawing.mesh, points[i]) < kClearance) continue;
    const std::int32_t triangle = gather::find_triangle(drawing.mesh, points[i]);
    // On an edge, rounding may put a point outside both of its triangles.
    if (triangle == mesh::kNone) continue;
    const gather::ReferenceSums sums = gather::gather_reference(
        drawing.mesh, drawing.attributes, points[i], static_cast<std::uint32_t>(triangle));
    if (sums.weight < kLeastWeight) continue;
    const std::array<double, 3> color = sums.value();
    const float* own = &values[channels * i];
    for (std::size_t c = 0; c < std::min<std::size_t>(base, 3); ++c) {
      fuzz::require(std::abs(own[c] - color[c]) <= kTolerance, "a colour far from the reference");
    }
    const std::vector<double> shares = sums.shares();
    for (std::size_t s = 0; s < shares.size(); ++s) {
      fuzz::require(std::abs(own[base + s] - shares[s]) <= kTolerance,
                    "a shader's share far from the reference");
    }
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  DrawingReader reader({data, size});
  const std::vector<Vec2> points = reader.points();
  Drawing drawing = reader.drawing();
  Context context{.budget = Budget(fuzz::kBudgetBytes)};
  mesh::MeshOptions options;
  options.frame = {{0, 0}, {kSide, kSide}};
  options.unit_size = kSide / 1024;
  Result<mesh::Mesher> mesher = mesh::Mesher::build(context, drawing.flat, options);
  fuzz::require_ok(mesher.status(), "no mesh");
  drawing.mesh = *mesher->visibility_mesh({});
  const std::vector<float> values = gather_at(SimdLevel::sse2, drawing, points);
  for (const SimdLevel level : {SimdLevel::avx2, SimdLevel::avx512}) {
    if (level > detected_simd_level()) continue;
    const std::vector<float> other = gather_at(level, drawing, points);
    fuzz::require(std::memcmp(values.data(), other.data(), values.size() * sizeof(float)) == 0,
                  "two instruction sets give different bits");
  }
  check_range(values);
  check_reference(drawing, points, values);
  return 0;
}
