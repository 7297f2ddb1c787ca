#include "export/html/viewer_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"

namespace sfumato::outputs {
namespace {

constexpr std::uint32_t kUnseen = std::numeric_limits<std::uint32_t>::max();

/// The most triangles on one edge that are examined to find the next; a triangulation has at most
/// two.
constexpr std::size_t kTrianglesOnEdge = 4;

/// Cells of the grid along an axis.
constexpr double kGridCells = (1 << 22) - 1;
constexpr int kGridMiddle = 1 << 21;

/// Walks over the triangles and numbers them. A gate is a half-edge whose other side was not
/// visited yet.
class Walker {
 public:
  Walker(Context& context, const PatchLayer& layer, ViewerMesh& mesh)
      : context_(context), layer_(layer), mesh_(mesh), codes_(context) {}

  Status run() {
    SFUMATO_TRY(make_tables());
    SFUMATO_TRY(find_edges());
    for (std::uint32_t t = 0; t < layer_.triangle_count(); ++t) {
      if (is_placed_[t]) continue;
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex = layer_.triangle_vertex[3 * t + k];
        write(vertex_code(vertex));
        see(vertex, kNoHalfEdge);
      }
      place(t, 0);
      SFUMATO_TRY(follow_gates());
    }
    SFUMATO_TRY_ASSIGN(const auto& codes, codes_.finish());
    return mesh_.memory.append(context_, codes, mesh_.codes);
  }

 private:
  /// With room for all that they will hold.
  Status make_tables() {
    const std::size_t triangles = layer_.triangle_count(), corners = 3 * triangles;
    const std::size_t vertices = layer_.vertex_position.size();
    SFUMATO_TRY(memory_.resize_all(context_, corners, edge_, half_edge_));
    SFUMATO_TRY(memory_.reserve(context_, gates_, corners));
    SFUMATO_TRY(memory_.resize(context_, is_placed_, triangles));
    SFUMATO_TRY(memory_.resize(context_, vertex_number_, vertices, kUnseen));
    TableMemory& kept = mesh_.memory;
    SFUMATO_TRY(kept.reserve(context_, mesh_.triangle, triangles));
    SFUMATO_TRY(kept.reserve(context_, mesh_.first_corner, triangles));
    SFUMATO_TRY(kept.reserve(context_, mesh_.corner_vertex, corners));
    SFUMATO_TRY(kept.reserve(context_, mesh_.mate, corners));
    SFUMATO_TRY(kept.reserve(context_, mesh_.vertex, vertices));
    return kept.reserve(context_, mesh_.apex, vertices);
  }

  /// Half-edges on one edge get one number, and are found by it.
  Status find_edges() {
    struct Key {
      std::uint32_t low, high, half_edge;
      bool operator<(const Key& other) const {
        return std::pair(low, high) != std::pair(other.low, other.high)
                   ? std::pair(low, high) < std::pair(other.low, other.high)
                   : half_edge < other.half_edge;
      }
    };
    TableMemory memory("the viewer's triangles");
    std::vector<Key> keys;
    SFUMATO_TRY(memory.resize(context_, keys, edge_.size()));
    for (std::uint32_t h = 0; h < keys.size(); ++h) {
      const std::uint32_t a = start(h), b = end(h);
      keys[h] = {std::min(a, b), std::max(a, b), h};
    }
    SFUMATO_TRY(
        TableMemory::sort(context_, keys, [](const Key& a, const Key& b) { return a < b; }));
    RarePoll<65536> poll(context_);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      if (poll.cancelled()) return context_.cancel_status();
      const bool is_new =
          i == 0 || keys[i].low != keys[i - 1].low || keys[i].high != keys[i - 1].high;
      if (is_new) SFUMATO_TRY(memory_.push_back(context_, first_half_edge_, i));
      half_edge_[i] = keys[i].half_edge;
      edge_[keys[i].half_edge] = static_cast<std::uint32_t>(first_half_edge_.size() - 1);
    }
    Status status = memory_.resize(context_, last_on_edge_, first_half_edge_.size(), kNoHalfEdge);
    return status ? memory_.push_back(context_, first_half_edge_, keys.size()) : status;
  }

