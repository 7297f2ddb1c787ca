#pragma once

#include "gather/closed_form.hpp"
#include "gather/scene_layout.hpp"

/// The exact gather of one packet (DESIGN 2.2; triangular expansion): windows of directions are
/// walked outward through the visibility mesh, narrowed at every edge that rays pass, integrated at
/// every edge that stops them. One text for all widths; F = Lanes<W, 16 / W>.
///
/// Every lane's arithmetic depends on that lane and on decisions over the whole packet alone; hence
/// the same bits for every W.
namespace sfumato::gather::inline SFUMATO_ISA {

template <class F>
struct Direction {
  F x, y;
};

/// In single precision, without subtraction: a × b > 0.
template <class F>
SFUMATO_INLINE typename F::Mask turns_left(const Direction<F>& a, const Direction<F>& b) {
  return a.x * b.y > a.y * b.x;
}

template <class F>
SFUMATO_INLINE Direction<F> select(const typename F::Mask& mask, const Direction<F>& a,
                                   const Direction<F>& b) {
  return {select(mask, a.x, b.x), select(mask, a.y, b.y)};
}

/// The directions in which each lane sees an edge: from `right` counter-clockwise (cross > 0) to
/// `left`. Both point to mesh vertices, relative to the lane's point.
template <class F>
struct Window {
  Direction<F> right;
  Direction<F> left;
  typename F::Mask lanes;
};

/// What a window becomes at a triangle's apex.
template <class F>
struct Split {
  Direction<F> apex;
  typename F::Mask right;  ///< lanes whose window reaches right of the apex
  typename F::Mask left;

  SFUMATO_INLINE Split(const Window<F>& w, const Direction<F>& apex_direction)
      : apex(apex_direction),
        right(w.lanes & turns_left(w.right, apex)),
        left(w.lanes & turns_left(apex, w.left)) {}

  SFUMATO_INLINE Window<F> right_of(const Window<F>& w) const {
    return {w.right, select(left, apex, w.left), right};
  }
  SFUMATO_INLINE Window<F> left_of(const Window<F>& w) const {
    return {select(right, apex, w.right), w.left, left};
  }
};

/// W and Σ w z of W points; the visible part of one edge at a time.
template <int W>
class Integrator {
 public:
  using F = Lanes<W>;

  SFUMATO_INLINE void add(const StopEdge& edge, const F& px, const F& py, const Window<F>& w) {
    const Direction<F> a{F(edge.ax) - px, F(edge.ay) - py};
    const Direction<F> b{F(edge.bx) - px, F(edge.by) - py};
    const F ex(edge.ex), ey(edge.ey);
    const F area = a.x * ey - a.y * ex;
    const auto whole_right = (w.right.x == a.x) & (w.right.y == a.y);
    const auto whole_left = (w.left.x == b.x) & (w.left.y == b.y);
    if (!any(and_not(w.lanes, whole_right & whole_left))) {
      const EndWeights<F> part = end_weights(a.x, a.y, b.x, b.y, area, w.lanes);
      sum(edge, zero_unless(w.lanes, part.right + part.left), zero_unless(w.lanes, part.left));
      return;
    }
    // Where the window's rays cut the edge, as a fraction from a to b: a + t e parallel to the ray.
    // A ray that points to the end itself is not cut: t is exactly 0 or 1.
    const F cut_right =
        (a.y * w.right.x - a.x * w.right.y) * reciprocal(ex * w.right.y - ey * w.right.x);
    const F cut_left =
        (a.y * w.left.x - a.x * w.left.y) * reciprocal(ex * w.left.y - ey * w.left.x);
    const F t1 = zero_unless(and_not(w.lanes, whole_right), min(max(cut_right, F(0)), F(1)));
    const F t2 = select(whole_left, F(1), min(max(cut_left, F(0)), F(1)));
    const F q2x = select(whole_left, b.x, a.x + t2 * ex);
    const F q2y = select(whole_left, b.y, a.y + t2 * ey);
    const EndWeights<F> part =
        end_weights(a.x + t1 * ex, a.y + t1 * ey, q2x, q2y, area * (t2 - t1), w.lanes);
    sum(edge, zero_unless(w.lanes, part.right + part.left),
        zero_unless(w.lanes, part.right * t1 + part.left * t2));
  }

