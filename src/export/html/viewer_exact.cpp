#include "export/html/viewer_exact.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "export/html/viewer_mesh.hpp"

namespace sfumato::outputs {
namespace {

/// The version of the part, in case it changes.
constexpr std::uint8_t kExactVersion = 1;

/// Flags of the data that follow for a layer.
enum class ExactKind : std::uint8_t { none = 0, with_patches = 1, alone = 2 };

constexpr int kMissBytes = 4;
constexpr double kLargestNumber = 1 << 28;

/// The largest difference in steps from the prediction for a number that still continues the
/// numbers before it.
constexpr std::int32_t kSmallMiss = 3;

/// The most edges around a vertex that are examined to find the next side.
constexpr int kEdgesLookedAt = 64;

/// Steps of a colour, and of an opacity: 1/64 of a code value is the most that a number misses.
double exact_step(InterpolationSpace space) {
  return space == InterpolationSpace::srgb ? 1.0 / (32 * 255) : 1.0 / (1 << 17);
}

std::int32_t quantized(double value, double step) {
  const double steps = value / step;
  if (!std::isfinite(steps)) return 0;
  return static_cast<std::int32_t>(std::lround(std::clamp(steps, -kLargestNumber, kLargestNumber)));
}

/// Returns the same triangles as patches; curves are where a field is not open.
Result<PatchLayer> mesh_of(const Context& context, const ExactLayer& layer, TableMemory& memory) {
  PatchLayer mesh;
  SFUMATO_TRY(memory.assign(context, layer.vertex_position, mesh.vertex_position));
  SFUMATO_TRY(memory.assign(context, layer.triangle_vertex, mesh.triangle_vertex));
  SFUMATO_TRY(memory.resize(context, mesh.edge_is_curve, mesh.triangle_vertex.size()));
  for (const ExactField& field : layer.field) {
    for (std::size_t h = 0; h < field.edge.size(); ++h)
      if (field.edge[h] != RayEdge::open) mesh.edge_is_curve[h] = 1;
  }
  return mesh;
}

/// Half-edges on curves in the order of their written attributes: along the curves.
struct CurveEdge {
  std::uint32_t half_edge;  ///< of the viewer's order
  bool continues;           ///< the one before
  double length;
};

/// The vertices of a layer's patches by their positions, and where the viewer has them.
class PatchVertices {
 public:
  static constexpr std::uint32_t kNone = 0xffffffff;

  Status list(Context& context, const PatchLayer& layer) {
    SFUMATO_TRY_ASSIGN(const ViewerMesh& mesh, order_for_viewer(context, layer));
    grid_ = grid_of(layer, mesh);
    SFUMATO_TRY(memory_.resize(context, vertex_, mesh.vertex.size()));
    for (std::uint32_t i = 0; i < vertex_.size(); ++i)
      vertex_[i] = {layer.vertex_position[mesh.vertex[i]], i};
    return TableMemory::sort(context, vertex_, is_before);
  }

  /// Alternative to list() if there are no half-edges.
  void list_none(const ViewerGrid& grid) { grid_ = grid; }

  /// Returns the number of the one at a position, or kNone.
  std::uint32_t at(Vec2 position) const {
    const Vertex wanted{position, 0};
    const auto found = std::ranges::lower_bound(vertex_, wanted, is_before);
    const bool is_there = found != vertex_.end() && found->position.x == position.x &&
                          found->position.y == position.y;
    return is_there ? found->number : kNone;
  }

  const ViewerGrid& grid() const { return grid_; }

 private:
  struct Vertex {
    Vec2 position;
    std::uint32_t number;
  };
  static bool is_before(const Vertex& a, const Vertex& b) {
    if (a.position.x != b.position.x) return a.position.x < b.position.x;
    if (a.position.y != b.position.y) return a.position.y < b.position.y;
    return a.number < b.number;
  }

  ViewerGrid grid_{};
  TableMemory memory_{"the viewer's exact fields"};
  std::vector<Vertex> vertex_;
};

/// The triangles of a layer, and where its curves run.
class CurveWriter {
 public:
  /// grid   for vertices that are none of patches
  CurveWriter(Context& context, const PatchLayer& layer, const ViewerMesh& mesh,
              const PatchVertices& patches, const ViewerGrid& grid, ByteWriter& out)
      : context_(context), layer_(layer), mesh_(mesh), patches_(patches), grid_(grid), out_(out) {}

  Status run() {
    out_.varint(mesh_.triangle_count());
    out_.varint(mesh_.vertex.size());
    out_.counted(mesh_.codes);
    write_curves(layer_, mesh_, out_);
    Status status = find_twins();
    if (status) status = find_order();
    return status ? write_positions() : status;
  }

