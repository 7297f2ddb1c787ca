#pragma once

#include <cmath>
#include <limits>

#include "gather/kernels/far_field.hpp"
#include "gather/kernels/scene_layout.hpp"
#include "gather/kernels/window.hpp"

/// The exact gather of a packet (triangular expansion): windows of directions are walked outward
/// through the visibility mesh, narrowed at every edge that rays pass, and integrated at every edge
/// that stops them. One source for all widths; F = Lanes<W, 16 / W>.
///
/// Every lane's arithmetic depends only on that lane and on decisions over the whole packet, hence
/// the same bits for every W.
namespace sfumato::gather::inline SFUMATO_ISA {

/// Windows that reach this many triangles deep wait until all nearer windows are integrated. The
/// weight is then nearly known, and more of the far windows turn out to be negligible: 10,000
/// specks are drawn in 0.4 of the time.
inline constexpr int kNearDepth = 12;

/// Sums   an EdgeViews, with begin() and end(); where kTakesMeans is set, a far field may represent
///        windows that are not followed
template <class Sums>
class PacketWalk {
 public:
  static constexpr int K = Sums::K;
  using F = Lanes<Sums::kLanes, K>;

  PacketWalk(const SceneView& scene, const PacketStack& stack)
      : scene_(scene), stack_(reinterpret_cast<Waiting*>(stack.slot)), capacity_(stack.capacity) {}

  /// Runs the walk. Returns false where the stack is too small; nothing is stored then.
  bool run(const PacketInput& packet, typename Sums::Result& out) {
    px_ = F::load(packet.x);
    py_ = F::load(packet.y);
    sums_.begin(scene_, packet, out);
    steps_left_ = scene_.step_limit;
    size_ = far_size_ = 0;
    if (packet.triangle_count == 1) {
      start_in_one_triangle(packet);
    } else {
      start_in_tree(packet);
    }
    if (!follow_all(kNearDepth)) return false;
    if (far_size_ > 0) {
      sums_.flush();
      take_far();
      if (!follow_all(std::numeric_limits<int>::max())) return false;
    }
    sums_.end(out);
    return true;
  }

 private:
  struct Waiting {
    Window<F> window;
    EdgeCode edge;
    int depth;  ///< triangles that it has passed
  };
  static_assert(sizeof(Waiting) <= sizeof(StackSlot));

  bool is_full() const { return size_ + far_size_ == capacity_; }

  /// Pushes a window. Precondition: not is_full().
  SFUMATO_INLINE void push(const Window<F>& window, EdgeCode edge, int depth) {
    put(stack_[size_++], window, edge, depth);
  }

  SFUMATO_INLINE static void put(Waiting& to, const Window<F>& window, EdgeCode edge, int depth) {
    to.window = window;
    to.edge = edge;
    to.depth = depth;
  }

  /// Moves the far windows to the stack, which is empty.
  void take_far() {
    for (; far_size_ > 0; --far_size_) stack_[size_++] = stack_[capacity_ - far_size_];
  }

  /// Follows the windows on the stack up to a depth; windows that continue from there are far.
  /// Returns false where the stack is too small.
  bool follow_all(int depth) {
    depth_limit_ = depth;
    while (size_ > 0) {
      const Waiting& top = stack_[--size_];
      const Window<F> window = top.window;
      if (!walk(window, top.edge, top.depth)) return false;
    }
    return true;
  }

