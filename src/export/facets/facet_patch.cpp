#include "export/facets/facet_patch.hpp"

#include <algorithm>
#include <cmath>

#include "picture/patch.hpp"

namespace sfumato::outputs {
namespace {

using Kind = FacetSource::Kind;

/// The share of the error that clipped overshoot may take without a closer check.
constexpr double kOvershootShare = 0.125;
/// If no bound holds, a side is sampled in this many steps, and errors between samples are assumed
/// to be larger by this factor.
constexpr int kSamplesPerSide = 4;
constexpr double kBetweenSamples = 1.5;

/// The shares of the error for edges of patches and for sides inside them. If all three sides of a
/// facet have this error, its middle has a third more.
constexpr double kEdgeShare = 0.7, kSideShare = 0.85;
/// The share for points inside; the rest is for the third derivative elsewhere.
constexpr double kInsideShare = 0.9;
constexpr std::array<Barycentric, 4> kInside{
    {{1.0 / 3, 1.0 / 3, 1.0 / 3}, {0.5, 0.25, 0.25}, {0.25, 0.5, 0.25}, {0.25, 0.25, 0.5}}};

/// Quotients by a smaller share are noise, and next to nothing shows them.
constexpr double kLeastDivisor = 0.01;

/// Not a number becomes 0.
double clamped(double value) {
  return value > 0 ? std::min(value, 1.0) : 0;
}

bool is_quotient(Kind kind) {
  return kind >= Kind::color_base;
}

bool is_of_shader(Kind kind) {
  return kind == Kind::color_mask || kind == Kind::opacity_mask;
}

std::size_t first_channel(const FacetSource& source) {
  if (!is_of_shader(source.kind)) return 0;
  return (reads_color(source) ? std::size_t{3} : std::size_t{1}) + source.shader;
}

/// Returns the ten Bézier ordinates of the cubic of patch_basis through the values at the ten
/// nodes, in their order.
NodeValues bezier_ordinates(const NodeValues& z) {
  NodeValues b = z;
  double edges = 0;
  for (int k = 0; k < 3; ++k) {
    const double from = z[k], to = z[(k + 1) % 3], near = z[near_node(k)], far = z[far_node(k)];
    b[near_node(k)] = (-5 * from + 18 * near - 9 * far + 2 * to) / 6;
    b[far_node(k)] = (2 * from - 9 * near + 18 * far - 5 * to) / 6;
    edges += b[near_node(k)] + b[far_node(k)];
  }
  b[kCenterNode] = (27 * z[kCenterNode] - 3 * edges - z[0] - z[1] - z[2]) / 6;
  return b;
}

/// In an equilateral triangle of side 1.
Vec2 in_plane(const Barycentric& at) {
  return {at[1] + 0.5 * at[2], 0.8660254037844386 * at[2]};
}

/// How far the code value of a mean of linear light rises above the same mean of code values
/// between `low` and `high`, at most. The transfer is convex: its ends mix worst, and most where
/// its slope is that of their chord.
double light_rise(double low, double high) {
  constexpr double kGamma = 2.4, kOffset = 0.055, kScale = 1.055, kToe = 0.04045;
  if (!(high > std::max(low, kToe))) return 0;
  const double light = linear_from_code(low);
  const double slope = (linear_from_code(high) - light) / (high - low);
  const double code = kScale * std::pow(slope * kScale / kGamma, 1 / (kGamma - 1)) - kOffset;
  return code - low - (linear_from_code(code) - light) / slope;
}

}  // namespace

bool reads_color(const FacetSource& source) {
  return source.kind == Kind::color || source.kind == Kind::color_base ||
         source.kind == Kind::color_mask || source.kind == Kind::light;
}

Barycentric centroid(const Barycentric& a, const Barycentric& b, const Barycentric& c) {
  return {(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3, (a[2] + b[2] + c[2]) / 3};
}

double side_length(const Barycentric& a, const Barycentric& b) {
  return length(in_plane(b) - in_plane(a));
}

int channel_count_of(const FacetSource& source) {
  if (source.kind == Kind::light) return 4;
  return source.kind == Kind::color || source.kind == Kind::color_base ? 3 : 1;
}

const PatchField& field_of(const PatchLayer& layer, const FacetSource& source) {
  return reads_color(source) ? layer.color : layer.opacity;
}

/// From second derivatives along two sides of an equilateral triangle, at 60° to each other.
FacetPatch::Hessian FacetPatch::hessian(double uu, double uv, double vv) {
  return {uu, (2 * uv - uu) / std::sqrt(3.0), (uu - 4 * uv + 4 * vv) / 3};
}

/// The frame at corner k is turned by 120° from one to the next.
FacetPatch::Hessian FacetPatch::turned(const Hessian& h, int k) {
  if (k == 0) return h;
  const double cos2 = -0.5, sin2 = (k == 1 ? -1 : 1) * std::sqrt(0.75);
  const double half = (h.xx - h.yy) / 2, middle = (h.xx + h.yy) / 2;
  const double along = half * cos2 - h.xy * sin2;
  return {middle + along, half * sin2 + h.xy * cos2, middle - along};
}

double FacetPatch::Hessian::along(Vec2 side) const {
  return xx * side.x * side.x + 2 * xy * side.x * side.y + yy * side.y * side.y;
}

FacetPatch::FacetPatch(const PatchLayer& layer, InterpolationSpace space, const FacetSource& source,
                       std::uint32_t triangle, double max_error)
    : order_(layer.order),
      channel_count_(channel_count_of(source)),
      asked_error_(max_error),
      max_error_(max_error) {
  is_light_ = source.kind == Kind::light;
  const bool is_color = source.kind == Kind::color || source.kind == Kind::color_base;
  if (is_color || is_light_) space_ = space;
  read(layer, source, triangle);
  find_covered(layer, source, triangle);
  find_curvature();
}

void FacetPatch::read(const PatchLayer& layer, const FacetSource& source, std::uint32_t triangle) {
  const PatchField& field = field_of(layer, source);
  const auto stride = static_cast<std::size_t>(field.channel_count);
  has_share_ = is_quotient(source.kind) && !field.shader.empty();
  const std::size_t first_other = is_of_shader(source.kind) ? source.shader + 1 : 0;
  for (std::size_t n = 0; n < kNodesPerTriangle; ++n) {
    const float* value =
        field.node_value.data() + field.triangle_node[node_slot(triangle, n)] * stride;
    for (int c = 0; c < channel_count_; ++c)
      node_[c][n] = value[first_channel(source) + static_cast<std::size_t>(c)];
    share_[n] = 1;
    for (std::size_t s = first_other; has_share_ && s < field.shader.size(); ++s)
      share_[n] -= value[stride - field.shader.size() + s];
  }
}

/// Computes the mean of the shaders' colours, by their weights in the whole patch.
void FacetPatch::find_covered(const PatchLayer& layer, const FacetSource& source,
                              std::uint32_t triangle) {
  const PatchField& field = field_of(layer, source);
  if (!has_share_ || source.shown.size() != field.shader.size()) return;
  const auto stride = static_cast<std::size_t>(field.channel_count);
  double sum = 0;
  for (std::size_t n = 0; n < kNodesPerTriangle; ++n) {
    const std::size_t end = (field.triangle_node[node_slot(triangle, n)] + std::size_t{1}) * stride;
    for (std::size_t s = 0; s < field.shader.size(); ++s) {
      const double weight = clamped(field.node_value[end - field.shader.size() + s]);
      const Rgb& color = source.shown[s];
      sum += weight;
      covered_[0] += weight * color.r;
      covered_[1] += weight * color.g;
      covered_[2] += weight * color.b;
    }
  }
  for (double& channel : covered_) channel = sum > 0 ? clamped(channel / sum) : 0;
}

double FacetPatch::share(const Barycentric& at) const {
  if (!has_share_) return 1;
  const PatchBasis basis = patch_basis(order_, at[0], at[1], at[2]);
  double sum = 0;
  for (int n = 0; n < kNodesPerTriangle; ++n) sum += basis[n] * share_[n];
  return clamped(sum);
}

FacetPatch::Value FacetPatch::unclamped(const Barycentric& at) const {
  const PatchBasis basis = patch_basis(order_, at[0], at[1], at[2]);
  Value value{};
  for (int c = 0; c < channel_count_; ++c)
    for (int n = 0; n < kNodesPerTriangle; ++n) value[c] += basis[n] * node_[c][n];
  if (space_ == InterpolationSpace::srgb) return value;
  const Rgb code = to_srgb(space_, {static_cast<float>(value[0]), static_cast<float>(value[1]),
                                    static_cast<float>(value[2])});
  return {code.r, code.g, code.b, value[3]};
}

FacetPatch::Value FacetPatch::shown(const Barycentric& at) const {
  const double divisor = share(at);
  if (divisor < kLeastDivisor) return covered_;
  Value value = unclamped(at);
  for (double& channel : value) channel = clamped(channel / divisor);
  return value;
}

/// Second derivatives at the corners; returns by how much Bézier ordinates leave [0, 1].
double FacetPatch::find_curvature(int channel) {
  NodeValues at_node = node_[channel];
  for (std::size_t i = 0; i < kNodesPerTriangle && order_ != PatchOrder::cubic; ++i) {
    const auto& w = kNodeBarycentric[i];
    const PatchBasis basis = patch_basis(order_, w[0], w[1], w[2]);
    at_node[i] = 0;
    for (std::size_t n = 0; n < kNodesPerTriangle; ++n) at_node[i] += basis[n] * node_[channel][n];
  }
  const NodeValues b = bezier_ordinates(at_node);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t last = (k + 2) % 3;
    const double u = b[near_node(k)], uu = b[far_node(k)], v = b[far_node(last)],
                 vv = b[near_node(last)];
    corner_[channel][k] =
        turned(hessian(6 * (b[k] - 2 * u + uu), 6 * (b[k] - u - v + b[kCenterNode]),
                       6 * (b[k] - 2 * v + vv)),
               static_cast<int>(k));
  }
  double overshoot = 0;
  for (std::size_t i = 0; i < kNodesPerTriangle; ++i) {
    const bool is_there = !is_edge_ || i < 2 || i == 3 || i == 4;
    if (is_there) overshoot = std::max({overshoot, -b[i], b[i] - 1});
  }
  return overshoot;
}

void FacetPatch::find_curvature() {
  double overshoot = 0;
  for (int c = 0; c < channel_count_; ++c) overshoot = std::max(overshoot, find_curvature(c));
  if (space_ != InterpolationSpace::srgb || has_share_) {
    is_sampled_ = true;
  } else if (overshoot > kOvershootShare * max_error_) {
    is_sampled_ = is_clamped_ = true;
  } else {
    max_error_ -= overshoot;
  }
}

FacetPatch FacetPatch::edge(std::size_t k, bool is_reversed) const {
  FacetPatch along = *this;
  along.is_edge_ = true;
  along.is_sampled_ = along.is_clamped_ = false;
  along.max_error_ = asked_error_;
  std::array<std::size_t, 4> from{k, (k + 1) % 3, near_node(k), far_node(k)};
  if (is_reversed) from = {from[1], from[0], from[3], from[2]};
  constexpr std::array<std::size_t, 4> kTo{0, 1, 3, 4};
  const auto move = [&](const NodeValues& nodes, NodeValues* moved) {
    moved->fill(0);
    for (std::size_t i = 0; i < 4; ++i) (*moved)[kTo[i]] = nodes[from[i]];
  };
  for (std::size_t c = 0; c < kMostChannels; ++c) move(node_[c], &along.node_[c]);
  move(share_, &along.share_);
  along.find_curvature();
  return along;
}

FacetPatch::Hessian FacetPatch::hessian_at(int channel, const Barycentric& at) const {
  Hessian here;
  for (int k = 0; k < 3; ++k) {
    const Hessian& corner = corner_[channel][k];
    here.xx += at[k] * corner.xx;
    here.xy += at[k] * corner.xy;
    here.yy += at[k] * corner.yy;
  }
  return here;
}

double FacetPatch::sampled_bend(const Barycentric& a, const Barycentric& b) const {
  const Value at_a = shown(a), at_b = shown(b);
  double largest = 0;
  for (int i = 1; i < kSamplesPerSide; ++i) {
    const double t = 1.0 * i / kSamplesPerSide;
    Barycentric at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = (1 - t) * a[k] + t * b[k];
    const Value exact = shown(at);
    for (int c = 0; c < channel_count_; ++c) {
      const double miss = std::fabs((1 - t) * at_a[c] + t * at_b[c] - exact[c]);
      largest = std::max(largest, miss * share(at));
    }
  }
  return kBetweenSamples * largest;
}

double FacetPatch::curved_bend(const Barycentric& a, const Barycentric& b) const {
  const Vec2 side = in_plane(b) - in_plane(a);
  double largest = 0;
  for (int c = 0; c < channel_count_; ++c)
    for (const Barycentric* end : {&a, &b})
      largest = std::max(largest, std::fabs(hessian_at(c, *end).along(side)));
  return largest / 8;
}

/// By how much a mean of the ends' linear light differs from that of their code values, at most.
double FacetPatch::light_bend(const Barycentric& a, const Barycentric& b) const {
  const Value at_a = shown(a), at_b = shown(b);
  double largest = 0;
  for (int c = 0; c < 3; ++c) {
    const auto [low, high] = std::minmax(at_a[c], at_b[c]);
    largest = std::max(largest, light_rise(low, high));
  }
  return largest;
}

double FacetPatch::bend(const Barycentric& a, const Barycentric& b) const {
  const double light = is_light_ ? light_bend(a, b) : 0;
  return light + (is_sampled_ ? sampled_bend(a, b) : curved_bend(a, b));
}

bool FacetPatch::is_straight_edge(const Barycentric& a, const Barycentric& b) const {
  return !(bend(a, b) > kEdgeShare * max_error_);
}

bool FacetPatch::is_straight(const Barycentric& a, const Barycentric& b) const {
  return !(bend(a, b) > kSideShare * max_error_);
}

bool FacetPatch::is_flat(const std::array<Barycentric, 3>& facet) const {
  const Value corner[3] = {shown(facet[0]), shown(facet[1]), shown(facet[2])};
  for (const Barycentric& weight : kInside) {
    Barycentric at{};
    Value flat{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t n = 0; n < 3; ++n) at[n] += weight[k] * facet[k][n];
      for (std::size_t c = 0; c < kMostChannels; ++c) flat[c] += weight[k] * corner[k][c];
    }
    const Value exact = shown(at);
    for (int c = 0; c < channel_count_; ++c)
      if (std::fabs(flat[c] - exact[c]) * share(at) > kInsideShare * max_error_) return false;
  }
  return true;
}

}  // namespace sfumato::outputs