  /// Indices of the layer's half-edges.
  std::uint32_t start(std::uint32_t h) const { return layer_.triangle_vertex[h]; }
  std::uint32_t end(std::uint32_t h) const { return layer_.triangle_vertex[next_half_edge(h)]; }

  /// 0 for a vertex that was not seen, else how many numbers ago it was.
  std::uint32_t vertex_code(std::uint32_t vertex) const {
    const std::uint32_t number = vertex_number_[vertex];
    return number == kUnseen ? 0 : static_cast<std::uint32_t>(mesh_.vertex.size()) - number;
  }

  void see(std::uint32_t vertex, std::uint32_t across) {
    if (vertex_number_[vertex] != kUnseen) return;
    vertex_number_[vertex] = static_cast<std::uint32_t>(mesh_.vertex.size());
    mesh_.vertex.push_back(vertex);
    mesh_.apex.push_back(across);
  }

  void write(std::uint32_t code) { codes_.varint(code); }

  /// Half-edge k of the triangle that is placed comes from the layer's.
  void place(std::uint32_t t, std::uint32_t first_corner) {
    const std::uint32_t base = 3 * mesh_.triangle_count();
    mesh_.triangle.push_back(t);
    mesh_.first_corner.push_back(static_cast<std::uint8_t>(first_corner));
    is_placed_[t] = 1;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t h = 3 * t + (first_corner + k) % 3;
      mesh_.corner_vertex.push_back(vertex_number_[start(h)]);
      mesh_.mate.push_back(std::exchange(last_on_edge_[edge_[h]], base + k));
    }
    for (std::uint32_t k = 3; k-- > 0;) {
      if (mesh_.mate[base + k] != kNoHalfEdge) continue;
      gates_.push_back({base + k, edge_[3 * t + (first_corner + k) % 3]});
    }
  }

  Status follow_gates() {
    while (!gates_.empty()) {
      if (poll_.cancelled()) return context_.cancel_status();
      const Gate gate = gates_.back();
      gates_.pop_back();
      if (last_on_edge_[gate.edge] != gate.half_edge) continue;
      const std::uint32_t next = across(gate);
      if (next == kNoHalfEdge) {
        write(0);
        continue;
      }
      const std::uint32_t apex = start(previous_half_edge(next));
      write(vertex_code(apex) + 1);
      see(apex, gate.half_edge);
      place(next / 3, next % 3);
    }
    return ok_status();
  }

  struct Gate {
    std::uint32_t half_edge;  ///< of the new order
    std::uint32_t edge;
  };

  /// Returns the layer's half-edge on the other side, of a triangle that has no place yet.
  std::uint32_t across(const Gate& gate) const {
    const std::uint32_t from = mesh_.vertex[mesh_.corner_vertex[next_half_edge(gate.half_edge)]];
    const std::size_t first = first_half_edge_[gate.edge];
    const std::size_t last = std::min(first_half_edge_[gate.edge + 1], first + kTrianglesOnEdge);
    for (std::size_t i = first; i < last; ++i) {
      const std::uint32_t h = half_edge_[i];
      if (!is_placed_[h / 3] && start(h) == from) return h;
    }
    return kNoHalfEdge;
  }

  Context& context_;
  RarePoll<4096> poll_{context_};  ///< of all parts of the mesh together
  const PatchLayer& layer_;
  ViewerMesh& mesh_;
  TableMemory memory_{"the viewer's triangles"};
  std::vector<std::uint32_t> edge_;           ///< of the layer's half-edges
  std::vector<std::uint32_t> half_edge_;      ///< of the layer, by edge
  std::vector<std::size_t> first_half_edge_;  ///< edges + 1 offsets into half_edge_
  std::vector<std::uint32_t> last_on_edge_;   ///< half-edge of the new order
  std::vector<std::uint8_t> is_placed_;       ///< 1: has its place in the new order
  std::vector<std::uint32_t> vertex_number_;
  std::vector<Gate> gates_;
  ByteWriter codes_;
};

