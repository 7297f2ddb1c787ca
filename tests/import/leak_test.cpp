// Outlines that cross or nearly touch themselves, and thin strokes: no opacity leaks out of them,
// and none is missing inside.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "base/text/number_text.hpp"
#include "curves/bezier.hpp"
#include "sfumato/import/import_svg.hpp"
#include "support/draw.hpp"
#include "support/flattened.hpp"
#include "support/soak.hpp"

namespace sfumato {
namespace {

using Chain = std::vector<Vec2>;

constexpr int kSide = 48;  ///< of the picture, in pixels and in units

/// A shape that is filled by either rule, or stroked if `style` says so.
struct LeakShape {
  std::string name;
  std::vector<Chain> chains;
  bool even_odd = false;
  double stroke_width = 0;
  std::string style = {};
};

class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}

  double share() { return static_cast<double>(engine_()) / 4294967296.0; }
  double between(double low, double high) { return low + (high - low) * share(); }
  /// Returns a size of any order of magnitude between the two.
  double size(double low, double high) { return low * std::exp(share() * std::log(high / low)); }
  int below(int count) { return static_cast<int>(share() * count); }
  bool coin() { return share() < 0.5; }
  Vec2 direction() {
    const double angle = between(0, 6.283185307179586);
    return {std::cos(angle), std::sin(angle)};
  }
  Vec2 point(double margin) {
    return {between(margin, kSide - margin), between(margin, kSide - margin)};
  }

 private:
  std::mt19937 engine_;
};

void add_line(Chain& chain, Vec2 to) {
  const Vec2 from = chain.back();
  chain.insert(chain.end(), {lerp(from, to, 1.0 / 3), lerp(from, to, 2.0 / 3), to});
}

Chain polygon_of(const std::vector<Vec2>& corners) {
  Chain chain{corners.front()};
  for (std::size_t i = 1; i < corners.size(); ++i) add_line(chain, corners[i]);
  add_line(chain, corners.front());
  return chain;
}

Vec2 turned(Vec2 v, double angle) {
  return {v.x * std::cos(angle) - v.y * std::sin(angle),
          v.x * std::sin(angle) + v.y * std::cos(angle)};
}

/// Returns two curves from tip to tip; the handles at a tip may have swapped sides.
LeakShape twisted_leaf(Random& random) {
  const Vec2 tip = random.point(4);
  Vec2 end = random.point(4);
  if (length(end - tip) < 10) end = lerp(tip, {kSide / 2.0, kSide / 2.0}, 1.6);
  const Vec2 along = (end - tip) * random.between(0.2, 0.5);
  const double open = random.between(0.02, 0.4);
  const double twist = random.between(-0.1, 0.1), bend = random.between(-0.5, 0.5);
  const Vec2 before = end - tip;
  Chain chain{tip,
              tip + turned(along, bend + twist),
              end - turned(along, -bend - open),
              end,
              end - turned(along, -bend + open * random.between(-0.1, 1)),
              tip + turned(before * random.between(0.2, 0.5), bend - twist),
              tip};
  return {"twisted leaf", {chain}, random.coin()};
}

/// Returns two boxes with a slit between them, straight or slanted.
LeakShape slit(Random& random) {
  const double gap = random.size(1e-6, 1), slant = random.coin() ? 0 : random.between(-0.3, 0.3);
  const double angle = random.coin() ? 0 : random.between(0, 3.2);
  const Vec2 middle{kSide / 2.0, kSide / 2.0};
  const double left = -random.between(5, 13), right = random.between(5, 13);
  const double top = -random.between(5, 13), bottom = random.between(5, 13);
  const bool shares_ends = random.coin();
  const double first = shares_ends ? top : top + random.between(0, 4);
  const double last = shares_ends ? bottom : bottom - random.between(0, 4);
  const double widens = random.coin() ? 1 : random.between(0, 3);
  std::vector<std::vector<Vec2>> boxes{
      {{left, top}, {slant * top, top}, {slant * bottom, bottom}, {left, bottom}},
      {{slant * first + gap, first},
       {right, first},
       {right, last},
       {slant * last + gap * widens, last}}};
  LeakShape shape{"slit " + number_text(gap), {}, random.coin()};
  for (std::vector<Vec2>& box : boxes) {
    for (Vec2& p : box) p = middle + turned(p, angle);
    if (!shape.even_odd && random.coin()) std::ranges::reverse(box);
    shape.chains.push_back(polygon_of(box));
  }
  return shape;
}

/// Returns a path of lines or curves, closed or not, with a stroke about as thin as the import can
/// distinguish from none.
LeakShape thin_stroke(Random& random) {
  LeakShape shape{"thin stroke", {}, false, random.size(kSide / 32768.0, 0.5), {}};
  const bool is_curved = random.coin(), is_closed = random.coin();
  Chain chain{random.point(6)};
  for (int count = 2 + random.below(4); count > 0; --count) {
    if (is_curved) {
      chain.insert(chain.end(), {random.point(6), random.point(6), random.point(6)});
    } else {
      add_line(chain, random.point(6));
    }
  }
  if (is_closed) add_line(chain, chain.front());
  shape.chains.push_back(chain);
  static constexpr const char* kJoins[] = {"miter", "round", "bevel"};
  static constexpr const char* kCaps[] = {"butt", "round", "square"};
  shape.style = std::string("stroke-linejoin='") + kJoins[random.below(3)] + "' stroke-linecap='" +
                kCaps[random.below(3)] + "'";
  return shape;
}

