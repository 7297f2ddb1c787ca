#include "gather/kernels/edge_views.hpp"
#include "gather/kernels/packet_walk.hpp"
#include "gather/kernels/row_kernel_entry.hpp"
#include "gather/kernels/row_layout.hpp"

/// The exact gather of packets for rows: it reports the edges that the points see, instead of a sum
/// of values.
namespace sfumato::gather::inline SFUMATO_ISA {

template <int W>
class RowViews : public EdgeViews<W, RowViews<W>> {
  using Views = EdgeViews<W, RowViews>;
  friend Views;

 public:
  using Result = const RowTaker;
  static constexpr bool kTakesMeans = false;

  void begin(const SceneView& scene, const PacketInput& packet, const RowTaker& taker) {
    Views::begin_views(packet);
    first_hit_ = scene.hit_edge;
    taker_ = taker;
    count_ = 0;
  }

  void end(const RowTaker&) {
    Views::flush();
    give();
  }

 private:
  using Views::kTogether, Views::add_weight;
  static constexpr int kRoom = 8 * kTogether;
  template <class L>
  using Seen = typename Views::template Seen<L>;
  template <class L>
  using Part = typename Views::template Part<L>;

  float negligible_share() const { return taker_.negligible; }

  template <class View, class F>
  SFUMATO_INLINE void sum_all(const View* view, const Seen<F>&, const Part<F>& part) {
    if (count_ + kTogether > kRoom) give();
#pragma GCC unroll 8
    for (int i = 0; i < kTogether; ++i) {
      add_weight(view[i], part.weight.row(i));
      RowView& out = out_[count_];
      part.weight.row(i).store(out.weight);
      part.lean.row(i).store(out.lean);
      part.t1.row(i).store(out.from);
      part.t2.row(i).store(out.to);
      out.hit = static_cast<std::uint32_t>(view[i].edge - first_hit_);
      out.lanes = view[i].lanes;
      out.first_lane = view[i].row * W;
      count_ += view[i].lanes != 0;
    }
  }

  void give() {
    taker_.take(taker_.self, out_, count_);
    count_ = 0;
  }

  const HitEdge* first_hit_ = nullptr;
  RowTaker taker_{};
  int count_ = 0;
  RowView out_[kRoom];
};

/// Walks one packet with W lanes to a register. Returns false where the stack is too small; the
/// taker has then received only a part.
template <int W>
bool find_rows(const SceneView& scene, const PacketInput& packet, const RowTaker& taker,
               const PacketStack& stack) {
  return PacketWalk<RowViews<W>>(scene, stack).run(packet, taker);
}

}  // namespace sfumato::gather::inline SFUMATO_ISA

namespace sfumato::gather {

RowKernel* row_kernel(LaneCount<SFUMATO_ISA_LANES>) {
  return find_rows<SFUMATO_ISA_LANES>;
}

}  // namespace sfumato::gather