  SFUMATO_INLINE void store(PacketSums& out, int lane) const {
    weight_.store(out.weight + lane);
    for (int c = 0; c < 3; ++c) color_[c].store(out.color[c] + lane);
  }

 private:
  // The colour of the edge is color + t change: weight and moment suffice.
  SFUMATO_INLINE void sum(const StopEdge& edge, const F& weight, const F& moment) {
    weight_ = weight_ + weight * F(edge.weight);
    for (int c = 0; c < 3; ++c) {
      color_[c] = color_[c] + (weight * F(edge.color[c]) + moment * F(edge.change[c]));
    }
  }

  F weight_ = F(0);
  F color_[3] = {F(0), F(0), F(0)};
};

template <int W>
class PacketWalk {
 public:
  static constexpr int K = kPacketLanes / W;
  using F = Lanes<W, K>;
  using Mask = typename F::Mask;

  SFUMATO_INLINE PacketWalk(const SceneView& scene, const PacketInput& packet,
                            const PacketStack& stack)
      : scene_(scene), packet_(packet), px_(F::load(packet.x)), py_(F::load(packet.y)) {
    stack_ = reinterpret_cast<Waiting*>(stack.slot);
    capacity_ = stack.capacity;
    steps_left_ = scene.step_limit;
  }

  /// False where the stack is too small; nothing is stored then.
  SFUMATO_INLINE bool run(PacketSums& out) {
    if (packet_.triangle_count == 1) {
      start_in_one_triangle();
    } else {
      start_in_tree();
    }
    while (size_ > 0) {
      const Waiting& top = stack_[--size_];
      const Window<F> window = top.window;
      if (!walk(window, top.edge)) return false;
    }
    SFUMATO_EACH(i) integrator_[i].store(out, i * W);
    return true;
  }

 private:
  struct Waiting {
    Window<F> window;
    EdgeCode edge;
  };
  static_assert(sizeof(Waiting) <= sizeof(StackSlot));

  SFUMATO_INLINE Direction<F> direction_to(float x, float y) const {
    return {F(x) - px_, F(y) - py_};
  }
  SFUMATO_INLINE Direction<F> corner(const SceneTriangle& t, int k) const {
    return direction_to(t.x[k], t.y[k]);
  }

  // Register by register, so that a narrow machine skips registers without lanes.
  SFUMATO_INLINE void integrate(const StopEdge& edge, const Window<F>& w) {
    SFUMATO_EACH(i) {
      const Window<Lanes<W>> part{
          {w.right.x.row(i), w.right.y.row(i)}, {w.left.x.row(i), w.left.y.row(i)}, w.lanes.row(i)};
      if (K > 1 && !any(part.lanes)) continue;
      integrator_[i].add(edge, px_.row(i), py_.row(i), part);
    }
  }

  SFUMATO_INLINE void push(const Window<F>& window, EdgeCode edge) {
    stack_[size_].window = window;
    stack_[size_].edge = edge;
    ++size_;
  }

  /// Follows one window until nothing of it is left; what parts from it waits on the stack.
  SFUMATO_INLINE bool walk(Window<F> window, EdgeCode edge) {
    for (;;) {
      if (--steps_left_ < 0) return true;
      const EdgeBeyond& beyond = scene_.edge_beyond[edge];
      const Split<F> split(window, direction_to(beyond.apex_x, beyond.apex_y));
      bool goes_right = any(split.right);
      bool goes_left = any(split.left);
      if (beyond.right < 0 && goes_right) {
        if (is_stop(beyond.right)) {
          integrate(scene_.stop[stop_index(beyond.right)], split.right_of(window));
        }
        goes_right = false;
      }
      if (beyond.left < 0 && goes_left) {
        if (is_stop(beyond.left)) {
          integrate(scene_.stop[stop_index(beyond.left)], split.left_of(window));
        }
        goes_left = false;
      }
      if (goes_right && goes_left) {
        if (size_ == capacity_) return false;
        push(split.left_of(window), beyond.left);
      }
      if (goes_right) {
        window = split.right_of(window);
        edge = beyond.right;
      } else if (goes_left) {
        window = split.left_of(window);
        edge = beyond.left;
      } else {
        return true;
      }
    }
  }

