#pragma once

#include <cmath>

#include "gather/kernels/blur_kernel.hpp"
#include "gather/kernels/closed_form.hpp"
#include "gather/kernels/scene_layout.hpp"
#include "gather/kernels/window.hpp"

namespace sfumato::gather::inline SFUMATO_ISA {

/// A window that cannot add more than this share of the weight found so far is not followed. Its
/// measured cost at the nodes of the paper's mesh, in code values of 255: on dolphin, lady_bug,
/// roses and portrait.svg at most 0.02 for 99 nodes of 100 and 0.05 for any.
inline constexpr float kNegligible = 6e-5f;

/// The same where a far field tells what about the window would have added (SceneView::far). At the
/// nodes of the mesh among 1,000 to 10,000 specks of half a pixel it costs at most 0.05 for half of
/// them, 0.2 for 99 of 100 and 0.4 for any; among 10,000 strokes of two pixels 0.6 for any.
inline constexpr float kEstimated = 5e-4f;

/// A radius that differs from its mean on the edge by at most this share c is treated as constant.
/// The error is at most 0.75 c² of the contrast, less than that of the quadrature. On flattened
/// curves few radii vary more.
inline constexpr float kEvenChange = 1.0f / 32;

/// An edge as seen by one register of lanes.
template <int W>
struct EdgeView {
  const HitEdge* edge;
  int row;         ///< which register of the packet
  LaneBits lanes;  ///< W bits
};

/// An edge of which some of the lanes see a part.
template <int W>
struct CutEdgeView : EdgeView<W> {
  LaneBits whole_right;
  LaneBits whole_left;
  Direction<Lanes<W>> right;
  Direction<Lanes<W>> left;
};

/// W and Σ w z of one packet. Visible edges are collected and then integrated several at a time,
/// because the closed form is one long chain of dependent steps and several chains side by side use
/// the processor fully. There is one list for edges that every lane sees whole and one for edges
/// that are cut for some lanes. When the lists are emptied depends on the packet alone, not on W,
/// and so does the order of every lane's sum.
///
/// kChannels: of the values, 3 or 4.
/// kBlends: sides have blur radii or image-domain shaders (SceneView::blend is there).
template <int W, int kChannels, bool kBlends>
class Integrator {
 public:
  static constexpr int K = kPacketLanes / W;

  /// shader_share   as PacketResult's; written by end()
  void begin(const SceneView& scene, const PacketInput& packet, float* shader_share) {
    for (int i = 0; i < K; ++i) {
      px_[i] = Lanes<W>::load(packet.x + i * W);
      py_[i] = Lanes<W>::load(packet.y + i * W);
    }
    if constexpr (kBlends) {
      first_hit_ = scene.hit_edge;
      blend_ = scene.blend;
      share_ = shader_share;
      shader_count_ = scene.shader_count;
      for (int i = 0; i < shader_count_; ++i) Lanes<W, K>(0).store(share_ + i * kPacketLanes);
    }
    weight_ = negligible_ = Lanes<W, K>(0);
    for (auto& channel : value_) channel = Lanes<W, K>(0);
    whole_.room = kFirstEdges;
    cut_.room = kCutEdges;
  }

  /// Precondition: is_hit(code), and the window has lanes.
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

  /// Adds what is told of a window: numbers of a far field, times `weight`.
  SFUMATO_INLINE void add_mean(const float* mean, const Lanes<W, K>& weight) {
    using A = Lanes<W, K>;
    weight_ = weight_ + weight * A(mean[kFarWeight]);
    for (int c = 0; c < kChannels; ++c) value_[c] = value_[c] + weight * A(mean[kFarValue + c]);
    if constexpr (kBlends) {
      float* share = share_;
      for (int i = 0; i < shader_count_; ++i, share += kPacketLanes) {
        (A::load(share) + weight * A(mean[kFarValue + kValueChannels + i])).store(share);
      }
    }
  }

  /// Weight below which a window is not followed: kNegligible times the weight integrated so far.
  SFUMATO_INLINE const Lanes<W, K>& negligible_weight() const { return negligible_; }

  /// Integrates what was added so far.
  void flush() {
    flush(whole_, kWholeEdges);
    flush(cut_, kCutEdges);
  }

