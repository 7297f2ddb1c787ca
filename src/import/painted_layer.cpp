#include "import/painted_layer.hpp"

#include <algorithm>
#include <utility>

namespace sfumato::svg_import {
namespace {

/// Chords whose distance is looked at for one shape: more, and it gets a layer of its own.
constexpr std::size_t kPairs = 20'000'000;
/// Of image-domain shaders in one layer; as many again are opacities of gradients.
constexpr std::size_t kShaders = 16;

/// The squared distance of a point from a chord.
double distance_squared(Vec2 p, const Chord& chord) {
  const Vec2 along = chord.to - chord.from;
  const double size = length_squared(along);
  const double t = size > 0 ? std::clamp(dot(p - chord.from, along) / size, 0.0, 1.0) : 0;
  return length_squared(p - (chord.from + along * t));
}

Box box_of(const Chord& chord) {
  Box box;
  box.extend(chord.from);
  box.extend(chord.to);
  return box;
}

bool cross_each_other(const Chord& a, const Chord& b) {
  const Vec2 along_a = a.to - a.from, along_b = b.to - b.from;
  const bool parts_b = (cross(along_a, b.from - a.from) > 0) != (cross(along_a, b.to - a.from) > 0);
  const bool parts_a = (cross(along_b, a.from - b.from) > 0) != (cross(along_b, a.to - b.from) > 0);
  return parts_a && parts_b;
}

bool are_near(const Chord& a, const Chord& b, double distance) {
  const double most = distance * distance;
  return distance_squared(a.from, b) <= most || distance_squared(a.to, b) <= most ||
         distance_squared(b.from, a) <= most || distance_squared(b.to, a) <= most ||
         cross_each_other(a, b);
}

}  // namespace

Result<PaintedLayer::Shape> PaintedLayer::shape_of(Context& context, const Region& region) const {
  Shape shape{{}, {}, region.color, region.is_opaque};
  for (std::uint32_t c = 0; c < region.boundary.size(); ++c) {
    Vec2 from = region.boundary[c].front();
    shape.box.extend(from);
    Status status;
    for_each_chord_end(region.boundary[c], tolerance_, [&](Vec2 to) {
      if (!status) return;
      shape.box.extend(to);
      status = shape.memory.push_back(context, shape.chords, {from, to, 0, 0, c});
      from = to;
    });
    if (!status) return status;
  }
  return shape;
}

/// Whether no boundaries meet.
Result<bool> PaintedLayer::keeps_apart(Context& context, const Shape& a, const Shape& b) {
  const double distance = 4 * tolerance_;
  const Box box = a.box.grown_by(distance);
  if (!overlap(box, b.box)) return true;
  TableMemory working("the shapes");
  std::vector<const Chord*> near;
  Status status = working.reserve(context, near, b.chords.size());
  if (!status) return status;
  for (const Chord& chord : b.chords) {
    if (overlap(box, box_of(chord))) near.push_back(&chord);
  }
  if (context.cancelled()) return context.cancel_status();
  if (near.size() * a.chords.size() > kPairs) return false;
  for (const Chord& chord : a.chords) {
    const Box around = box_of(chord).grown_by(distance);
    for (const Chord* other : near) {
      if (overlap(around, box_of(*other)) && are_near(chord, *other, distance)) return false;
    }
  }
  return true;
}

bool PaintedLayer::is_within(const Shape& shape, Vec2 point) const {
  return shape.box.contains(point) && winding_number(shape.chords, point) != 0;
}

/// What of the layer is seen where the shape's first point is.
const PaintedLayer::Shape* PaintedLayer::under(const Shape& shape) const {
  for (std::size_t i = shapes_.size(); i-- > 0;) {
    if (is_within(shapes_[i], shape.chords.front().from)) return &shapes_[i];
  }
  return nullptr;
}

void PaintedLayer::note_shader(const SideShader<Rgb>& side) {
  if (side.kind != ShaderKind::image_domain) return;
  if (std::ranges::find(shaders_, side.shader) == shaders_.end()) shaders_.push_back(side.shader);
}

Result<bool> PaintedLayer::try_add(Context& context, const Region& region) {
  Result<Shape> made = shape_of(context, region);
  if (!made) return made.status();
  Shape& shape = *made;
  if (shapes_.empty() || shape.chords.empty() || shaders_.size() >= kShaders) return false;
  const Shape* ground = under(shape);
  if (ground && !(ground->is_opaque && region.is_opaque)) return false;
  for (const Shape& other : shapes_) {
    const Result<bool> apart = keeps_apart(context, shape, other);
    if (!apart || !*apart) return apart;
  }
  // Every loop lies on the same ground, and no loop of the layer within the shape.
  for (const Chord& chord : shape.chords) {
    const bool begins_loop =
        &chord == shape.chords.data() || (&chord - 1)->contour != chord.contour;
    if (!begins_loop) continue;
    const Shape* here = nullptr;
    for (const Shape& other : shapes_) {
      if (is_within(other, chord.from)) here = &other;
    }
    if (here != ground) return false;
  }
  for (const Shape& other : shapes_) {
    for (const Chord& chord : other.chords) {
      const bool begins_loop =
          &chord == other.chords.data() || (&chord - 1)->contour != chord.contour;
      if (begins_loop && is_within(shape, chord.from)) return false;
    }
  }
  Status status = append(context, region, std::move(shape), ground);
  if (!status) return status;
  return true;
}

Status PaintedLayer::add(Context& context, const Region& region) {
  Result<Shape> made = shape_of(context, region);
  return made ? append(context, region, std::move(*made), nullptr) : made.status();
}

Status PaintedLayer::append(Context& context, const Region& region, Shape shape,
                            const Shape* under) {
  Status status = memory_.make_room(context, curves_, region.boundary.size());
  for (std::size_t i = 0; status && i < region.boundary.size(); ++i) {
    Curve& curve = curves_.emplace_back();
    curve.id = region.id.empty() || i == 0 ? region.id : region.id + '-' + std::to_string(i + 1);
    status = memory_.append(context, region.boundary[i], curve.control_points);
    curve.right.color = region.color;
    curve.left.color = under ? under->color : region.color;
    if (under) continue;
    curve.right.opacity = region.opacity;
    curve.left.opacity = {ShaderKind::curve_domain, {StopSpace::parameter, {{0, 0.0F}}}, 0};
  }
  note_shader(region.color);
  return status ? shape_memory_.push_back(context, shapes_, std::move(shape)) : status;
}

}  // namespace sfumato::svg_import