/// Returns a ribbon along a spiral, whose turns may be very close to each other.
LeakShape spiral(Random& random) {
  const Vec2 middle{kSide / 2.0, kSide / 2.0};
  const double turns = random.between(1, 4), step = random.between(1.5, 4);
  const double width = step * (1 - random.size(1e-5, 0.5));
  std::vector<Vec2> outside, inside;
  const int count = 12 * static_cast<int>(std::ceil(turns));
  for (int i = 0; i <= count; ++i) {
    const double turn = turns * i / count;
    const Vec2 away{std::cos(turn * 6.2831853), std::sin(turn * 6.2831853)};
    outside.push_back(middle + away * (2 + step * turn));
    inside.push_back(middle + away * (2 + step * turn - width));
  }
  outside.insert(outside.end(), inside.rbegin(), inside.rend());
  return {"spiral", {polygon_of(outside)}, random.coin()};
}

LeakShape star(Random& random) {
  const Vec2 middle{kSide / 2.0, kSide / 2.0};
  const int corners = 5 + 2 * random.below(5), step = 2 + random.below(corners / 2 - 1);
  std::vector<Vec2> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.283185307179586 * i * step / corners;
    points.push_back(middle + turned({random.between(17, 20), 0}, angle));
  }
  return {"star", {polygon_of(points)}, random.coin()};
}

/// Returns closed curves through any points.
LeakShape scribble(Random& random) {
  LeakShape shape{"scribble", {}, random.coin()};
  for (int chains = 1 + random.below(2); chains > 0; --chains) {
    Chain chain{random.point(5)};
    const Vec2 begin = chain.front();
    for (int count = 2 + random.below(4); count > 0; --count) {
      const Vec2 to = count == 1 ? begin : random.point(5);
      chain.insert(chain.end(), {random.point(2), random.point(2), to});
    }
    shape.chains.push_back(chain);
  }
  return shape;
}

/// Returns two ellipses or boxes that touch, or nearly touch.
LeakShape touching(Random& random) {
  LeakShape shape{"touching", {}, random.coin()};
  const double apart = (random.coin() ? 1 : -1) * random.size(1e-6, 1);
  const double radius = random.between(4, 11), second = random.between(4, 11);
  const double angle = random.between(0, 6.3);
  const Vec2 touch{kSide / 2.0, kSide / 2.0};
  for (const double at : {-radius, second + apart}) {
    const double size = std::abs(at < 0 ? radius : second);
    const double k = 0.5522847498307936 * size;
    const auto place = [&](double x, double y) { return touch + turned({at + x, y}, angle); };
    Chain chain{place(size, 0)};
    Vec2 out{1, 0};
    for (int quarter = 0; quarter < 4; ++quarter) {
      const Vec2 next{-out.y, out.x};
      const Vec2 a = out * size + next * k, b = next * size + out * k, c = next * size;
      chain.insert(chain.end(), {place(a.x, a.y), place(b.x, b.y), place(c.x, c.y)});
      out = next;
    }
    shape.chains.push_back(chain);
  }
  return shape;
}

LeakShape random_shape(std::uint32_t seed) {
  Random random(seed);
  switch (seed % 8) {
    case 0:
    case 1:
      return twisted_leaf(random);
    case 2:
      return slit(random);
    case 3:
      return thin_stroke(random);
    case 4:
      return spiral(random);
    case 5:
      return star(random);
    case 6:
      return scribble(random);
    default:
      return touching(random);
  }
}

std::string svg_of(const LeakShape& shape) {
  std::string data;
  for (const Chain& chain : shape.chains) {
    data += "M" + number_text(chain[0].x) + ' ' + number_text(chain[0].y);
    for (std::size_t i = 1; i < chain.size(); ++i) {
      data += (i % 3 == 1 ? 'C' : ' ') + number_text(chain[i].x) + ' ' + number_text(chain[i].y);
    }
    if (chain.front() == chain.back()) data += 'Z';
  }
  const std::string side = std::to_string(kSide);
  std::string paint = shape.even_odd ? "fill-rule='evenodd'" : "";
  if (shape.stroke_width > 0) {
    paint = "fill='none' stroke='#000' stroke-width='" + number_text(shape.stroke_width) + "' " +
            shape.style;
  }
  return "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " + side + ' ' + side + "'><path " +
         paint + " d='" + data + "'/></svg>";
}

/// The place of a point: the winding number, and the distance from the outline.
struct Place {
  int winding = 0;
  double distance = kSide;
};

