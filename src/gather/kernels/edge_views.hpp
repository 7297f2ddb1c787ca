#pragma once

#include "gather/kernels/closed_form.hpp"
#include "gather/kernels/scene_layout.hpp"
#include "gather/kernels/window.hpp"

namespace sfumato::gather::inline SFUMATO_ISA {

/// An edge seen by the lanes of one register.
template <int W>
struct EdgeView {
  const HitEdge* edge;
  int row;         ///< the register of the packet
  LaneBits lanes;  ///< W bits
};

/// An edge that some of the lanes see partly.
template <int W>
struct CutEdgeView : EdgeView<W> {
  LaneBits whole_right;
  LaneBits whole_left;
  Direction<Lanes<W>> right;
  Direction<Lanes<W>> left;
};

/// The visible edges of one packet. They are collected and then integrated several at a time,
/// because the closed form is one long chain of dependent steps and several chains side by side use
/// the processor fully. There is one list for edges that every lane sees whole and one for edges
/// that are cut for some lanes. Only the packet, not W, determines when the lists are emptied, and
/// therefore the order of every lane's sum.
///
/// Sums   derives from this; its sum_all(views, seen, part) gets kTogether visible parts at a time,
///        and negligible_share() is the share of the weight found so far below which a window is
///        not followed.
template <int W, class Sums>
class EdgeViews {
 public:
  static constexpr int kLanes = W;
  static constexpr int K = kPacketLanes / W;

  /// Adds an edge. Precondition: is_hit(code), and the window has lanes.
  SFUMATO_INLINE void add(const SceneView& scene, EdgeCode code,
                          const Window<Lanes<W, K>>& window) {
    const HitEdge* edge = &scene.hit_edge[hit_index(code)];
    if (window.lanes & ~(window.whole_right & window.whole_left)) {
      append_cut(edge, window);
      if (--cut_.room == 0) flush(cut_, kCutEdges);
    } else {
      append_whole(edge, window.lanes);
      if (--whole_.room == 0) flush(whole_, kWholeEdges);
    }
  }

  /// Returns the weight below which a window is not followed.
  SFUMATO_INLINE const Lanes<W, K>& negligible_weight() const { return negligible_; }

  /// Integrates the views that were added so far.
  void flush() {
    flush(whole_, kWholeEdges);
    flush(cut_, kCutEdges);
  }

 protected:
  static constexpr int kTogether = 4;
  static constexpr int kFirstEdges = 12;  ///< few, because the walk needs the weight so far
  static constexpr int kWholeEdges = 96;
  static constexpr int kCutEdges = 24;
  using F = Lanes<W, kTogether>;

  void begin_views(const PacketInput& packet) {
    for (int i = 0; i < K; ++i) {
      px_[i] = Lanes<W>::load(packet.x + i * W);
      py_[i] = Lanes<W>::load(packet.y + i * W);
    }
    weight_ = negligible_ = Lanes<W, K>(0);
    whole_.room = kFirstEdges;
    cut_.room = kCutEdges;
  }

  template <class View, int kEdges>
  struct ViewList {
    int count = 0;
    int room = kEdges;  ///< edges until the list is emptied; an edge has up to K views
    View view[kEdges * K + kTogether];
  };

  SFUMATO_INLINE void append_whole(const HitEdge* edge, LaneBits lanes) {
    for (int i = 0; i < K; ++i) {
      EdgeView<W>& view = whole_.view[whole_.count];
      view.edge = edge;
      view.row = i;
      view.lanes = bits_of_row(lanes, i);
      whole_.count += view.lanes != 0;
    }
  }

  SFUMATO_INLINE void append_cut(const HitEdge* edge, const Window<Lanes<W, K>>& window) {
    for (int i = 0; i < K; ++i) {
      CutEdgeView<W>& view = cut_.view[cut_.count];
      view.edge = edge;
      view.row = i;
      view.lanes = bits_of_row(window.lanes, i);
      view.whole_right = bits_of_row(window.whole_right, i);
      view.whole_left = bits_of_row(window.whole_left, i);
      view.right = {window.right.x.row(i), window.right.y.row(i)};
      view.left = {window.left.x.row(i), window.left.y.row(i)};
      cut_.count += view.lanes != 0;
    }
  }

  template <class List>
  __attribute__((noinline)) void flush(List& list, int room) {
    // Views without lanes fill the last group.
    for (int i = list.count; i % kTogether != 0; ++i) {
      list.view[i] = list.view[i - 1];
      list.view[i].lanes = 0;
    }
    for (int i = 0; i < list.count; i += kTogether) integrate(list.view + i);
    list.count = 0;
    list.room = room;
    negligible_ = weight_ * Lanes<W, K>(sums().negligible_share());
  }

  /// Returns the same number of each view, one per lane.
  template <class Get>
  SFUMATO_INLINE static F side_by_side(Get get) {
    F r;
#pragma GCC unroll 8
    for (int i = 0; i < kTogether; ++i) r.part[i] = get(i).part[0];
    return r;
  }
  template <class Get>
  SFUMATO_INLINE static typename F::Mask masks_side_by_side(Get get) {
    typename F::Mask r;
#pragma GCC unroll 8
    for (int i = 0; i < kTogether; ++i) r.part[i] = LaneMask<W>::from_bits(get(i)).part[0];
    return r;
  }