  const std::vector<CurveEdge>& order() const { return order_; }
  const ViewerGrid& grid() const { return grid_; }
  /// Origin of the positions.
  Vec2 middle() const { return patches_.grid().middle(); }

  /// Returns the layer's half-edge.
  std::uint32_t source(std::uint32_t h) const {
    const std::uint32_t t = h / 3;
    return 3 * mesh_.triangle[t] + (mesh_.first_corner[t] + h % 3) % 3;
  }
  std::uint32_t origin(std::uint32_t h) const { return mesh_.corner_vertex[h]; }
  std::uint32_t target(std::uint32_t h) const { return mesh_.corner_vertex[next_half_edge(h)]; }

 private:
  Status find_twins() {
    SFUMATO_TRY(memory_.resize(context_, twin_, mesh_.corner_vertex.size(), kNoHalfEdge));
    for (std::uint32_t h = 0; h < twin_.size(); ++h) {
      if (mesh_.mate[h] == kNoHalfEdge) continue;
      twin_[h] = mesh_.mate[h];
      twin_[mesh_.mate[h]] = h;
    }
    return ok_status();
  }

  bool is_curve(std::uint32_t h) const { return layer_.edge_is_curve[source(h)] != 0; }

  /// Returns the edge whose attributes continue this edge's attributes for rays, at its origin or
  /// target.
  template <class Turn>
  std::uint32_t neighbour(std::uint32_t h, Turn turn) const {
    std::uint32_t g = turn(h);
    for (int i = 0; i < kEdgesLookedAt && !is_curve(g); ++i) {
      if (twin_[g] == kNoHalfEdge) return kNoHalfEdge;
      g = turn(twin_[g]);
    }
    return is_curve(g) ? g : kNoHalfEdge;
  }

  /// Half-edges that begin a line come first, then closed lines.
  Status find_order() {
    std::vector<std::uint8_t> is_listed;
    const std::size_t count = mesh_.corner_vertex.size();
    Status status = memory_.resize(context_, is_listed, count);
    RarePoll<4096> poll(context_);
    for (const bool only_starts : {true, false}) {
      for (std::uint32_t h = 0; status && h < count; ++h) {
        if (poll.cancelled()) return context_.cancel_status();
        if (!is_curve(h) || is_listed[h]) continue;
        if (only_starts && neighbour(h, previous_half_edge) != kNoHalfEdge) continue;
        for (std::uint32_t g = h; status && g != kNoHalfEdge && !is_listed[g];
             g = neighbour(g, next_half_edge)) {
          status = memory_.push_back(context_, order_, CurveEdge{g, g != h, 0});
          is_listed[g] = 1;
        }
      }
    }
    return status;
  }

  /// Vertices on curves come first, then the others.
  Status write_positions() {
    const std::size_t count = mesh_.vertex.size();
    SFUMATO_TRY(memory_.resize_all(context_, count, place_, is_placed_));
    for (std::vector<std::uint32_t>* table : {&numbers_, &miss_x_, &miss_y_})
      SFUMATO_TRY(memory_.reserve(context_, *table, count));
    for (CurveEdge& edge : order_) {
      const std::uint32_t a = origin(edge.half_edge), b = target(edge.half_edge);
      put(a);
      put(b);
      const double x = double{place_[b].x} - double{place_[a].x};
      const double y = double{place_[b].y} - double{place_[a].y};
      edge.length = std::sqrt(x * x + y * y);
    }
    for (std::uint32_t v = 0; v < count; ++v) put(v);
    out_.planes(numbers_, kMissBytes);
    write_grid(grid_, out_);
    out_.varint(miss_x_.size());
    out_.planes(miss_x_, kMissBytes);
    out_.planes(miss_y_, kMissBytes);
    return out_.status();
  }

  /// Most are vertices of patches.
  void put(std::uint32_t vertex) {
    if (is_placed_[vertex]) return;
    is_placed_[vertex] = 1;
    const Vec2 position = layer_.vertex_position[mesh_.vertex[vertex]];
    const std::uint32_t number = patches_.at(position);
    if (number != PatchVertices::kNone) {
      numbers_.push_back(1 + zigzag(static_cast<std::int32_t>(number - last_number_)));
      last_number_ = number;
      place_[vertex] = patches_.grid().place(patches_.grid().nearest(position));
      return;
    }
    numbers_.push_back(0);
    const GridPoint point = grid_.nearest(position);
    miss_x_.push_back(zigzag(point.x - last_.x));
    miss_y_.push_back(zigzag(point.y - last_.y));
    last_ = point;
    place_[vertex] = grid_.place(point, middle());
  }