  /// A window that leaves the packet's triangles.
  SFUMATO_INLINE void start(const Window<F>& window, EdgeCode edge) {
    if (edge == kBorder || !any(window.lanes)) return;
    if (is_stop(edge)) {
      integrate(scene_.stop[stop_index(edge)], window);
    } else {
      push(window, edge);
    }
  }

  SFUMATO_INLINE Mask own_lanes(const PacketTriangle& t) const {
    return Mask::from_bits((1u << t.lane_end) - (1u << t.lane_begin));
  }

  // The signs of a point's own windows are not asked: it may lie on an edge of its triangle, which
  // it sees under 180 degrees.
  SFUMATO_INLINE void start_in_one_triangle() {
    const SceneTriangle& t = scene_.triangle[packet_.triangle[0].triangle];
    const Mask lanes = own_lanes(packet_.triangle[0]);
    for (int k = 0; k < 3; ++k) {
      start({corner(t, k), corner(t, (k + 1) % 3), lanes}, t.edge[k]);
    }
  }

  /// The windows of all lanes that leave triangle i through edge k: its own points', and those that
  /// came in through the two other edges. Lanes differ, so they are one window.
  Window<F> leaving(int i, int k, const Window<F> (&entering)[kPacketTriangles][3]) const {
    const SceneTriangle& t = scene_.triangle[packet_.triangle[i].triangle];
    Window<F> out{corner(t, k), corner(t, (k + 1) % 3), own_lanes(packet_.triangle[i])};
    // Seen through edge f, the apex is corner f + 2, the right edge is f + 1, the left f + 2.
    const Window<F>& from_right = entering[i][(k + 2) % 3];
    if (any(from_right.lanes)) {
      merge(out, Split<F>(from_right, corner(t, (k + 1) % 3)).right_of(from_right));
    }
    const Window<F>& from_left = entering[i][(k + 1) % 3];
    if (any(from_left.lanes)) {
      merge(out, Split<F>(from_left, corner(t, k)).left_of(from_left));
    }
    return out;
  }

  SFUMATO_INLINE static void merge(Window<F>& out, const Window<F>& in) {
    out.right = select(in.lanes, in.right, out.right);
    out.left = select(in.lanes, in.left, out.left);
    out.lanes = out.lanes | in.lanes;
  }

  /// Windows pass through the edges of the tree, first towards the root, then away from it; what
  /// leaves by other edges starts the walk.
  void start_in_tree() {
    Window<F> entering[kPacketTriangles][3];
    unsigned tree_edges[kPacketTriangles] = {};
    for (auto& windows : entering) {
      for (Window<F>& window : windows) window.lanes = Mask::from_bits(0);
    }
    for (int i = packet_.triangle_count - 1; i > 0; --i) {
      const PacketTriangle& t = packet_.triangle[i];
      tree_edges[i] |= 1u << t.own_edge;
      tree_edges[t.parent] |= 1u << t.parent_edge;
      entering[t.parent][t.parent_edge] = leaving(i, t.own_edge, entering);
    }
    for (int i = 0; i < packet_.triangle_count; ++i) {
      const PacketTriangle& t = packet_.triangle[i];
      if (i > 0) entering[i][t.own_edge] = leaving(t.parent, t.parent_edge, entering);
      for (int k = 0; k < 3; ++k) {
        if (tree_edges[i] >> k & 1) continue;
        start(leaving(i, k, entering), scene_.triangle[t.triangle].edge[k]);
      }
    }
  }

  const SceneView& scene_;
  const PacketInput& packet_;
  F px_, py_;
  Integrator<W> integrator_[K];
  Waiting* stack_;
  int capacity_;
  int size_ = 0;
  std::int64_t steps_left_;
};

/// One packet with W lanes to a register. False: the stack is too small, nothing was stored.
template <int W>
bool gather_packet(const SceneView& scene, const PacketInput& packet, const PacketStack& stack,
                   PacketSums& out) {
  PacketWalk<W> walk(scene, packet, stack);
  return walk.run(out);
}

}  // namespace sfumato::gather::inline SFUMATO_ISA