  SFUMATO_INLINE static LaneBits bits_of_row(LaneBits bits, int row) {
    return bits >> (row * W) & ((1u << W) - 1);
  }

  /// Edges relative to the points that see them.
  template <class L>
  struct Seen {
    Direction<L> a, b, e;
    L area;  ///< a × b
    L length_squared;
    typename L::Mask lanes;

    SFUMATO_INLINE Seen<Lanes<W>> row(int i) const {
      return {{a.x.row(i), a.y.row(i)}, {b.x.row(i), b.y.row(i)},
              {e.x.row(i), e.y.row(i)}, area.row(i),
              length_squared.row(i),    lanes.row(i)};
    }
  };

  template <class View>
  SFUMATO_INLINE Seen<F> seen(const View* view) const {
    const auto of_edge = [view](float HitEdge::*member) {
      return side_by_side([&](int i) { return Lanes<W>(view[i].edge->*member); });
    };
    const F px = side_by_side([&](int i) { return px_[view[i].row]; });
    const F py = side_by_side([&](int i) { return py_[view[i].row]; });
    Seen<F> s;
    s.a = {of_edge(&HitEdge::ax) - px, of_edge(&HitEdge::ay) - py};
    s.b = {of_edge(&HitEdge::bx) - px, of_edge(&HitEdge::by) - py};
    s.e = {of_edge(&HitEdge::ex), of_edge(&HitEdge::ey)};
    s.area = s.a.x * s.e.y - s.a.y * s.e.x;
    s.length_squared = of_edge(&HitEdge::length_squared);
    s.lanes = masks_side_by_side([&](int i) { return view[i].lanes; });
    return s;
  }

  SFUMATO_INLINE void integrate(const EdgeView<W>* view) {
    const Seen<F> s = seen(view);
    const PartWeight<F> w =
        part_weight(s.a.x, s.a.y, s.b.x, s.b.y, s.area, s.length_squared, s.lanes);
    sums().sum_all(view, s, {F(0), F(1), w.weight, w.lean});
  }

  SFUMATO_INLINE void integrate(const CutEdgeView<W>* view) {
    const Seen<F> s = seen(view);
    const auto whole_right = masks_side_by_side([&](int i) { return view[i].whole_right; });
    const auto whole_left = masks_side_by_side([&](int i) { return view[i].whole_left; });
    const Direction<F> right{side_by_side([&](int i) { return view[i].right.x; }),
                             side_by_side([&](int i) { return view[i].right.y; })};
    const Direction<F> left{side_by_side([&](int i) { return view[i].left.x; }),
                            side_by_side([&](int i) { return view[i].left.y; })};
    const F t1 = zero_unless(and_not(s.lanes, whole_right), cut(s.a, s.e, right));
    const F t2 = select(whole_left, F(1), cut(s.a, s.e, left));
    const F q2x = select(whole_left, s.b.x, s.a.x + t2 * s.e.x);
    const F q2y = select(whole_left, s.b.y, s.a.y + t2 * s.e.y);
    const F share = t2 - t1;
    const PartWeight<F> w =
        part_weight(s.a.x + t1 * s.e.x, s.a.y + t1 * s.e.y, q2x, q2y, s.area * share,
                    s.length_squared * (share * share), s.lanes);
    const F lean = w.weight * (t1 + t2 - F(1)) + w.lean * share;
    sums().sum_all(view, s, {t1, t2, w.weight, lean});
  }

  /// A visible part: the range t1 to t2 of its edge, and its weight.
  template <class L>
  struct Part {
    L t1, t2;
    L weight;
    L lean;  ///< the weight's mean place on the edge, from -1 at a to 1 at b, times the weight
  };

  /// Returns where a ray cuts the line through a along e, as a fraction of e, clamped to the edge.
  SFUMATO_INLINE static F cut(const Direction<F>& a, const Direction<F>& e,
                              const Direction<F>& ray) {
    const F t = (a.y * ray.x - a.x * ray.y) * reciprocal(e.x * ray.y - e.y * ray.x);
    return min(max(t, F(0)), F(1));
  }

  SFUMATO_INLINE void add_weight(const EdgeView<W>& view, const Lanes<W>& weight) {
    weight_.part[view.row] = (weight_.row(view.row) + weight * Lanes<W>(view.edge->weight)).part[0];
  }

  Lanes<W> px_[K], py_[K];
  Lanes<W, K> weight_;

 private:
  Sums& sums() {
    return static_cast<Sums&>(*this);
  }

  Lanes<W, K> negligible_;
  ViewList<EdgeView<W>, kWholeEdges> whole_;
  ViewList<CutEdgeView<W>, kCutEdges> cut_;
};

}  // namespace sfumato::gather::inline SFUMATO_ISA