  Context& context_;
  const PatchLayer& layer_;
  const ViewerMesh& mesh_;
  const PatchVertices& patches_;
  ViewerGrid grid_;
  TableMemory memory_{"the viewer's exact fields"};
  std::vector<std::uint32_t> twin_;  ///< per half-edge
  std::vector<CurveEdge> order_;
  std::vector<ViewerGrid::Place> place_;  ///< per vertex
  std::vector<std::uint8_t> is_placed_;   ///< per vertex
  std::uint32_t last_number_ = 0;
  GridPoint last_;
  std::vector<std::uint32_t> numbers_, miss_x_, miss_y_;
  ByteWriter& out_;
};

/// One attribute on the curves.
class FieldOnCurves {
 public:
  FieldOnCurves(Context& context, const ExactField& field, const CurveWriter& curves, double step,
                ByteWriter& out)
      : context_(context), field_(field), curves_(curves), step_(step), out_(out) {}

  Status run() {
    SFUMATO_TRY(list_sides());
    out_.f32(static_cast<float>(step_));
    for (int c = 0; c < field_.channel_count; ++c) {
      write_numbers(step_, [c](const ExactSide& s) { return std::pair(s.from[c], s.to[c]); });
    }
    const ViewerGrid& grid = curves_.grid();
    unit_ = static_cast<double>(static_cast<float>(std::max(grid.step.x, grid.step.y)));
    out_.f32(static_cast<float>(unit_));
    write_numbers(unit_, [](const ExactSide& s) { return std::pair(s.blur_from, s.blur_to); });
    write_floats(sides_, [&](const Side& side) { return side.side->weight; });
    return write_ends();
  }

 private:
  struct Side {
    const ExactSide* side;
    double length;
    bool continues;  ///< the one before
    std::uint32_t from, to;
  };

  /// Writes the kinds of the curves' edges.
  Status list_sides() {
    std::vector<std::uint32_t> index;
    SFUMATO_TRY(memory_.resize(context_, index, field_.edge.size()));
    SFUMATO_TRY(memory_.reserve(context_, sides_, field_.side.size()));
    const std::size_t most = std::max(field_.side.size(), field_.end.size());
    SFUMATO_TRY(memory_.reserve(context_, from_miss_, most));
    SFUMATO_TRY(memory_.reserve(context_, to_miss_, most));
    std::uint32_t sides = 0;
    for (std::size_t h = 0; h < index.size(); ++h)
      if (field_.edge[h] == RayEdge::side) index[h] = sides++;
    bool continues = false;
    for (const CurveEdge& edge : curves_.order()) {
      const std::uint32_t h = curves_.source(edge.half_edge);
      out_.u8(static_cast<std::uint8_t>(field_.edge[h]));
      const bool is_side = field_.edge[h] == RayEdge::side;
      if (is_side) {
        sides_.push_back({&field_.side[index[h]], edge.length, edge.continues && continues,
                          curves_.origin(edge.half_edge), curves_.target(edge.half_edge)});
      }
      continues = is_side;
    }
    return out_.status();
  }

  /// Predicts that a side begins as the side before it ended, with the same change per length as
  /// the sides since the last wrong prediction.
  template <class Numbers>
  void write_numbers(double step, Numbers numbers) {
    from_miss_.clear();
    to_miss_.clear();
    std::int32_t last = 0, base = 0;
    double length = 0;  // from the base
    for (const Side& side : sides_) {
      const auto [a, b] = numbers(*side.side);
      const std::int32_t from = quantized(double{a}, step), to = quantized(double{b}, step);
      double change = 0;
      if (side.continues && length > 0)
        change = std::floor((static_cast<double>(last) - base) * side.length / length + 0.5);
      if (!(std::fabs(change) <= kLargestNumber)) change = 0;
      const std::int32_t miss = to - from - static_cast<std::int32_t>(change);
      from_miss_.push_back(zigzag(from - last));
      to_miss_.push_back(zigzag(miss));
      const bool goes_on = side.continues && from == last && std::abs(miss) <= kSmallMiss;
      if (!goes_on) base = from, length = 0;
      length += side.length;
      last = to;
    }
    out_.planes(from_miss_, kMissBytes);
    out_.planes(to_miss_, kMissBytes);
  }

  template <class Items, class Number>
  void write_floats(const Items& items, Number number) {
    from_miss_.clear();
    for (const auto& item : items)
      from_miss_.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(number(item))));
    out_.planes(from_miss_, 4);
  }

  template <class Number>
  void write_end_numbers(double step, Number number) {
    from_miss_.clear();
    for (const ExactEnd& end : field_.end)
      from_miss_.push_back(zigzag(quantized(double{number(end)}, step)));
    out_.planes(from_miss_, kMissBytes);
  }

