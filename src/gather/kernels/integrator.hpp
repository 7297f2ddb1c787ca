#pragma once

#include <cmath>

#include "gather/kernels/blur_kernel.hpp"
#include "gather/kernels/edge_views.hpp"
#include "gather/kernels/negligible.hpp"
#include "gather/kernels/scene_layout.hpp"

namespace sfumato::gather::inline SFUMATO_ISA {

/// Replaces kNegligible where a far field estimates the contribution of the window. At the nodes of
/// the mesh among 1,000 to 10,000 specks of half a pixel it costs at most 0.05 for half of them,
/// 0.2 for 99 of 100 and 0.4 for any; among 10,000 strokes of two pixels 0.6 for any.
inline constexpr float kEstimated = 5e-4f;

/// A radius that differs from its mean on the edge by at most this share c is treated as constant.
/// The error is at most 0.75 c² of the contrast, less than that of the quadrature. On flattened
/// curves few radii vary more.
inline constexpr float kEvenChange = 1.0f / 32;

/// Computes W and Σ w z of one packet.
///
/// kChannels: of the values, 3 or 4.
/// kBlends: sides have blur radii or image-domain shaders (SceneView::blend exists).
template <int W, int kChannels, bool kBlends>
class Integrator : public EdgeViews<W, Integrator<W, kChannels, kBlends>> {
  using Views = EdgeViews<W, Integrator>;
  friend Views;

 public:
  using Result = PacketResult;
  using Views::K;
  static constexpr bool kTakesMeans = true;

  /// Result::shader_share is written by end().
  void begin(const SceneView& scene, const PacketInput& packet, const Result& out) {
    Views::begin_views(packet);
    negligible_share_ = scene.negligible;
    if constexpr (kBlends) {
      first_hit_ = scene.hit_edge;
      blend_ = scene.blend;
      share_ = out.shader_share;
      shader_count_ = scene.shader_count;
      for (int i = 0; i < shader_count_; ++i) Lanes<W, K>(0).store(share_ + i * kPacketLanes);
    }
    for (auto& channel : value_) channel = Lanes<W, K>(0);
  }

  /// Returns by how much more than a negligible window one may weigh that a far field estimates.
  float estimated_times() const { return kEstimated / negligible_share_; }

  /// Adds the estimate for a window: numbers of a far field, times `weight`.
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

  void end(PacketResult& out) {
    Views::flush();
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
  using Views::kTogether, Views::add_weight, Views::weight_;
  using F = typename Views::F;
  template <class L>
  using Seen = typename Views::template Seen<L>;
  template <class L>
  using Part = typename Views::template Part<L>;

  float negligible_share() const { return negligible_share_; }

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

  SFUMATO_INLINE void sum(const EdgeView<W>& view, const Lanes<W>& weight, const Lanes<W>& lean) {
    add_weight(view, weight);
    add_value(view.row, weight, lean, view.edge->middle, view.edge->half_change);
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

  // Applies eq. 11: the share β of a part's weight goes to the visible side, the rest to its back.
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

  /// Integrates where the radius is below the distance only over the rest of the part, because β is
  /// 1 there. Arguments are passed by value: references would keep them in memory also for edges
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

  /// Adds a part's share of one side's shader.
  SFUMATO_INLINE void add_side(const EdgeView<W>& view, const Lanes<W>& weight,
                               const Lanes<W>& lean, std::int32_t shader,
                               const float (&middle)[kValueChannels],
                               const float (&half_change)[kValueChannels]) {
    if (shader < 0) return add_value(view.row, weight, lean, middle, half_change);
    float* share = share_ + shader * kPacketLanes + view.row * W;
    (Lanes<W>::load(share) + weight * Lanes<W>(view.edge->weight)).store(share);
  }

  Lanes<W, K> value_[kChannels];
  float negligible_share_ = kNegligible;
  const HitEdge* first_hit_ = nullptr;  ///< this and the rest: only where kBlends
  const HitBlend* blend_ = nullptr;
  float* share_ = nullptr;
  int shader_count_ = 0;
};

}  // namespace sfumato::gather::inline SFUMATO_ISA
