#include <algorithm>
#include <functional>
#include <unordered_map>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "gather/scene/scene.hpp"
#include "lint/curve_hints.hpp"

namespace sfumato::lint_detail {
namespace {

/// Returns the bits of a chain of points in any order and direction, mixed (FNV-1a per point,
/// summed).
std::uint64_t hash_of_points(const std::vector<Vec2>& points) {
  std::uint64_t sum = 0;
  for (const Vec2 p : points) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const double coordinate : {p.x + 0.0, p.y + 0.0}) {  // + 0.0: one zero
      hash = (hash ^ std::hash<double>()(coordinate)) * 0x100000001b3u;
    }
    sum += hash;
  }
  return sum;
}

bool is_reversed(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return std::equal(a.begin(), a.end(), b.rbegin(), b.rend());
}

bool bears_color(const Curve& curve) {
  return curve.left.color.kind != ShaderKind::open || curve.right.color.kind != ShaderKind::open;
}

/// Marks curves that a later curve hides: it has the same points and an attribute in common.
Result<std::vector<bool>> check_duplicates(LayerUnderTest& test) {
  const std::vector<Curve>& curves = test.curves();
  std::vector<bool> hidden(curves.size(), false);
  std::unordered_map<std::uint64_t, std::uint32_t> last_with_hash;
  RarePoll<1024> poll(test.context);
  for (std::uint32_t i = 0; i < curves.size(); ++i) {
    if (poll.cancelled()) return test.context.cancel_status();
    const Curve& curve = curves[i];
    const auto [entry, is_new] =
        last_with_hash.try_emplace(hash_of_points(curve.control_points), i);
    const std::uint32_t earlier = std::exchange(entry->second, i);
    if (is_new) continue;
    const Curve& other = curves[earlier];
    const bool same = curve.control_points == other.control_points;
    if (!same && !is_reversed(curve.control_points, other.control_points)) continue;
    const bool both_color = bears_color(curve) && bears_color(other);
    const bool both_opacity = curves::bears_opacity(curve) && curves::bears_opacity(other);
    if (!both_color && !both_opacity) continue;
    hidden[earlier] = true;
    test.add(HintKind::duplicate, i,
             "it lies exactly on curve " + std::to_string(earlier) +
                 (same ? "" : ", in the other direction,") + " and both have " +
                 (both_color ? "colour" : "opacity") +
                 ", so the later one hides the earlier; delete one");
  }
  return hidden;
}

/// Finds the sides of curves that rays of one attribute from the artboard meet: index 2 · curve +
/// (0: left, 1: right).
///
/// A triangle of the visibility mesh is reached if it meets the artboard's box, or if a ray could
/// pass into it from a reached triangle. That covers more than straight rays see, so a side that is
/// not reached is certainly not seen.
class Reach {
 public:
  Reach(const Context& context, const mesh::TriangleMesh& mesh,
        curves::SegmentAttributes attributes, std::size_t curve_count)
      : context_(context),
        poll_(context),
        mesh_(mesh),
        attributes_(std::move(attributes)),
        met_(2 * curve_count, false) {
    name_sides();
  }

  /// Must be called first. Errors: cancelled.
  Status look_from(const Box& artboard) {
    SFUMATO_TRY(enter(artboard));
    while (!open_.empty()) {
      if (poll_.cancelled()) return context_.cancel_status();
      const std::uint32_t triangle = open_.back();
      open_.pop_back();
      for (std::uint32_t k = 0; k < 3; ++k) look_across(3 * triangle + k);
    }
    return ok_status();
  }

  bool meets(std::uint32_t curve, CurveSide side) const {
    return met_[2 * std::size_t{curve} + (side == CurveSide::right)];
  }

 private:
  /// The gather finds what a ray meets; here its shader numbers stand for sides.
  void name_sides() {
    for (std::size_t v = 0; v < attributes_.curve.size(); ++v) {
      attributes_.left[v].shader = 2 * attributes_.curve[v];
      attributes_.right[v].shader = 2 * attributes_.curve[v] + 1;
    }
  }

  Status enter(const Box& artboard) {
    entered_.resize(mesh_.triangle_count(), false);
    for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
      if (poll_.cancelled()) return context_.cancel_status();
      Box box;
      for (std::size_t k = 0; k < 3; ++k) {
        box.extend(mesh_.vertex_position[mesh_.triangle_vertex[3 * std::size_t{t} + k]]);
      }
      if (overlap(box, artboard)) push(t);
    }
    return ok_status();
  }

  void push(std::uint32_t triangle) {
    if (entered_[triangle]) return;
    entered_[triangle] = true;
    open_.push_back(triangle);
  }

  void look_across(std::uint32_t half_edge) {
    if (mesh_.half_edge_constraint[half_edge] != mesh::kNone) {
      const gather::Facing facing = gather::facing_side(mesh_, attributes_, half_edge);
      if (facing.kind != ShaderKind::open) {
        met_[facing.shader] = true;
        const bool is_blurred = facing.blur_from > 0 || facing.blur_to > 0;
        if (is_blurred) look_behind(half_edge);
        return;
      }
    }
    const std::int32_t twin = mesh_.half_edge_twin[half_edge];
    if (twin != mesh::kNone) push(static_cast<std::uint32_t>(twin) / 3);
  }

  /// A blurred side lets part of the area behind it show.
  void look_behind(std::uint32_t half_edge) {
    const gather::Facing back = gather::back_side(mesh_, attributes_, half_edge);
    if (back.kind != ShaderKind::open) met_[back.shader] = true;
  }

  const Context& context_;
  RarePoll<4096> poll_;
  const mesh::TriangleMesh& mesh_;
  curves::SegmentAttributes attributes_;
  std::vector<bool> met_;
  std::vector<bool> entered_;
  std::vector<std::uint32_t> open_;
};

void add_unseen(LayerUnderTest& test, std::uint32_t curve, CurveSide side, const char* attribute) {
  test.add(HintKind::unseen_side, curve,
           std::string("no ray from the artboard reaches its ") + attribute +
               ", because another curve lies on it or walls it off; remove the " + attribute +
               ", or move a curve")
      .side = side;
}

}  // namespace

Status check_visibility(LayerUnderTest& test) {
  SFUMATO_TRY_ASSIGN(const std::vector<bool>& hidden, check_duplicates(test));
  const std::vector<Curve>& curves = test.curves();
  const mesh::TriangleMesh& mesh = test.mesh;
  const Box& sight = test.sight.viewport;
  Reach color(test.context, mesh, test.prepared.color.attributes, curves.size());
  SFUMATO_TRY(color.look_from(sight));
  std::optional<Reach> opacity;
  if (test.prepared.opacity) {
    opacity.emplace(test.context, mesh, test.prepared.opacity->attributes, curves.size());
    SFUMATO_TRY(opacity->look_from(sight));
  }
  RarePoll<4096> poll(test.context);
  for (std::uint32_t i = 0; i < curves.size(); ++i) {
    if (poll.cancelled()) return test.context.cancel_status();
    if (hidden[i]) continue;
    for (const CurveSide which : {CurveSide::left, CurveSide::right}) {
      const Side& side = which == CurveSide::left ? curves[i].left : curves[i].right;
      if (curves::has_value(side.color) && !color.meets(i, which))
        add_unseen(test, i, which, "colour");
      if (curves::has_value(side.opacity) && !opacity->meets(i, which)) {
        add_unseen(test, i, which, "opacity");
      }
    }
  }
  return test.context.check();
}

}  // namespace sfumato::lint_detail
