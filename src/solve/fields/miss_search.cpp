#include "solve/fields/miss_search.hpp"

#include <atomic>
#include <cmath>

#include "base/parallel.hpp"
#include "base/try.hpp"
#include "sfumato/base/color_space.hpp"

namespace sfumato::solve {
namespace {

constexpr std::size_t kSearchedPerTask = 256;
constexpr std::size_t kProbesPerTask = 256;

/// Measured on eight drawings: one in 70 of the patches that are off by more than the limit has a
/// prediction below three times the limit. Above that one probe comes first, elsewhere three…
constexpr float kSurelyDoubtful = 3;

/// …and where these miss by less than this share of the limit, others rarely miss by more than the
/// limit: that overlooks one miss in 150, and half of the overlooked ones are below 1.3 times the
/// limit.
constexpr float kClearShare = 0.25f;

/// Marks a triangle. Several threads may mark one at the same time.
void mark(std::uint8_t& is_marked) {
  std::atomic_ref(is_marked).store(1, std::memory_order_relaxed);
}

}  // namespace

bool has_code_values(const curves::SegmentAttributes& attributes) {
  return attributes.space == InterpolationSpace::srgb || attributes.base_channels < 3;
}

// In other spaces differences are not code values; and between nodes that all see a curve there may
// be a place that sees none.
MissSearch::MissSearch(Context& context, const Field& field, const MissLimit& limit)
    : context_(context),
      field_(field),
      limit_(limit),
      foretells_(limit.order == PatchOrder::cubic && has_code_values(field.attributes) &&
                 field.sees_everywhere) {}

Status MissSearch::run(std::span<const std::uint32_t> triangles, std::span<std::uint8_t> misses) {
  Status status = choose(triangles);
  if (!status || triangle_.empty()) return status;
  if (!foretells_) return probe(misses, {});
  std::vector<std::uint8_t> is_unclear;
  status = memory_.resize(context_, is_unclear, misses.size());
  if (status) status = probe(misses, is_unclear);
  if (!status) return status;
  choose_rest(is_unclear);
  return probe(misses, {});
}

Status MissSearch::choose(std::span<const std::uint32_t> triangles) {
  Status status = memory_.append(context_, triangles, triangle_);
  if (status) status = memory_.resize(context_, choice_, triangles.size(), kAllProbes);
  if (!status || !foretells_) return status;
  status = parallel_for(context_, triangles.size(), kSearchedPerTask,
                        [&](std::size_t begin, std::size_t end) {
                          std::vector<float> miss(channel_count());
                          for (std::size_t i = begin; i < end; ++i)
                            choice_[i] = first_choice(triangles[i], miss);
                        });
  if (status) drop_unprobed();
  return status;
}

/// miss   room for channel_count() floats
ProbeChoice MissSearch::first_choice(std::uint32_t triangle, std::span<float> miss) const {
  const ProbeChoice worst = foretell_miss(field_.layout, triangle, limit_.factors, miss.data());
  if (!is_more(miss, limit_.max_error, triangle)) return 0;
  return is_more(miss, kSurelyDoubtful * limit_.max_error, triangle) ? kInnerProbes : worst;
}

void MissSearch::choose_rest(std::span<const std::uint8_t> is_unclear) {
  for (std::size_t i = 0; i < triangle_.size(); ++i) {
    const ProbeChoice rest = kAllProbes & ~choice_[i];
    choice_[i] = is_unclear[triangle_[i]] ? rest : ProbeChoice{0};
  }
  drop_unprobed();
}

void MissSearch::drop_unprobed() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangle_.size(); ++i) {
    if (choice_[i] == 0) continue;
    triangle_[kept] = triangle_[i];
    choice_[kept++] = choice_[i];
  }
  triangle_.resize(kept);
  choice_.resize(kept);
}

Status MissSearch::probe(std::span<std::uint8_t> misses, std::span<std::uint8_t> is_unclear) {
  SFUMATO_TRY_ASSIGN(const ProbeSet& placed,
                     place_probes(context_, field_.mesh, field_.layout, triangle_, choice_));
  const ProbeSet& probes = placed;
  TableMemory scratch("probes of patches");
  std::vector<float> exact;
  SFUMATO_TRY(scratch.resize(context_, exact, probes.position.size() * channel_count()));
  SFUMATO_TRY(field_.gatherer.gather(context_, probes.position, {}, exact));
  const float clear = kClearShare * limit_.max_error;
  return parallel_for(context_, probes.position.size(), kProbesPerTask,
                      [&](std::size_t begin, std::size_t end) {
                        std::vector<float> miss(channel_count());
                        for (std::size_t i = begin; i < end; ++i) {
                          measure(probes, i, exact.data() + channel_count() * i, miss.data());
                          const std::uint32_t half_edge = probes.half_edge[i], t = half_edge / 3;
                          if (!is_unclear.empty() && is_more(miss, clear, t)) mark(is_unclear[t]);
                          if (!is_more(miss, limit_.max_error, t)) continue;
                          mark(misses[t]);
                          const std::int32_t twin = field_.mesh.half_edge_twin[half_edge];
                          if (probes.place[i] == kEdgePlace && twin != mesh::kNone)
                            mark(misses[twin / 3]);
                        }
                      });
}

void MissSearch::measure(const ProbeSet& probes, std::size_t i, float* exact, float* miss) const {
  patch_value_at_probe(probes, i, field_.layout, limit_.order, miss);
  show_as_code_values(miss);
  show_as_code_values(exact);
  for (std::size_t c = 0; c < channel_count(); ++c) miss[c] = std::fabs(miss[c] - exact[c]);
}

bool MissSearch::is_more(std::span<const float> miss, float most, std::uint32_t triangle) const {
  const auto is_below = [&](float weight) {
    for (std::size_t c = 0; c < miss.size(); ++c) {
      if (!((is_opacity(c) ? miss[c] : weight * miss[c]) <= most)) return false;
    }
    return true;
  };
  return !is_below(1) && !is_below(limit_.color_weight(triangle));
}

bool MissSearch::is_opacity(std::size_t channel) const {
  const int base_channels = field_.attributes.base_channels;
  return base_channels == 1 || (base_channels > 3 && channel == kOpacityChannel);
}

/// Converts a value for measuring. The tolerance is in code values, for every space of the colours.
void MissSearch::show_as_code_values(float* value) const {
  if (has_code_values(field_.attributes)) return;
  const Rgb code = to_srgb(field_.attributes.space, {value[0], value[1], value[2]});
  value[0] = code.r, value[1] = code.g, value[2] = code.b;
}

}  // namespace sfumato::solve
