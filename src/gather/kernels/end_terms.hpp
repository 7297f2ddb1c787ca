#pragma once

#include "gather/kernels/blur_kernel.hpp"
#include "gather/kernels/end_tree.hpp"
#include "gather/kernels/scene_layout.hpp"
#include "gather/kernels/window.hpp"

/// The terms of free ends (docs/mathematics.md) in lanes, single precision: FreeEnds::add for a
/// packet.
namespace sfumato::gather::inline SFUMATO_ISA {

template <int W>
class EndTerms {
 public:
  EndTerms(const SceneView& scene, const PacketInput& packet, PacketResult& result)
      : scene_(scene),
        result_(result),
        px_(F::load(packet.x)),
        py_(F::load(packet.y)),
        weight_(F::load(result.weight)) {
    box_ = {packet.x[0], packet.y[0], packet.x[0], packet.y[0]};
    for (int i = 1; i < kPacketLanes; ++i) {
      box_ = united(box_, {packet.x[i], packet.y[i], packet.x[i], packet.y[i]});
    }
  }

  /// Adds the terms of the ends that reach points of the packet to its result.
  void add() {
    visit_leaves(scene_.ends, box_, [&](std::uint32_t leaf) {
      const std::uint32_t first = kEndsPerLeaf * leaf, end = first + kEndsPerLeaf;
      for (std::uint32_t i = first; i < end && i < scene_.ends.term_count; ++i) {
        add(scene_.ends.term[i]);
      }
      return true;
    });
    weight_.store(result_.weight);
  }

 private:
  using F = Lanes<W, kPacketLanes / W>;

  void add(const EndTerm& end) {
    const Direction<F> d{px_ - F(end.x), py_ - F(end.y)};
    const F r_squared = d.x * d.x + d.y * d.y;
    const F x = r_squared * F(end.inverse_reach_squared);
    const auto lanes = (x < F(1)) & (r_squared > F(0));
    if (!any(lanes)) return;
    const F fade = F(1) - x;
    const F more =
        zero_unless(lanes, F(end.weight) * (fade * fade) / (r_squared * (F(1) + F(kEndKnee) * x)));
    weight_ = weight_ + more;
    const F mixed = zero_unless(lanes, more / weight_);
    mix(end, positive_share(end, d, sqrt(select(lanes, r_squared, F(1)))), mixed);
  }

  /// Returns τ of a point at d from the end, |d| = r.
  SFUMATO_INLINE static F positive_share(const EndTerm& end, const Direction<F>& d, const F& r) {
    const F sine = F(end.bend) * r;
    const F cosine = sqrt(max(F(1) - sine * sine, F(0)));
    const Direction<F> u{cosine * d.x + sine * d.y, cosine * d.y - sine * d.x};  // unbent
    const F across = F(end.direction_x) * u.y - F(end.direction_y) * u.x;
    const F ahead = F(end.direction_x) * u.x + F(end.direction_y) * u.y;
    // The greater of sin(|φ|/2) and cos(φ/2), which has no cancellation.
    const F greater = sqrt(F(0.5f) * (r + abs(ahead)) / r);
    const F other = across / (r + r) / greater;
    const auto is_positive = across > F(0);
    const F half_sine = select(ahead > F(0), other, select(across < F(0), F(0) - greater, greater));
    const F radius = select(is_positive, F(end.blur_positive), F(end.blur_negative));
    const F front = front_share(abs(across), radius);
    return F(0.5f) + F(0.5f) * half_sine * (F(2) * front - F(1));
  }

  void mix(const EndTerm& end, const F& positive, const F& mixed) {
    for (int c = 0; c < scene_.base_channels; ++c) {
      const F z = F(end.negative[c]) + positive * F(end.positive[c] - end.negative[c]);
      const F value = F::load(result_.value[c]);
      (value + mixed * (z - value)).store(result_.value[c]);
    }
    float* share = result_.shader_share;
    for (int s = 0; s < scene_.shader_count; ++s, share += kPacketLanes) {
      const F value = F::load(share);
      (value - mixed * value).store(share);
    }
  }

  const SceneView& scene_;
  PacketResult& result_;
  F px_, py_;
  F weight_;
  EndBox box_;
};

}  // namespace sfumato::gather::inline SFUMATO_ISA
