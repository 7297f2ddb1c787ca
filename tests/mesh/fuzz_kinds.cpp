#include "mesh/fuzz_kinds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "mesh/flat_input.hpp"

namespace sfumato::mesh::test {
namespace {

constexpr double kPi = std::numbers::pi;

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  double between(double low, double high) {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return low + (high - low) * static_cast<double>(z >> 11) * 0x1p-53;
  }
  int below(int count) { return static_cast<int>(between(0, count)); }
  bool coin() { return below(2) == 0; }
  double power_of_ten(double low, double high) { return std::pow(10.0, between(low, high)); }
  Vec2 point(double margin) {
    const double x = between(-margin, kFuzzSide + margin);
    return {x, between(-margin, kFuzzSide + margin)};
  }
  Vec2 vector(double reach) {
    const double x = between(-reach, reach);
    return {x, between(-reach, reach)};
  }
  Vec2 direction() {
    const double angle = between(0, 2 * kPi);
    return {std::cos(angle), std::sin(angle)};
  }

 private:
  std::uint64_t state_;
};

using Cubic = std::array<Vec2, 4>;

Vec2 at(const Cubic& c, double t) {
  const Vec2 ab = lerp(c[0], c[1], t), bc = lerp(c[1], c[2], t), cd = lerp(c[2], c[3], t);
  return lerp(lerp(ab, bc, t), lerp(bc, cd, t), t);
}

/// Adds chords of a cubic, about `tolerance` from it.
void add_cubic(curves::FlatCurves& flat, const Cubic& c, double tolerance = 0.25) {
  const double bend = std::max(length(c[0] - 2 * c[1] + c[2]), length(c[1] - 2 * c[2] + c[3]));
  const int count = 1 + static_cast<int>(std::sqrt(0.75 * bend / tolerance));
  std::vector<Vec2> polyline{c[0]};
  for (int i = 1; i < count; ++i) polyline.push_back(at(c, static_cast<double>(i) / count));
  polyline.push_back(c[3]);
  add_polyline(flat, polyline);
}

void add_fans(curves::FlatCurves& flat, Random& random) {
  for (int fan = 0; fan < 6; ++fan) {
    const Vec2 hub = random.point(-100);
    double angle = random.between(0, 2 * kPi);
    for (int ray = 4 + random.below(20); ray > 0; --ray) {
      const Vec2 along{std::cos(angle), std::sin(angle)};
      const double reach = random.between(40, 400);
      const Vec2 bend = left_of(along) * (random.between(-0.3, 0.3) * reach);
      add_cubic(flat, {hub, hub + along * (reach / 3), hub + along * (reach * 2 / 3) + bend * 0.3,
                       hub + along * reach + bend});
      angle += random.between(1, 5) * kPi / 180;
    }
  }
}

void add_crossings(curves::FlatCurves& flat, Random& random) {
  for (int i = 0; i < 60; ++i) {
    Cubic c;
    for (Vec2& p : c) p = random.point(200);
    add_cubic(flat, c);
  }
}

void add_near_ends(curves::FlatCurves& flat, Random& random) {
  for (int i = 0; i < 60; ++i) {
    Vec2 start = random.point(-50);
    for (int j = 0; j < 4; ++j) {
      const Vec2 end = start + random.vector(80);
      const Vec2 b = start + random.vector(40);
      add_cubic(flat, {start, b, end + random.vector(40), end});
      const double miss = random.power_of_ten(-9, -0.5);
      start = end + random.direction() * miss;
    }
  }
}

void add_near_copies(curves::FlatCurves& flat, Random& random) {
  for (int i = 0; i < 40; ++i) {
    Cubic c;
    for (Vec2& p : c) p = random.point(0);
    add_cubic(flat, c);
    const double e = random.power_of_ten(-13, -0.5);
    const double t = random.between(0.2, 0.8);
    switch (random.below(5)) {
      case 0:
        add_cubic(flat, {c[0] + Vec2{e, 0}, c[1] + Vec2{0, e}, c[2], c[3]});
        break;
      case 1:
        add_cubic(flat, {c[3], c[2], c[1], c[0]});
        break;
      case 2: {
        const Vec2 ab = lerp(c[0], c[1], t);
        add_cubic(flat, {c[0], ab, lerp(ab, lerp(c[1], c[2], t), t), at(c, t)});
        break;
      }
      case 3:
        add_cubic(flat,
                  {c[0] + Vec2{e, e}, c[1] + Vec2{e, e}, c[2] + Vec2{e, e}, c[3] + Vec2{e, e}});
        break;
      default:
        add_cubic(flat, c);
    }
  }
}

void add_tangents(curves::FlatCurves& flat, Random& random) {
  for (int i = 0; i < 30; ++i) {
    const Vec2 touch = random.point(-100);
    const Vec2 along = random.direction();
    const Vec2 aside = left_of(along);
    for (int j = 0; j < 3; ++j) {
      const double reach = random.between(60, 250);
      const Vec2 lift = aside * random.between(-60, 60);
      add_cubic(flat, {touch - along * reach + lift, touch - along * (reach / 3),
                       touch + along * (reach / 3), touch + along * reach + lift});
      const double s = random.between(40, 200);
      const Vec2 bend = aside * random.between(-9, 9);
      add_cubic(flat, {touch, touch + along * (s / 3), touch + along * (s * 0.6) + bend,
                       touch + along * s + aside * random.between(-30, 30)});
    }
  }
}

void add_specks(curves::FlatCurves& flat, Random& random) {
  for (int i = 0; i < 300; ++i) {
    const Vec2 a = random.point(0);
    if (random.below(3) == 0) {
      const double s = random.power_of_ten(-3, 0.3);
      const Vec2 b = a + random.vector(s), c = a + random.vector(s);
      add_cubic(flat, {a, b, c, a + random.vector(s)}, s / 8);
      continue;
    }
    const double reach = random.between(2, 80);
    const Vec2 along = random.direction() * reach;
    const double miss = random.coin() ? 0 : random.power_of_ten(-12, -1);
    const Vec2 b = a + along * random.between(-1, 2) + Vec2{0, miss};
    add_cubic(flat, {a, b, a + along * random.between(-1, 2) - Vec2{miss, 0}, a + along}, 0.02);
  }
}

void add_along_frame(curves::FlatCurves& flat, Random& random) {
  for (int i = 0; i < 60; ++i) {
    const double start = random.between(0, 900), reach = random.between(20, 300);
    const int side = random.below(4);
    const double sign = random.coin() ? -1 : 1;
    const double off = random.below(3) == 0 ? 0 : random.power_of_ten(-12, 0.3) * sign;
    const double wave = random.coin() ? 0 : random.between(-2, 2);
    const auto on_side = [&](double u, double v) {
      const Vec2 places[4] = {{u, v}, {kFuzzSide - v, u}, {u, kFuzzSide - v}, {v, u}};
      return places[side];
    };
    const double leave = random.coin() ? random.between(-50, 50) : 0;
    add_cubic(flat,
              {on_side(start, off), on_side(start + reach / 3, off + wave),
               on_side(start + reach * 2 / 3, off - wave), on_side(start + reach, off + leave)});
  }
}

}  // namespace

curves::FlatCurves fuzz_scene(FuzzKind kind, std::uint64_t seed) {
  constexpr decltype(&add_fans) kMakers[kFuzzKindCount] = {
      add_fans,     add_crossings, add_near_ends,  add_near_copies,
      add_tangents, add_specks,    add_along_frame};
  curves::FlatCurves flat;
  Random random(seed * 1000 + static_cast<std::uint64_t>(kind));
  kMakers[static_cast<int>(kind)](flat, random);
  return flat;
}

}  // namespace sfumato::mesh::test
