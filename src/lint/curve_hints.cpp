#include "lint/curve_hints.hpp"

#include <algorithm>
#include <cmath>

#include "base/poll.hpp"
#include "base/segment.hpp"
#include "base/text/number_text.hpp"
#include "base/try.hpp"

namespace sfumato::lint_detail {
namespace {

/// A curve whose gap is below both was probably meant to be closed: a share of the curve's length,
/// and a multiple of artboard_pixel.
constexpr double kGapShare = 0.01;
constexpr double kGapPx = 4;

/// A loop whose area is a smaller share of its squared length has no real inside.
constexpr double kLeastAreaShare = 1e-6;

/// Holds facts about the flattened curve.
struct Outline {
  double length = 0;
  double doubled_area = 0;  ///< above 0: clockwise on the screen
  Box box;
  bool touches_sight = false;
};

bool touches(const Box& box, Vec2 a, Vec2 b) {
  const auto [from, to] = part_within(box, a, b);
  return from <= to;
}

/// Returns whether a curve runs along most of a side of the artboard, or round it. Such a curve
/// lies outside on purpose.
bool is_frame(const Outline& outline, const Box& sight) {
  const Box& box = outline.box;
  const double x = std::min(box.max.x, sight.max.x) - std::max(box.min.x, sight.min.x);
  const double y = std::min(box.max.y, sight.max.y) - std::max(box.min.y, sight.min.y);
  return x >= sight.width() / 2 || y >= sight.height() / 2;
}

Result<std::vector<Outline>> measure(const LayerUnderTest& test) {
  const curves::SegmentAttributes& flat = test.prepared.color.attributes;
  std::vector<Outline> outlines(test.curves().size());
  Vec2 origin;  // of the areas: the curve's first point
  RarePoll<16384> poll(test.context);
  for (std::size_t v = 0; v + 1 < flat.vertex.size(); ++v) {
    if (poll.cancelled()) return test.context.cancel_status();
    if (v == 0 || flat.curve[v] != flat.curve[v - 1]) origin = flat.vertex[v];
    if (flat.curve[v] != flat.curve[v + 1]) continue;
    Outline& outline = outlines[flat.curve[v]];
    outline.length += length(flat.vertex[v + 1] - flat.vertex[v]);
    outline.doubled_area += cross(flat.vertex[v] - origin, flat.vertex[v + 1] - origin);
    outline.box.extend(flat.vertex[v]);
    outline.box.extend(flat.vertex[v + 1]);
    outline.touches_sight |= touches(test.sight.viewport, flat.vertex[v], flat.vertex[v + 1]);
  }
  return outlines;
}

void check_open(LayerUnderTest& test, std::uint32_t index, const Outline& outline) {
  const std::vector<Vec2>& points = test.curves()[index].control_points;
  const double gap = length(points.back() - points.front());
  const double pixel = artboard_pixel(test.document);
  if (gap >= kGapShare * outline.length || gap * test.sight.scale >= kGapPx * pixel) return;
  test.add(HintKind::open_loop, index,
           "its ends are " + rounded_number_text(gap, 2) +
               " units apart: it looks closed, but colours leak through the gap; close it (Z in a "
               "path)");
}

/// Colours that differ less pass for shading where they meet.
constexpr float kSeam = 24 / 255.f;

/// If a closed curve turns by more than this at its ends, an edge may begin there intentionally: a
/// cosine.
constexpr double kSmooth = 0.866;

/// Returns whether a closed curve keeps its direction where it closes, to within 30°.
bool closes_smoothly(const Curve& curve) {
  const std::vector<Vec2>& points = curve.control_points;
  const Vec2 end = points.front();
  const auto is_away = [end](Vec2 p) { return !(p == end); };
  const auto first = std::ranges::find_if(points, is_away);
  const auto last = std::find_if(points.rbegin(), points.rend(), is_away);
  if (first == points.end()) return false;
  const Vec2 out = *first - end, in = end - *last;
  return dot(in, out) >= kSmooth * length(in) * length(out);
}

bool is_seam(const Rgb& a, const Rgb& b) {
  return std::abs(a.r - b.r) > kSeam || std::abs(a.g - b.g) > kSeam || std::abs(a.b - b.b) > kSeam;
}

void check_seam(LayerUnderTest& test, std::uint32_t index, CurveSide which, const Side& side) {
  if (side.color.kind != ShaderKind::curve_domain || side.color.stops.stops.size() < 2) return;
  const Rgb &first = side.color.stops.stops.front().value,
            &last = side.color.stops.stops.back().value;
  if (!is_seam(first, last)) return;
  const Vec2 at = test.curves()[index].control_points.front();
  Hint& hint =
      test.add(HintKind::seam, index,
               "it is closed, but its colours begin with " + color_text(first) + " and end with " +
                   color_text(last) + ": a seam shows at " + rounded_number_text(at.x, 4) + ", " +
                   rounded_number_text(at.y, 4) + "; end with the first colour");
  hint.side = which;
  hint.at = at;
}

void check_closed(LayerUnderTest& test, std::uint32_t index, const Outline& outline) {
  if (std::abs(outline.doubled_area) <= kLeastAreaShare * outline.length * outline.length) return;
  const bool clockwise = outline.doubled_area > 0;
  const Curve& curve = test.curves()[index];
  const Side& inside = clockwise ? curve.right : curve.left;
  const Side& outside = clockwise ? curve.left : curve.right;
  const std::string inner = clockwise ? "right" : "left", outer = clockwise ? "left" : "right";
  const std::string turn = clockwise ? "clockwise" : "counter-clockwise";
  test.add(HintKind::closed_loop, index,
           "it is closed and " + turn + ": its inside is on the " + inner);
  if (bears_anything(inside) || !bears_anything(outside)) return;
  test.add(HintKind::inside_empty, index,
           "the loop is " + turn + ", so its inside is the " + inner +
               " side, which has nothing, while the outside has; reverse the path, or swap sf:" +
               outer + " and sf:" + inner + ", if the inside was meant");
}

void check_side(LayerUnderTest& test, std::uint32_t index, CurveSide which, const Side& side) {
  if (!curves::is_blurred(side) || curves::has_value(side.color) || curves::has_value(side.opacity))
    return;
  test.add(
          HintKind::blur_without_shader, index,
          "it has a blur radius but no colour or opacity to blur; add a colour, or remove the blur")
      .side = which;
}

}  // namespace

Status check_curves(LayerUnderTest& test) {
  SFUMATO_TRY_ASSIGN(const std::vector<Outline>& measured, measure(test));
  const std::vector<Outline>& outlines = measured;
  RarePoll<1024> poll(test.context);
  for (std::uint32_t i = 0; i < outlines.size(); ++i) {
    if (poll.cancelled()) return test.context.cancel_status();
    const Curve& curve = test.curves()[i];
    const bool closed = curve.control_points.front() == curve.control_points.back();
    if (closed) {
      check_closed(test, i, outlines[i]);
      if (closes_smoothly(curve)) {
        check_seam(test, i, CurveSide::left, curve.left);
        check_seam(test, i, CurveSide::right, curve.right);
      }
    } else {
      check_open(test, i, outlines[i]);
    }
    if (!bears_anything(curve.left) && !bears_anything(curve.right)) {
      test.add(HintKind::no_attribute, i,
               "it has no colour, no opacity and no barrier, so it draws nothing; add sf:left or "
               "sf:right");
    }
    check_side(test, i, CurveSide::left, curve.left);
    check_side(test, i, CurveSide::right, curve.right);
    if (!outlines[i].touches_sight && !is_frame(outlines[i], test.sight.viewport)) {
      test.add(HintKind::outside, i,
               "it lies wholly outside the artboard, so only its influence can show");
    }
  }
  return ok_status();
}

}  // namespace sfumato::lint_detail