  /// By columns.
  Status write_ends() {
    out_.varint(field_.end.size());
    const Vec2 middle = curves_.middle();
    write_floats(field_.end, [&](const ExactEnd& end) { return end.position.x - middle.x; });
    write_floats(field_.end, [&](const ExactEnd& end) { return end.position.y - middle.y; });
    write_floats(field_.end, [](const ExactEnd& end) { return end.direction.x; });
    write_floats(field_.end, [](const ExactEnd& end) { return end.direction.y; });
    for (const auto number : {&ExactEnd::bend, &ExactEnd::reach, &ExactEnd::weight})
      write_floats(field_.end, [number](const ExactEnd& end) { return end.*number; });
    for (const auto number : {&ExactEnd::blur_positive, &ExactEnd::blur_negative})
      write_end_numbers(unit_, [number](const ExactEnd& end) { return end.*number; });
    for (int c = 0; c < field_.channel_count; ++c) {
      write_end_numbers(step_, [c](const ExactEnd& end) { return end.positive[c]; });
      write_end_numbers(step_, [c](const ExactEnd& end) { return end.negative[c]; });
    }
    return out_.status();
  }

  Context& context_;
  const ExactField& field_;
  const CurveWriter& curves_;
  double step_;
  double unit_ = 1;  ///< of radii
  TableMemory memory_{"the viewer's exact fields"};
  std::vector<Side> sides_;
  std::vector<std::uint32_t> from_miss_, to_miss_;
  ByteWriter& out_;
};

/// A layer's triangles, ready to be written.
struct ExactMesh {
  PatchLayer layer;
  ViewerMesh mesh;
  TableMemory memory{"the viewer's exact fields"};
};

Status make_mesh(Context& context, const ExactLayer& exact, ExactMesh& made) {
  SFUMATO_TRY_ASSIGN(made.layer, mesh_of(context, exact, made.memory));
  SFUMATO_TRY_ASSIGN(made.mesh, order_for_viewer(context, made.layer));
  return ok_status();
}

Status write_layer(Context& context, const ExactLayer& exact, const ExactMesh& made,
                   const PatchVertices& vertices, const ViewerGrid& grid, InterpolationSpace space,
                   ByteWriter& out) {
  out.f32(static_cast<float>(exact.tolerance));
  CurveWriter curves(context, made.layer, made.mesh, vertices, grid, out);
  SFUMATO_TRY(curves.run());
  for (const ExactField& field : exact.field) {
    const bool is_color = field.channel_count == 3;
    const double step = exact_step(is_color ? space : InterpolationSpace::srgb);
    SFUMATO_TRY(FieldOnCurves(context, field, curves, step, out).run());
  }
  return ok_status();
}

Status write_with_patches(Context& context, const PatchLayer& patches, InterpolationSpace space,
                          ByteWriter& out) {
  ExactMesh made;
  SFUMATO_TRY(make_mesh(context, patches.exact, made));
  PatchVertices vertices;
  SFUMATO_TRY(vertices.list(context, patches));
  const ViewerGrid grid = grid_of(made.layer, made.mesh);
  return write_layer(context, patches.exact, made, vertices, grid, space, out);
}

/// Around the same middle, 16 times as fine.
ViewerGrid finer(const ViewerGrid& grid) {
  const Vec2 step = grid.step / 16;
  const ViewerGrid fine{{0, 0}, step};
  return {grid.middle() - fine.middle(), step};
}

Status write_alone(Context& context, const ExactLayer& layer, InterpolationSpace space,
                   ByteWriter& out) {
  out.u8(kExactVersion);
  if (layer.field.empty()) {
    out.u8(static_cast<std::uint8_t>(ExactKind::none));
    return out.status();
  }
  out.u8(static_cast<std::uint8_t>(ExactKind::alone));
  ExactMesh made;
  SFUMATO_TRY(make_mesh(context, layer, made));
  const ViewerGrid grid = finer(grid_of(made.layer, made.mesh));
  PatchVertices vertices;
  vertices.list_none(grid);
  return write_layer(context, layer, made, vertices, grid, space, out);
}

}  // namespace

Status write_exact(Context& context, const Picture& picture, ByteWriter& out) {
  const auto has_fields = [](const PatchLayer& layer) { return !layer.exact.field.empty(); };
  if (std::ranges::none_of(picture.layers, has_fields)) return out.status();
  out.u8(kExactVersion);
  for (const PatchLayer& layer : picture.layers) {
    const ExactKind kind = has_fields(layer) ? ExactKind::with_patches : ExactKind::none;
    out.u8(static_cast<std::uint8_t>(kind));
    if (kind == ExactKind::none) continue;
    SFUMATO_TRY(write_with_patches(context, layer, picture.interpolation, out));
  }
  return out.status();
}

Result<std::vector<std::uint8_t>> exact_alone(Context& context, const ExactLayer& layer,
                                              InterpolationSpace space) {
  ByteWriter out(context);
  SFUMATO_TRY(write_alone(context, layer, space, out));
  return out.finish();
}

}  // namespace sfumato::outputs