/// Where a vertex is expected: opposite to the triangle that it was seen from.
GridPoint predicted(const ViewerMesh& mesh, const std::vector<GridPoint>& known,
                    std::uint32_t vertex) {
  const std::uint32_t across = mesh.apex[vertex];
  if (across == kNoHalfEdge) return vertex > 0 ? known[vertex - 1] : GridPoint{};
  const std::uint32_t base = across - across % 3, k = across % 3;
  const auto corner = [&](std::uint32_t i) { return known[mesh.corner_vertex[base + i % 3]]; };
  const GridPoint a = corner(k), b = corner(k + 1), c = corner(k + 2);
  return {a.x + b.x - c.x, a.y + b.y - c.y};
}

Status write_positions(const Context& context, const PatchLayer& layer, const ViewerMesh& mesh,
                       ByteWriter& out) {
  const ViewerGrid cells = grid_of(layer, mesh);
  write_grid(cells, out);
  TableMemory memory("the viewer's positions");
  std::vector<GridPoint> grid;
  std::vector<std::uint32_t> miss_x, miss_y;
  SFUMATO_TRY(memory.resize_all(context, mesh.vertex.size(), grid, miss_x, miss_y));
  for (std::uint32_t i = 0; i < grid.size(); ++i) {
    grid[i] = cells.nearest(layer.vertex_position[mesh.vertex[i]]);
    const GridPoint guess = predicted(mesh, grid, i);
    miss_x[i] = zigzag(grid[i].x - guess.x);
    miss_y[i] = zigzag(grid[i].y - guess.y);
  }
  constexpr int kBytes = 4;
  out.planes(miss_x, kBytes);
  out.planes(miss_y, kBytes);
  return out.status();
}

}  // namespace

Result<ViewerMesh> order_for_viewer(Context& context, const PatchLayer& layer) {
  ViewerMesh mesh;
  SFUMATO_TRY(Walker(context, layer, mesh).run());
  return mesh;
}

GridPoint ViewerGrid::nearest(Vec2 position) const {
  const Vec2 p = position - min;
  return {static_cast<std::int32_t>(std::lround(p.x / step.x)),
          static_cast<std::int32_t>(std::lround(p.y / step.y))};
}

ViewerGrid::Place ViewerGrid::place(GridPoint point) const {
  return {static_cast<float>((point.x - kGridMiddle) * step.x),
          static_cast<float>((point.y - kGridMiddle) * step.y)};
}

ViewerGrid::Place ViewerGrid::place(GridPoint point, Vec2 origin) const {
  const Vec2 shift = middle() - origin;
  return {static_cast<float>((point.x - kGridMiddle) * step.x + shift.x),
          static_cast<float>((point.y - kGridMiddle) * step.y + shift.y)};
}

Vec2 ViewerGrid::middle() const {
  return {min.x + kGridMiddle * step.x, min.y + kGridMiddle * step.y};
}

ViewerGrid grid_of(const PatchLayer& layer, const ViewerMesh& mesh) {
  Box bounds;
  for (std::uint32_t v : mesh.vertex) bounds.extend(layer.vertex_position[v]);
  if (mesh.vertex.empty()) bounds = {{0, 0}, {0, 0}};
  const auto step_of = [](double extent) { return extent > 0 ? extent / kGridCells : 1; };
  return {bounds.min, {step_of(bounds.width()), step_of(bounds.height())}};
}

void write_grid(const ViewerGrid& grid, ByteWriter& out) {
  for (double value : {grid.min.x, grid.min.y, grid.step.x, grid.step.y}) out.f64(value);
}

void write_curves(const PatchLayer& layer, const ViewerMesh& mesh, ByteWriter& out) {
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    std::uint8_t curves = 0;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t corner = (mesh.first_corner[t] + k) % 3;
      const bool is_curve = layer.edge_is_curve[3 * mesh.triangle[t] + corner] != 0;
      curves = static_cast<std::uint8_t>(curves | (is_curve ? 1 << k : 0));
    }
    out.u8(curves);
  }
}

Status write_mesh(const Context& context, const PatchLayer& layer, const ViewerMesh& mesh,
                  ByteWriter& out) {
  out.varint(mesh.triangle_count());
  out.varint(mesh.vertex.size());
  out.counted(mesh.codes);
  SFUMATO_TRY(write_positions(context, layer, mesh, out));
  write_curves(layer, mesh, out);
  return out.status();
}

}  // namespace sfumato::outputs
