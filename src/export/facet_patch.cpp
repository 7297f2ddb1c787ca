#include "export/facet_patch.hpp"

#include <algorithm>
#include <cmath>

#include "patches/patch.hpp"

namespace sfumato::outputs {
namespace {

using Kind = FacetSource::Kind;

/// What of the error may go into overshoot that is cut off, without a closer look.
constexpr double kOvershootShare = 0.125;
/// Where no bound holds, a facet is sampled on a lattice of so many steps to a side, and errors
/// between samples are taken to be so much larger.
constexpr int kSamplesPerSide = 4;
constexpr double kBetweenSamples = 4.0 / 3;

/// Quotients by a smaller share are taken elsewhere: they are noise, and next to nothing shows
/// them.
constexpr double kLeastShare = 0.01;

/// Not a number becomes 0.
double clamped(double value) {
  return value > 0 ? std::min(value, 1.0) : 0;
}

bool is_quotient(Kind kind) {
  return kind >= Kind::color_base;
}

bool is_of_shader(Kind kind) {
  return kind == Kind::color_weight || kind == Kind::opacity_weight || kind == Kind::color_mask ||
         kind == Kind::opacity_mask;
}

std::size_t first_channel(const FacetSource& source) {
  if (!is_of_shader(source.kind)) return 0;
  return (reads_color(source) ? std::size_t{3} : std::size_t{1}) + source.shader;
}

/// The ten Bézier ordinates of the cubic through the values at the ten nodes, in their order.
std::array<double, 10> bezier_ordinates(const std::array<double, 10>& z) {
  std::array<double, 10> b = z;
  double edges = 0;
  for (int k = 0; k < 3; ++k) {
    const double from = z[k], to = z[(k + 1) % 3], near = z[3 + 2 * k], far = z[4 + 2 * k];
    b[3 + 2 * k] = (-5 * from + 18 * near - 9 * far + 2 * to) / 6;
    b[4 + 2 * k] = (2 * from - 9 * near + 18 * far - 5 * to) / 6;
    edges += b[3 + 2 * k] + b[4 + 2 * k];
  }
  b[9] = (27 * z[9] - 3 * edges - z[0] - z[1] - z[2]) / 6;
  return b;
}

/// In an equilateral triangle of side 1.
Vec2 in_plane(const Barycentric& at) {
  return {at[1] + 0.5 * at[2], 0.8660254037844386 * at[2]};
}

/// Squared radius of the smallest circle around a triangle.
double enclosing_radius_squared(const std::array<Vec2, 3>& p) {
  std::array<double, 3> side{length_squared(p[1] - p[0]), length_squared(p[2] - p[1]),
                             length_squared(p[0] - p[2])};
  std::sort(side.begin(), side.end());
  if (side[0] + side[1] <= side[2]) return side[2] / 4;
  const double area = cross(p[1] - p[0], p[2] - p[0]);
  return side[0] * side[1] * side[2] / (4 * area * area);
}

/// The largest |a λ0 λ1 + b λ1 λ2 + c λ2 λ0| in a triangle, from above where signs differ.
double largest_rise(const std::array<double, 3>& bent) {
  double largest = 0;
  for (int sign = -1; sign <= 1; sign += 2) {
    std::array<double, 3> e;
    for (int k = 0; k < 3; ++k) e[k] = std::max(sign * bent[k], 0.0);
    std::sort(e.begin(), e.end());
    // Its place is inside, or amid the most bent side. No sum here cancels.
    const double apart = e[2] - e[1];
    const bool is_inside = apart < e[0];
    const double divisor = 2 * e[0] * (e[1] + e[2]) - apart * apart - e[0] * e[0];
    largest = std::max(largest, is_inside ? e[0] * e[1] * e[2] / divisor : e[2] / 4);
  }
  return largest;
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

Barycentric mean(const Barycentric& a, const Barycentric& b, const Barycentric& c) {
  return {(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3, (a[2] + b[2] + c[2]) / 3};
}

}  // namespace

bool reads_color(const FacetSource& source) {
  return source.kind == Kind::color || source.kind == Kind::color_weight ||
         source.kind == Kind::color_base || source.kind == Kind::color_mask ||
         source.kind == Kind::light;
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

double FacetPatch::Hessian::norm() const {
  const double half = (xx - yy) / 2;
  return std::fabs(xx + yy) / 2 + std::sqrt(half * half + xy * xy);
}

FacetPatch::FacetPatch(const PatchLayer& layer, InterpolationSpace space, const FacetSource& source,
                       std::uint32_t triangle, double max_error)
    : order_(layer.order), channel_count_(channel_count_of(source)), max_error_(max_error) {
  is_light_ = source.kind == Kind::light;
  if (source.kind == Kind::color || is_light_) space_ = space;
  read(layer, source, triangle);
  find_curvature();
}

void FacetPatch::read(const PatchLayer& layer, const FacetSource& source, std::uint32_t triangle) {
  const PatchField& field = field_of(layer, source);
  const auto stride = static_cast<std::size_t>(field.channel_count);
  has_share_ = is_quotient(source.kind) && !field.shader.empty();
  const std::size_t first_other = is_of_shader(source.kind) ? source.shader + 1 : 0;
  for (std::size_t n = 0; n < 10; ++n) {
    const float* value =
        field.node_value.data() + field.triangle_node[std::size_t{10} * triangle + n] * stride;
    for (int c = 0; c < channel_count_; ++c)
      node_[c][n] = value[first_channel(source) + static_cast<std::size_t>(c)];
    share_[n] = 1;
    for (std::size_t s = first_other; has_share_ && s < field.shader.size(); ++s)
      share_[n] -= value[stride - field.shader.size() + s];
  }
}

double FacetPatch::share(const Barycentric& at) const {
  if (!has_share_) return 1;
  const std::array<double, 10> basis = patch_basis(order_, at[0], at[1], at[2]);
  double sum = 0;
  for (int n = 0; n < 10; ++n) sum += basis[n] * share_[n];
  return clamped(sum);
}

FacetPatch::Value FacetPatch::unclamped(const Barycentric& at) const {
  const std::array<double, 10> basis = patch_basis(order_, at[0], at[1], at[2]);
  Value value{};
  for (int c = 0; c < channel_count_; ++c)
    for (int n = 0; n < 10; ++n) value[c] += basis[n] * node_[c][n];
  if (space_ == InterpolationSpace::srgb) return value;
  const Rgb code = to_srgb(space_, {static_cast<float>(value[0]), static_cast<float>(value[1]),
                                    static_cast<float>(value[2])});
  return {code.r, code.g, code.b, value[3]};
}

FacetPatch::Value FacetPatch::shown(const Barycentric& at) const {
  // Where nothing is left to divide by, what stands next to it, further in.
  const double here = share(at);
  const bool is_bare = here < kLeastShare;
  const Barycentric inside{0.9 * at[0] + 0.1 / 3, 0.9 * at[1] + 0.1 / 3, 0.9 * at[2] + 0.1 / 3};
  Value value = unclamped(is_bare ? inside : at);
  const double divisor = std::max(is_bare ? share(inside) : here, 1e-6);
  for (double& channel : value) channel = clamped(channel / divisor);
  return value;
}

/// Second derivatives at the corners; returns by how much Bézier ordinates leave [0, 1].
double FacetPatch::find_curvature(int channel) {
  std::array<double, 10> at_node = node_[channel];
  for (std::size_t i = 0; i < 10 && order_ != PatchOrder::cubic; ++i) {
    const auto& w = kNodeBarycentric[i];
    const std::array<double, 10> basis = patch_basis(order_, w[0], w[1], w[2]);
    at_node[i] = 0;
    for (std::size_t n = 0; n < 10; ++n) at_node[i] += basis[n] * node_[channel][n];
  }
  const std::array<double, 10> b = bezier_ordinates(at_node);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t last = (k + 2) % 3;
    const double u = b[3 + 2 * k], uu = b[4 + 2 * k], v = b[4 + 2 * last], vv = b[3 + 2 * last];
    corner_[channel][k] =
        turned(hessian(6 * (b[k] - 2 * u + uu), 6 * (b[k] - u - v + b[9]), 6 * (b[k] - 2 * v + vv)),
               static_cast<int>(k));
  }
  double overshoot = 0;
  for (double ordinate : b) overshoot = std::max({overshoot, -ordinate, ordinate - 1});
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

int FacetPatch::cuts(int most) const {
  int n = 1;
  most = std::min(most, most_cuts());
  if (!is_sampled_) {
    double largest = 0;
    for (int c = 0; c < channel_count_; ++c)
      for (const Hessian& corner : corner_[c]) largest = std::max(largest, corner.norm());
    // From below: a facet's circle has the radius 1 / (n √3), and few facets fill the bound.
    const double exact = 0.7 * std::sqrt(largest / (6 * max_error_));
    if (exact >= most) return most;
    n = exact > 1 ? static_cast<int>(exact) : 1;
  }
  const int fraction = is_sampled_ || is_light_ ? 4 : most;
  while (n < most && !is_met_by(FacetGrid({n, {n, n, n}})))
    n = std::min(n + 1 + n / fraction, most);
  return n;
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

double FacetPatch::bound(const std::array<Barycentric, 3>& facet) const {
  const std::array<Vec2, 3> p{in_plane(facet[0]), in_plane(facet[1]), in_plane(facet[2])};
  const double radius_squared = enclosing_radius_squared(p);
  const Barycentric middle = mean(facet[0], facet[1], facet[2]);
  double largest = 0;
  for (int c = 0; c < channel_count_; ++c) {
    const Hessian h = hessian_at(c, middle);
    std::array<double, 3> bent;
    double change = 0;
    for (int k = 0; k < 3; ++k) {
      const Vec2 side = p[(k + 1) % 3] - p[k];
      bent[k] = h.xx * side.x * side.x + 2 * h.xy * side.x * side.y + h.yy * side.y * side.y;
      const Hessian corner = hessian_at(c, facet[k]);
      change =
          std::max(change, Hessian{corner.xx - h.xx, corner.xy - h.xy, corner.yy - h.yy}.norm());
    }
    largest = std::max(largest, (largest_rise(bent) + change * radius_squared) / 2);
  }
  return largest;
}

double FacetPatch::sampled_error(const std::array<Barycentric, 3>& facet) const {
  const Value corner[3] = {shown(facet[0]), shown(facet[1]), shown(facet[2])};
  double largest = 0;
  for (int i = 0; i <= kSamplesPerSide; ++i) {
    for (int j = 0; i + j <= kSamplesPerSide; ++j) {
      const double weight[3] = {1.0 * (kSamplesPerSide - i - j) / kSamplesPerSide,
                                1.0 * i / kSamplesPerSide, 1.0 * j / kSamplesPerSide};
      Barycentric at{};
      Value flat{};
      for (int k = 0; k < 3; ++k) {
        for (int n = 0; n < 3; ++n) at[n] += weight[k] * facet[k][n];
        for (int c = 0; c < channel_count_; ++c) flat[c] += weight[k] * corner[k][c];
      }
      const Value exact = shown(at);
      for (int c = 0; c < channel_count_; ++c)
        largest = std::max(largest, std::fabs(flat[c] - exact[c]) * share(at));
    }
  }
  return largest;
}

/// By how much a mean of the corners' linear light differs from that of their code values, at most.
double FacetPatch::light_error(const std::array<Barycentric, 3>& facet) const {
  const Value corner[3] = {shown(facet[0]), shown(facet[1]), shown(facet[2])};
  double largest = 0;
  for (int c = 0; c < 3; ++c) {
    const auto [low, high] = std::minmax({corner[0][c], corner[1][c], corner[2][c]});
    largest = std::max(largest, light_rise(low, high));
  }
  return largest;
}

bool FacetPatch::is_met_by(const std::array<Barycentric, 3>& facet) const {
  const double light = is_light_ ? light_error(facet) : 0;
  if (light > max_error_) return false;
  const double curved = is_sampled_ ? kBetweenSamples * sampled_error(facet) : bound(facet);
  return !(curved + light > max_error_);
}

bool FacetPatch::is_met_by(const FacetGrid& grid) const {
  const std::vector<Barycentric> point = grid.points();
  bool is_met = true;
  grid.for_each_facet([&](const std::array<int, 3>& at) {
    is_met = is_met && is_met_by({point[at[0]], point[at[1]], point[at[2]]});
  });
  return is_met;
}

}  // namespace sfumato::outputs
