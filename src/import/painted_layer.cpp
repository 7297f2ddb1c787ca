#include "import/painted_layer.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/poll.hpp"
#include "base/segment.hpp"
#include "base/try.hpp"

namespace sfumato::svg_import {
namespace {

/// Returns the squared distance of a point from a chord.
double distance_squared(Vec2 p, const Chord& chord) {
  return length_squared(p - nearest_on_segment(p, chord.from, chord.to));
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

Box common(const Box& a, const Box& b) {
  return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
          {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}

/// Returns the chords in a box.
Result<std::vector<const Chord*>> chords_in(Context& context, const Outline& outline,
                                            const Box& box, TableMemory& memory) {
  std::vector<const Chord*> near;
  for (const Chord& chord : outline.chords) {
    if (!overlap(box, box_of(chord))) continue;
    SFUMATO_TRY(memory.push_back(context, near, &chord));
  }
  if (context.cancelled()) return context.cancel_status();
  return near;
}

/// Takes this many of the remaining steps. Returns false if they do not suffice; then none is left.
bool take(std::size_t& steps, std::size_t count) {
  const bool suffices = count < steps;
  steps = suffices ? steps - count : 0;
  return suffices;
}

bool is_within(const Outline& outline, Vec2 point, std::size_t& steps) {
  return outline.box.contains(point) && take(steps, outline.chords.size()) &&
         winding_number(outline.chords, point) != 0;
}

/// Calls visit(point) with a point of each loop until it returns false. Returns whether it never
/// did. Errors: as Context::cancel_status.
template <class Visit>
Result<bool> all_loops(const Context& context, const Outline& outline, Visit visit) {
  RarePoll<16> poll(context);
  for (std::size_t i = 0; i < outline.chords.size(); ++i) {
    const Chord& chord = outline.chords[i];
    const bool begins_loop = i == 0 || outline.chords[i - 1].contour != chord.contour;
    if (!begins_loop) continue;
    if (poll.cancelled()) return context.cancel_status();
    if (!visit(chord.from)) return false;
  }
  return true;
}

template <class Value>
void note_shader(const SideShader<Value>& side, std::vector<std::uint32_t>& shaders) {
  if (side.kind != ShaderKind::image_domain) return;
  if (std::ranges::find(shaders, side.shader) == shaders.end()) shaders.push_back(side.shader);
}

}  // namespace

Result<Outline> outline_of(Context& context, const Region& region, double tolerance) {
  Outline outline{{}, {}, region.color, region.is_opaque};
  for (std::uint32_t c = 0; c < region.boundary.size(); ++c) {
    Vec2 from = region.boundary[c].front();
    outline.box.extend(from);
    Status status;
    for_each_chord_end(region.boundary[c], tolerance, [&](Vec2 to) {
      if (!status) return;
      outline.box.extend(to);
      status = outline.memory.push_back(context, outline.chords, {from, to, 0, 0, c});
      from = to;
    });
    if (!status) return status;
  }
  return outline;
}

/// Returns whether no boundaries meet.
Result<bool> PaintedLayer::keeps_apart(Context& context, const Outline& a, const Outline& b,
                                       std::size_t& steps) const {
  const double distance = 4 * tolerance_;
  const Box box = common(a.box.grown_by(distance), b.box.grown_by(distance));
  if (!take(steps, a.chords.size() + b.chords.size())) return false;
  TableMemory working("the shapes");
  SFUMATO_TRY_ASSIGN(const auto& near_a, chords_in(context, a, box, working));
  SFUMATO_TRY_ASSIGN(const auto& near_b, chords_in(context, b, box, working));
  if (!take(steps, near_a.size() * near_b.size())) return false;
  for (const Chord* chord : near_a) {
    const Box around = box_of(*chord).grown_by(distance);
    for (const Chord* other : near_b) {
      if (overlap(around, box_of(*other)) && are_near(*chord, *other, distance)) return false;
    }
  }
  return true;
}

/// Finds the ground of an outline that meets no boundary of the layer: all its loops lie on the
/// same ground.
Result<Fit> PaintedLayer::ground_of(const Context& context, const Outline& outline,
                                    std::size_t& steps) const {
  const auto topmost_at = [&](Vec2 point) {
    std::size_t i = outlines_.size();
    while (i > 0 && !is_within(outlines_[i - 1], point, steps)) --i;
    return i;  // one more than the index
  };
  const std::size_t ground = topmost_at(outline.chords.front().from);
  SFUMATO_TRY_ASSIGN(const bool on_same, all_loops(context, outline, [&](Vec2 point) {
                       return topmost_at(point) == ground;
                     }));
  if (!on_same) return Fit{Fit::Kind::covers};
  if (ground == 0) return Fit{};
  const bool is_opaque = outlines_[ground - 1].is_opaque && outline.is_opaque;
  return Fit{is_opaque ? Fit::Kind::on_one : Fit::Kind::covers, ground - 1};
}

Result<Fit> PaintedLayer::look(Context& context, const Outline& outline, std::size_t& steps) const {
  if (outline.chords.empty()) return Fit{Fit::Kind::covers};
  const Box box = outline.box.grown_by(4 * tolerance_);
  bool is_near = false;
  for (const Outline& other : outlines_) {
    if (!overlap(box, other.box)) continue;
    is_near = true;
    SFUMATO_TRY_ASSIGN(const bool apart, keeps_apart(context, outline, other, steps));
    const auto is_outside = [&](Vec2 point) { return !is_within(outline, point, steps); };
    if (!apart) return Fit{Fit::Kind::covers};
    SFUMATO_TRY_ASSIGN(const bool outside, all_loops(context, other, is_outside));
    if (!outside) return Fit{Fit::Kind::covers};
  }
  if (!is_near) return Fit{};
  const Result<Fit> fit = ground_of(context, outline, steps);
  return !fit || steps > 0 ? fit : Fit{Fit::Kind::covers};
}

Status PaintedLayer::add(Context& context, const Region& region, Outline outline, const Fit& fit) {
  const Outline* under = fit.kind == Fit::Kind::on_one ? &outlines_[fit.ground] : nullptr;
  Status status = memory_.make_room(context, curves_, region.boundary.size());
  for (std::size_t i = 0; status && i < region.boundary.size(); ++i) {
    Curve& curve = curves_.emplace_back();
    curve.id = region.id.empty() || i == 0 ? region.id : region.id + '-' + std::to_string(i + 1);
    status = memory_.append(context, region.boundary[i], curve.control_points);
    curve.right.color = region.color;
    curve.left.color = under ? under->color : region.color;
    if (region.blur_radius > 0) {
      const ScalarStops radius{StopSpace::parameter, {{0, static_cast<float>(region.blur_radius)}}};
      curve.left.blur_radius = curve.right.blur_radius = radius;
    }
    if (under) continue;
    curve.right.opacity = region.opacity;
    curve.left.opacity = {ShaderKind::curve_domain, {StopSpace::parameter, {{0, 0.0F}}}, 0};
  }
  note_shader(region.color, shaders_);
  if (!under) note_shader(region.opacity, opacity_shaders_);
  return status ? outline_memory_.push_back(context, outlines_, std::move(outline)) : status;
}

}  // namespace sfumato::svg_import
