#include "solve/fields/seams.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.hpp"
#include "base/try.hpp"

namespace sfumato::solve {
namespace {

/// Values of a curve's two neighbouring pieces at their common vertex differ only by rounding.
constexpr float kSameValue = 1.0f / (255 * 64);

constexpr std::size_t kSeamsPerTask = 256;

bool same(float a, float b) {
  return std::fabs(a - b) <= kSameValue;
}

float share_of(const SeamValue& value, std::uint32_t shader) {
  float sum = 0;
  for (int i = 0; i < 2; ++i) sum += value.shader[i] == shader ? value.share[i] : 0;
  return sum;
}

/// Adds `share` of a side's value at fraction u of it; its shader goes to place i.
void add_side(const gather::Facing& side, float u, float share, int i, SeamValue& value) {
  if (side.kind == ShaderKind::image_domain) {
    value.shader[i] = side.shader;
    value.share[i] = share;
    return;
  }
  const curves::FieldValue base = lerp(side.from, side.to, u);
  for (std::size_t c = 0; c < base.channel.size(); ++c) {
    value.base.channel[c] += share * base.channel[c];
  }
}

}  // namespace

bool same_value(const SeamValue& a, const SeamValue& b) {
  if (!std::ranges::equal(a.base.channel, b.base.channel, same)) return false;
  const auto same_share = [&](std::uint32_t s) { return same(share_of(a, s), share_of(b, s)); };
  return std::all_of(a.shader, a.shader + 2, same_share) &&
         std::all_of(b.shader, b.shader + 2, same_share);
}

Result<Seams> Seams::create(const Context& context, const mesh::TriangleMesh& mesh,
                            const curves::SegmentAttributes& attributes) {
  Seams seams(mesh);
  TableMemory scratch("patches along curves");
  std::vector<std::uint32_t> all;
  Status status = scratch.resize(context, all, mesh.triangle_count());
  std::iota(all.begin(), all.end(), 0u);
  if (status) status = seams.update(context, attributes, all);
  if (!status) return status;
  return seams;
}

Result<Seams> Seams::copy(const Context& context, const mesh::TriangleMesh& mesh) const {
  Seams seams(mesh);
  SFUMATO_TRY(seams.memory_.append(context, facing_, seams.facing_));
  SFUMATO_TRY(seams.memory_.append(context, mark_, seams.mark_));
  return seams;
}

Status Seams::update(const Context& context, const curves::SegmentAttributes& attributes,
                     std::span<const std::uint32_t> changed) {
  const std::size_t facings = 2 * mesh_->constraint.size();
  const std::size_t half_edges = mesh_->half_edge_constraint.size();
  SFUMATO_TRY(memory_.grow(context, facing_, facings, facings / 4 * 5));
  SFUMATO_TRY(memory_.grow(context, mark_, half_edges, half_edges / 4 * 5));
  const auto for_each_half_edge = [&](auto visit) {
    return parallel_for(context, changed.size(), kSeamsPerTask,
                        [&](std::size_t begin, std::size_t end) {
                          for (std::size_t i = begin; i < end; ++i)
                            for (std::uint32_t k = 0; k < 3; ++k) visit(3 * changed[i] + k);
                        });
  };
  SFUMATO_TRY(for_each_half_edge([&](std::uint32_t h) {
    mark_[h] = 0;
    if (mesh_->half_edge_constraint[h] == mesh::kNone) return;
    facing_[index(h)] = gather::facing_side(*mesh_, attributes, h);
    if (mesh_->half_edge_twin[h] == mesh::kNone) facing_[index(h) ^ 1] = {};
  }));
  SFUMATO_TRY(for_each_half_edge([&](std::uint32_t h) {
    if (mesh_->half_edge_constraint[h] != mesh::kNone) mark_[h] = mark_of(h);
  }));
  return ok_status();
}

void Seams::take_back(const Seams& before, std::span<const std::uint32_t> changed) {
  mark_.resize(before.mark_.size());
  facing_.resize(before.facing_.size());
  for (const std::uint32_t t : changed) {
    if (3 * std::size_t{t} >= mark_.size()) continue;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      mark_[h] = before.mark_[h];
      if (before.mesh_->half_edge_constraint[h] == mesh::kNone) continue;
      const std::size_t pair = before.index(h) & ~std::size_t{1};
      std::copy_n(before.facing_.data() + pair, 2, facing_.data() + pair);
    }
  }
}

std::uint8_t Seams::mark_of(std::uint32_t half_edge) const {
  const gather::Facing &front = facing(half_edge), &behind = back(half_edge);
  if (front.kind == ShaderKind::open && behind.kind == ShaderKind::open) return 0;
  const bool is_fine = front.fine_from > 0 || front.fine_to > 0;
  return is_fine && front.has_value() && behind.has_value() ? kSeam | kFineBlur : kSeam;
}

float Seams::blur_radius(std::uint32_t half_edge, float u) const {
  if (!has_value(half_edge) || !back(half_edge).has_value()) return 0;
  return lerp(facing(half_edge).blur_from, facing(half_edge).blur_to, u);
}

float Seams::fine_radius(std::uint32_t half_edge, float u) const {
  if (!may_be_fine(half_edge)) return 0;
  return lerp(facing(half_edge).fine_from, facing(half_edge).fine_to, u);
}

SeamValue Seams::value(std::uint32_t half_edge, float u) const {
  const float front_share = blur_radius(half_edge, u) > 0 ? 0.5f : 1.0f;
  SeamValue value;
  add_side(facing(half_edge), u, front_share, 0, value);
  if (front_share < 1) add_side(back(half_edge), 1 - u, 1 - front_share, 1, value);
  return value;
}

}  // namespace sfumato::solve