Place place_of(const std::vector<std::vector<Vec2>>& polygons, Vec2 p) {
  Place place;
  for (const std::vector<Vec2>& polygon : polygons) {
    for (std::size_t i = 1; i < polygon.size(); ++i) {
      const Vec2 a = polygon[i - 1], b = polygon[i], along = b - a;
      const double size = length_squared(along);
      const double t = size > 0 ? std::clamp(dot(p - a, along) / size, 0.0, 1.0) : 0;
      place.distance = std::min(place.distance, length(p - a - along * t));
      const double side = cross(along, p - a);
      if (a.y <= p.y && b.y > p.y && side > 0) ++place.winding;
      if (b.y <= p.y && a.y > p.y && side < 0) --place.winding;
    }
  }
  return place;
}

/// Half a pixel for the outline, and half the diagonal of the examined pixel.
constexpr double kAway = 0.5 + 0.71;

/// Returns success if the opacity is 0 outside and 255 inside, away from the outline.
::testing::AssertionResult keeps_tight(const LeakShape& shape) {
  Context context;
  const auto made = import_svg(context, svg_of(shape), "leak.svg");
  if (!made) return ::testing::AssertionFailure() << made.status().message;
  const auto image = test::draw(context, made->document, kSide, kSide, PixelFormat::rgba8);
  if (!image) return ::testing::AssertionFailure() << image.status().message;
  std::vector<std::vector<Vec2>> polygons;
  for (const Chain& chain : shape.chains) {
    polygons.push_back(test::flattened(chain, 1e-3));
    if (shape.stroke_width == 0) polygons.back().push_back(chain.front());
  }
  // Miters reach at most twice the width beyond a corner.
  const double away = kAway + 2 * shape.stroke_width;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const Place place = place_of(polygons, {x + 0.5, y + 0.5});
      if (place.distance < away) continue;
      const bool is_inside =
          shape.stroke_width == 0 && (shape.even_odd ? place.winding % 2 != 0 : place.winding != 0);
      const int alpha = image->bytes[4 * (static_cast<std::size_t>(kSide) * y + x) + 3];
      if (alpha == (is_inside ? 255 : 0)) continue;
      return ::testing::AssertionFailure() << "alpha " << alpha << " at " << x << ", " << y
                                           << (is_inside ? " inside" : " outside");
    }
  }
  return ::testing::AssertionSuccess();
}

TEST(Leaks, none_beside_a_twisted_tip) {
  const double scale = kSide / 200.0;
  Chain leaf{{75.069, 67.659},   {94.921, 76.533}, {144.124, 103.604}, {152.011, 111.383},
             {141.292, 108.588}, {95.118, 76.079}, {75.069, 67.659}};
  for (Vec2& p : leaf) p = p * scale;
  EXPECT_TRUE(keeps_tight({"leaf", {leaf}}));
}

TEST(Leaks, none_between_halves_of_one_shape) {
  for (const double gap : {1e-5, 1e-4, 3e-4, 1e-3, 2e-3, 3e-3, 5e-3, 0.02}) {
    const Chain left = polygon_of({{14, 10}, {24, 10}, {24, 38}, {14, 38}});
    const Chain right = polygon_of({{24 + gap, 10}, {34, 10}, {34, 38}, {24 + gap, 38}});
    EXPECT_TRUE(keeps_tight({"halves", {left, right}})) << gap;
  }
}

TEST(Leaks, none_from_thin_strokes_with_any_join) {
  for (const char* join : {"miter", "round", "bevel"}) {
    for (const double welds : {0.8, 1.0, 1.3, 2.0, 4.0}) {
      LeakShape shape{join, {polygon_of({{30, 18}, {24, 24}, {18, 18}})}};
      shape.stroke_width = welds * kSide / 16384;
      shape.style = std::string("stroke-linejoin='") + join + "'";
      EXPECT_TRUE(keeps_tight(shape)) << join << ' ' << welds;
    }
  }
}

/// A loop that is thin enough to be dropped takes the loops inside it with it.
TEST(Leaks, none_from_a_hole_in_what_is_left_out) {
  const Chain outside = polygon_of({{24, 24},
                                    {24.05, 24},
                                    {24.05, 24.03},
                                    {44, 24.034},
                                    {24.05, 24.036},
                                    {24.05, 24.07},
                                    {24, 24.07}});
  const Chain hole =
      polygon_of({{24.005, 24.005}, {24.005, 24.065}, {24.045, 24.065}, {24.045, 24.005}});
  EXPECT_TRUE(keeps_tight({"hole", {outside, hole}}));
}

TEST(Leaks, no_random_shape_has_any) {
  const std::uint32_t count = test::random_case_count(500u, 10'000u);
  for (std::uint32_t seed = 0; seed < count; ++seed) {
    const LeakShape shape = random_shape(seed);
    EXPECT_TRUE(keeps_tight(shape))
        << "seed " << seed << ", " << shape.name << ": " << svg_of(shape);
  }
}

}  // namespace
}  // namespace sfumato