  /// Follows one window until nothing of it is left, or it is far; windows that split off it are
  /// pushed on the stack.
  SFUMATO_INLINE bool walk(Window<F> window, EdgeCode edge, int depth) {
    for (;;) {
      if (--steps_left_ < 0) return true;
      if (depth++ == depth_limit_) {
        if (is_full()) return false;
        put(stack_[capacity_ - ++far_size_], window, edge, depth);
        return true;
      }
      const EdgeBeyond& beyond = scene_.edge_beyond[edge];
      // At every second step, because the test costs as much as the step.
      if (steps_left_ % 2 != 0) {
        const LaneBits small = negligible(window, beyond);
        if constexpr (Sums::kTakesMeans) {
          if (scene_.far.mean && (window.lanes & small)) {
            dropped_ = window;
            estimate(beyond, window.lanes & small);
            if ((window.lanes & ~small) == 0) return true;
          }
        }
        window.lanes &= ~small;
      }
      const Split<F> split(window, {F(beyond.apex_x) - px_, F(beyond.apex_y) - py_});
      bool goes_right = split.right != 0;
      bool goes_left = split.left != 0;
      if (beyond.right < 0 && goes_right) {
        if (is_hit(beyond.right)) sums_.add(scene_, beyond.right, split.right_of(window));
        goes_right = false;
      }
      if (beyond.left < 0 && goes_left) {
        if (is_hit(beyond.left)) sums_.add(scene_, beyond.left, split.left_of(window));
        goes_left = false;
      }
      if (goes_right && goes_left) {
        if (is_full()) return false;
        push(split.left_of(window), beyond.left, depth);
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

  SFUMATO_INLINE F distance_of(const EdgeBeyond& edge) const {
    return F(edge.normal_x) * px_ + (F(edge.normal_y) * py_ + F(edge.offset));
  }

  // Returns the lanes whose window is negligible. Behind an edge at distance d no curve is nearer
  // than d, so that a window of angle D weighs at most D/d² (weights k are at most 1). tan D is
  // used as an upper bound of D below 90°; above, cos D is negative and nothing is dropped.
  SFUMATO_INLINE LaneBits negligible(const Window<F>& w, const EdgeBeyond& beyond) const {
    const F d = distance_of(beyond);
    const F sine = w.right.x * w.left.y - w.right.y * w.left.x;
    const F cosine = w.right.x * w.left.x + w.right.y * w.left.y;
    F least = sums_.negligible_weight();
    if constexpr (Sums::kTakesMeans) {
      if (scene_.far.mean) {
        least = select(d > F(scene_.far.nearest), least * F(sums_.estimated_times()), least);
      }
    }
    return mask_bits(abs(sine) < least * (d * d) * cosine);
  }

  /// Adds an estimate of the contribution of a window that is not followed, for all lanes by one
  /// access to the far field. Where rays meet curves with density λ, one that begins at distance t
  /// weighs ∫ λ e^{-λ(r - t)} / r² dr on average, which is λ / (t (1 + 1.25 λt)) within a sixth,
  /// and half of it comes from within 2 t. Both are below 1 / t²: the error of an estimate is no
  /// larger than that of dropping the window.
  __attribute__((noinline)) void estimate(const EdgeBeyond& beyond, LaneBits lanes) {
    const F distance = distance_of(beyond);
    lanes &= mask_bits(distance > F(scene_.far.nearest));
    if (lanes == 0) return;
    const int lane = __builtin_ctz(lanes);
    const Direction<float> ray = middle_of_dropped(lane);
    const float length = std::sqrt(ray.x * ray.x + ray.y * ray.y);
    const float ahead = std::fabs(beyond.normal_x * ray.x + beyond.normal_y * ray.y);
    const float least = kLeastAhead * length;
    const float per_distance = 1 / (ahead > least ? ahead : least);
    const float steps = distance[lane] * per_distance;
    const float* mean = far_mean(scene_.far, px_[lane] + kFarPlace * steps * ray.x,
                                 py_[lane] + kFarPlace * steps * ray.y, far_direction(ray.x, ray.y),
                                 steps * length);
    if (!mean) return;
    const F weight =
        weight_of_dropped(distance * F(length * per_distance), kFarBend * mean[kFarOpacity]);
    sums_.add_mean(mean, zero_unless(F::Mask::from_bits(lanes), weight));
  }

  static constexpr float kFarPlace = 1.7f;  ///< the place in the far field, in units of t
  static constexpr float kFarBend = 1.25f;
  static constexpr float kLeastAhead = 1e-4f;  ///< keeps t finite

  /// Returns the direction of the middle of a lane's window; its length is meaningless.
  Direction<float> middle_of_dropped(int lane) const {
    const Direction<float> right{dropped_.right.x[lane], dropped_.right.y[lane]};
    const Direction<float> left{dropped_.left.x[lane], dropped_.left.y[lane]};
    const float right_length = std::sqrt(right.x * right.x + right.y * right.y);
    const float left_length = std::sqrt(left.x * left.x + left.y * left.y);
    return {right.x * left_length + left.x * right_length,
            right.y * left_length + left.y * right_length};
  }

  /// Returns D / (t (1 + bend t)), with 2 tan(D / 2) for D.
  SFUMATO_INLINE F weight_of_dropped(const F& t, float bend) const {
    const Direction<F>& right = dropped_.right;
    const Direction<F>& left = dropped_.left;
    const F sine = max(right.x * left.y - right.y * left.x, F(0));
    const F cosine = right.x * left.x + right.y * left.y;
    const F squares = (right.x * right.x + right.y * right.y) * (left.x * left.x + left.y * left.y);
    const F lengths = squares * reciprocal_sqrt(squares);
    return (sine + sine) * reciprocal((lengths + cosine) * (t * (F(1) + F(bend) * t)));
  }

  /// Starts the walk with a window that leaves the packet's triangles.
  void start(const Window<F>& window, EdgeCode edge) {
    if (edge == kBorder || window.lanes == 0) return;
    if (is_hit(edge)) {
      sums_.add(scene_, edge, window);
    } else {
      push(window, edge, 0);
    }
  }

  SFUMATO_INLINE Direction<F> corner(const SceneTriangle& t, int k) const {
    return {F(t.x[k]) - px_, F(t.y[k]) - py_};
  }

  /// Returns the windows of a triangle's own points through its edge k. Their signs are not tested,
  /// because a point may lie on the edge, which it then sees under 180 degrees.
  SFUMATO_INLINE Window<F> own_window(const PacketTriangle& member, const SceneTriangle& t,
                                      int k) const {
    const LaneBits lanes = (1u << member.lane_end) - (1u << member.lane_begin);
    return {corner(t, k), corner(t, (k + 1) % 3), lanes, lanes, lanes};
  }

  void start_in_one_triangle(const PacketInput& packet) {
    const SceneTriangle& t = scene_.triangle[packet.triangle[0].triangle];
    for (int k = 0; k < 3; ++k) start(own_window(packet.triangle[0], t, k), t.edge[k]);
  }

  /// Returns the windows of all lanes that leave `member` through its edge k: the windows of its
  /// own points, and the windows that entered through the two other edges. These have different
  /// lanes and therefore form one window.
  Window<F> leaving(const PacketTriangle& member, const Window<F> (&entering)[3], int k) const {
    const SceneTriangle& t = scene_.triangle[member.triangle];
    const int next = (k + 1) % 3, previous = (k + 2) % 3;
    Window<F> out = own_window(member, t, k);
    // Seen through edge f, the apex is corner f + 2, the right edge is f + 1, the left f + 2.
    if (entering[previous].lanes) {
      const Split<F> split(entering[previous], corner(t, next));
      merge(out, split.right_of(entering[previous]));
    }
    if (entering[next].lanes) {
      const Split<F> split(entering[next], corner(t, k));
      merge(out, split.left_of(entering[next]));
    }
    return out;
  }

  SFUMATO_INLINE static void merge(Window<F>& out, const Window<F>& in) {
    const auto lanes = F::Mask::from_bits(in.lanes);
    out.right = select(lanes, in.right, out.right);
    out.left = select(lanes, in.left, out.left);
    out.lanes = out.lanes | in.lanes;
    out.whole_right = out.whole_right | (in.whole_right & in.lanes);
    out.whole_left = out.whole_left | (in.whole_left & in.lanes);
  }

  /// Windows pass through the edges of the tree, first towards the root, then away from it. Windows
  /// that leave by other edges start the walk.
  void start_in_tree(const PacketInput& packet) {
    const PacketTriangle* member = packet.triangle;
    Window<F> entering[kPacketTriangles][3];
    unsigned tree_edges[kPacketTriangles] = {};
    for (int i = 0; i < packet.triangle_count; ++i) {
      for (Window<F>& window : entering[i]) window.lanes = 0;
    }
    for (int i = packet.triangle_count - 1; i > 0; --i) {
      const int parent = member[i].parent;
      tree_edges[i] |= 1u << member[i].own_edge;
      tree_edges[parent] |= 1u << member[i].parent_edge;
      entering[parent][member[i].parent_edge] = leaving(member[i], entering[i], member[i].own_edge);
    }
    for (int i = 0; i < packet.triangle_count; ++i) {
      if (i > 0) {
        const int parent = member[i].parent;
        entering[i][member[i].own_edge] =
            leaving(member[parent], entering[parent], member[i].parent_edge);
      }
      const SceneTriangle& t = scene_.triangle[member[i].triangle];
      for (int k = 0; k < 3; ++k) {
        if (!(tree_edges[i] >> k & 1)) start(leaving(member[i], entering[i], k), t.edge[k]);
      }
    }
  }

  const SceneView& scene_;
  Waiting* stack_;  ///< the far windows fill it from its end towards the others
  int capacity_;
  int size_ = 0;
  int far_size_ = 0;
  int depth_limit_ = 0;
  std::int64_t steps_left_ = 0;
  F px_, py_;
  Window<F> dropped_;  ///< the argument of estimate(): a reference to the walked window would keep
                       ///< it in memory, at twice the time
  Sums sums_;
};

}  // namespace sfumato::gather::inline SFUMATO_ISA