  void end(PacketResult& out) {
    flush();
    weight_.store(out.weight);
    const auto is_hit = weight_ > Lanes<W, K>(0);
    for (int c = 0; c < kChannels; ++c) {
      zero_unless(is_hit, value_[c] / weight_).store(out.value[c]);
    }
    if constexpr (kBlends) {
      for (float* share = share_; share < share_ + shader_count_ * kPacketLanes;
           share += kPacketLanes) {
        zero_unless(is_hit, Lanes<W, K>::load(share) / weight_).store(share);
      }
    }
  }

 private:
  static constexpr int kTogether = 4;
  static constexpr int kFirstEdges = 12;  ///< few, because the walk needs the weight so far
  static constexpr int kWholeEdges = 96;
  static constexpr int kCutEdges = 24;
  using F = Lanes<W, kTogether>;

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
    negligible_ = weight_ * Lanes<W, K>(kNegligible);
  }

  /// The same number of each view, one per lane.
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
    sum_all(view, s, {F(0), F(1), w.weight, w.lean});
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
    sum_all(view, s, {t1, t2, w.weight, lean});
  }

  /// A visible part: the range t1 to t2 of its edge, and its weight.
  template <class L>
  struct Part {
    L t1, t2;
    L weight;
    L lean;  ///< the weight's mean place on the edge, from -1 at a to 1 at b, times the weight
  };

  template <class View>
  SFUMATO_INLINE void sum_all(const View* view, const Seen<F>& s, const Part<F>& part) {
#pragma GCC unroll 8
    for (int i = 0; i < kTogether; ++i) {
      if constexpr (kBlends) {
        sum_blended(view[i], s.row(i),
                    {part.t1.row(i), part.t2.row(i), part.weight.row(i), part.lean.row(i)});
      } else {
        sum(view[i], part.weight.row(i), part.lean.row(i));
      }
    }
  }

  /// Where a ray cuts the line through a along e, as a fraction of e, clamped to the edge.
  SFUMATO_INLINE static F cut(const Direction<F>& a, const Direction<F>& e,
                              const Direction<F>& ray) {
    const F t = (a.y * ray.x - a.x * ray.y) * reciprocal(e.x * ray.y - e.y * ray.x);
    return min(max(t, F(0)), F(1));
  }

  SFUMATO_INLINE void sum(const EdgeView<W>& view, const Lanes<W>& weight, const Lanes<W>& lean) {
    add_weight(view, weight);
    add_value(view.row, weight, lean, view.edge->middle, view.edge->half_change);
  }

  SFUMATO_INLINE void add_weight(const EdgeView<W>& view, const Lanes<W>& weight) {
    weight_.part[view.row] = (weight_.row(view.row) + weight * Lanes<W>(view.edge->weight)).part[0];
  }

  // The value is linear along the edge: w₁ z₁ + w₂ z₂ from its mean and half its change.
  SFUMATO_INLINE void add_value(int row, const Lanes<W>& weight, const Lanes<W>& lean,
                                const float (&middle)[kValueChannels],
                                const float (&half_change)[kValueChannels]) {
    using R = Lanes<W>;
    for (int c = 0; c < kChannels; ++c) {
      const R more = weight * R(middle[c]) + lean * R(half_change[c]);
      value_[c].part[row] = (value_[c].row(row) + more).part[0];
    }
  }

  // Eq. 11: the share β of a part's weight goes to the side that is seen, the rest to its back.
  SFUMATO_INLINE void sum_blended(const EdgeView<W>& view, const Seen<Lanes<W>>& s,
                                  const Part<Lanes<W>>& part) {
    const HitBlend& blend = blend_[view.edge - first_hit_];
    add_weight(view, part.weight);
    const Lanes<W> widest(blend.blur_middle + std::fabs(blend.blur_half_change));
    if (!any((normal_distance(blend, s) < widest) & s.lanes)) {
      add_side(view, part.weight, part.lean, blend.front_shader, view.edge->middle,
               view.edge->half_change);
      return;
    }
    const bool is_even = std::fabs(blend.blur_half_change) <= kEvenChange * blend.blur_middle;
    const BackPart back = is_even ? back_of_even(blend, s, part) : back_of_growing(blend, s, part);
    add_side(view, part.weight - back.weight, part.lean - back.lean, blend.front_shader,
             view.edge->middle, view.edge->half_change);
    add_side(view, back.weight, back.lean, blend.back_shader, blend.back_middle,
             blend.back_half_change);
  }

  /// The share of a part's weight that goes to the side behind it.
  struct BackPart {
    Lanes<W> weight;
    Lanes<W> lean;
  };

  SFUMATO_INLINE static Lanes<W> normal_distance(const HitBlend& blend, const Seen<Lanes<W>>& s) {
    return max(s.area * Lanes<W>(blend.inverse_length), Lanes<W>(0));
  }

  /// Uses the radius at the weighted mean of the part.
  SFUMATO_INLINE static BackPart back_of_even(const HitBlend& blend, const Seen<Lanes<W>>& s,
                                              const Part<Lanes<W>>& part) {
    using R = Lanes<W>;
    const R mean = zero_unless(part.weight > R(0), part.lean / part.weight);
    const R radius = R(blend.blur_middle) + R(blend.blur_half_change) * mean;
    const R back = R(1) - front_share(normal_distance(blend, s), radius);
    return {part.weight * back, part.lean * back};
  }

  /// Where the radius is below the distance, β is 1, so that only the rest of the part is
  /// integrated. Arguments are passed by value: references would keep them in memory also for edges
  /// that never come here.
  __attribute__((noinline)) static BackPart back_of_growing(const HitBlend& blend, Seen<Lanes<W>> s,
                                                            Part<Lanes<W>> part) {
    using R = Lanes<W>;
    const bool grows = blend.blur_half_change > 0;  // from a to b
    const R radius_a(blend.blur_middle - blend.blur_half_change);
    const R change(2 * blend.blur_half_change);
    const R distance = normal_distance(blend, s);
    const R reached = (distance - radius_a) * R(0.5f / blend.blur_half_change);
    const R t1 = grows ? max(part.t1, reached) : part.t1;
    const R t2 = grows ? part.t2 : min(part.t2, reached);
    const auto lanes = s.lanes & (t1 < t2);
    if (!any(lanes)) return {R(0), R(0)};
    const R share = t2 - t1;
    const auto to_end = t2 == R(1);
    const Direction<R> q1{s.a.x + t1 * s.e.x, s.a.y + t1 * s.e.y};
    const Direction<R> q2{select(to_end, s.b.x, s.a.x + t2 * s.e.x),
                          select(to_end, s.b.y, s.a.y + t2 * s.e.y)};
    const R weight = part_weight(q1.x, q1.y, q2.x, q2.y, s.area * share,
                                 s.length_squared * (share * share), lanes)
                         .weight;
    const R length1 = sqrt(q1.x * q1.x + q1.y * q1.y), length2 = sqrt(q2.x * q2.x + q2.y * q2.y);
    const R cosine = (q1.x * q2.x + q1.y * q2.y) / (length1 * length2);
    const R radius1 = radius_a + change * t1, radius2 = radius_a + change * t2;
    const BackMeans<R> mean =
        grows ? back_means<R>({length1, length2, cosine, radius1, radius2, distance})
              : back_means<R>({length2, length1, cosine, radius2, radius1, distance});
    const R place = (R(2) * (grows ? t1 : t2) - R(1)) * mean.share +
                    R(grows ? 2.0f : -2.0f) * (share * mean.moment);
    return {zero_unless(lanes, weight * mean.share), zero_unless(lanes, weight * place)};
  }

  /// A part's share of one side's shader.
  SFUMATO_INLINE void add_side(const EdgeView<W>& view, const Lanes<W>& weight,
                               const Lanes<W>& lean, std::int32_t shader,
                               const float (&middle)[kValueChannels],
                               const float (&half_change)[kValueChannels]) {
    if (shader < 0) return add_value(view.row, weight, lean, middle, half_change);
    float* share = share_ + shader * kPacketLanes + view.row * W;
    (Lanes<W>::load(share) + weight * Lanes<W>(view.edge->weight)).store(share);
  }

  Lanes<W> px_[K], py_[K];
  Lanes<W, K> weight_;
  Lanes<W, K> negligible_;
  Lanes<W, K> value_[kChannels];
  ViewList<EdgeView<W>, kWholeEdges> whole_;
  ViewList<CutEdgeView<W>, kCutEdges> cut_;
  const HitEdge* first_hit_ = nullptr;  ///< this and the rest: where kBlends
  const HitBlend* blend_ = nullptr;
  float* share_ = nullptr;
  int shader_count_ = 0;
};

}  // namespace sfumato::gather::inline SFUMATO_ISA
