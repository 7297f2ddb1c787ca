#include "solve/fields/field_solver.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <utility>

#include "base/parallel.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"
#include "solve/fields/layout_order.hpp"

namespace sfumato::solve {
namespace {

constexpr std::size_t kNodes = kNodesPerTriangle;

}  // namespace

Status FieldSolver::start(Context& context, const mesh::TriangleMesh& mesh) {
  Result<Seams> seams = Seams::create(context, mesh, field_.attributes);
  if (seams) seams_.emplace(std::move(*seams));
  return seams.status();
}

Status FieldSolver::lay_out(Context& context, const mesh::TriangleMesh& mesh, std::size_t spare) {
  SFUMATO_TRY_ASSIGN(
      layout_, lay_out_nodes(context, mesh, field_.attributes, *seams_, layout_memory_, spare));
  Status status = list_free_nodes(context, memory_, to_gather_);
  if (status) status = memory_.reserve(context, node_hit_, layout_.position.capacity());
  if (status) status = memory_.resize(context, node_hit_, layout_.node_count(), 1);
  return status ? size_places(context) : status;
}

/// Makes the table of places as long as the nodes, if places are kept.
Status FieldSolver::size_places(const Context& context) {
  if (!keeps_places_) return ok_status();
  return memory_.grow(context, node_place_, layout_.node_count(), layout_.position.capacity(),
                      gather::kUnknownPlace);
}

Status FieldSolver::follow(Context& context, const mesh::TriangleMesh& mesh,
                           std::span<const std::uint32_t> changed) {
  Status status = seams_->update(context, field_.attributes, changed);
  if (!status || layout_.triangle_node.empty()) return status;
  status = update_layout(context, mesh, field_.attributes, *seams_, changed, layout_memory_,
                         layout_, history_);
  if (status) {
    status = memory_.grow(context, node_hit_, layout_.node_count(), layout_.position.capacity(), 1);
  }
  if (status) status = size_places(context);
  to_gather_.clear();
  if (status) status = memory_.append(context, history_.fresh, to_gather_);
  if (!status) return status;
  for (const std::uint32_t node : history_.unused) node_hit_[node] = 1;
  return ok_status();
}

Status FieldSolver::copy_values(const Context& context, const KnownNodes& before,
                                std::span<const std::int32_t> kept, std::span<std::uint8_t> asks,
                                TableMemory& memory, std::vector<std::uint32_t>& carried) {
  const NodeLayout& old = before.layout;
  const auto channels = static_cast<std::size_t>(layout_.channel_count);
  SFUMATO_TRY(memory.reserve(context, carried, layout_.node_count()));
  RarePoll<16384> poll(context);
  for (std::size_t t = 0; t < kept.size(); ++t) {
    if (poll.cancelled()) return context.cancel_status();
    if (kept[t] == mesh::kNone) continue;
    for (std::size_t place = 0; place < kNodesPerTriangle; ++place) {
      const auto now = kNodesPerTriangle * static_cast<std::size_t>(kept[t]) + place;
      const std::uint32_t node = layout_.triangle_node[now];
      const std::uint32_t from = old.triangle_node[kNodesPerTriangle * t + place];
      if (!asks[node] || old.is_fixed[from] || !(layout_.position[node] == old.position[from])) {
        continue;
      }
      std::copy_n(old.value.begin() + static_cast<std::ptrdiff_t>(channels * from), channels,
                  layout_.value.begin() + static_cast<std::ptrdiff_t>(channels * node));
      node_hit_[node] = before.node_hit[from];
      asks[node] = 0;
      carried.push_back(node);
    }
  }
  return ok_status();
}

Result<std::vector<std::uint8_t>> FieldSolver::asked_nodes(const Context& context,
                                                           TableMemory& memory) const {
  std::vector<std::uint8_t> asks;
  SFUMATO_TRY(memory.resize(context, asks, layout_.node_count()));
  for (const std::uint32_t node : to_gather_) asks[node] = 1;
  return asks;
}

Status FieldSolver::mark_gathered(const Context& context, std::span<std::uint8_t> marks) const {
  TableMemory scratch("patches");
  std::vector<std::uint8_t> is_gathered;
  SFUMATO_TRY(scratch.resize(context, is_gathered, layout_.node_count()));
  for (const std::uint32_t node : gathered_) is_gathered[node] = 1;
  RarePoll<16384> poll(context);
  for (std::size_t t = 0; t < marks.size(); ++t) {
    if (poll.cancelled()) return context.cancel_status();
    const std::span<const std::uint32_t> nodes =
        std::span(layout_.triangle_node).subspan(kNodes * t, kNodes);
    if (std::ranges::any_of(nodes, [&](std::uint32_t node) { return is_gathered[node] != 0; }))
      marks[t] = 1;
  }
  return ok_status();
}

Status FieldSolver::carry_over(Context& context, const KnownNodes& before,
                               std::span<const std::int32_t> kept,
                               const gather::ShareBound* bound) {
  if (!has_channels_of(before.field)) return ok_status();
  TableMemory scratch("patches");
  SFUMATO_TRY_ASSIGN(auto&& asks, asked_nodes(context, scratch));
  std::vector<std::uint32_t> carried;
  Status status = copy_values(context, before, kept, asks, scratch, carried);
  const gather::PointList points(layout_.position, carried);
  std::optional<gather::InsertedShare> inserted;
  if (bound && has_code_values(field_.attributes)) {
    inserted.emplace(gather::InsertedShare{*bound, node_hit_});
  }
  if (status) {
    status = field_.gatherer.find_changes(context, before.field.gatherer, points, asks,
                                          inserted ? &*inserted : nullptr);
  }
  if (!status) return status;
  keep_asked(asks);
  return ok_status();
}

bool FieldSolver::has_channels_of(const PreparedField& other) const {
  return field_.attributes.shader == other.attributes.shader &&
         field_.attributes.base_channels == other.attributes.base_channels;
}

std::size_t FieldSolver::bytes_of_nodes() const {
  return capacity_bytes(layout_.triangle_node, layout_.edge_is_curve, layout_.position,
                        layout_.is_fixed, layout_.value, node_hit_, node_place_, vertex_radius_);
}

Result<RefinedField> FieldSolver::copy_nodes(const Context& context) const {
  RefinedField refined;
  refined.layout.channel_count = layout_.channel_count;
  Status status;
  const auto copy = [&](const auto& source, auto& to) {
    if (status) status = refined.memory.append(context, source, to);
  };
  copy(layout_.triangle_node, refined.layout.triangle_node);
  copy(layout_.edge_is_curve, refined.layout.edge_is_curve);
  copy(layout_.position, refined.layout.position);
  copy(layout_.is_fixed, refined.layout.is_fixed);
  copy(layout_.value, refined.layout.value);
  copy(node_hit_, refined.node_hit);
  copy(node_place_, refined.node_place);
  copy(vertex_radius_, refined.vertex_radius);
  if (!status) return status;
  return refined;
}

RefinedField FieldSolver::release() {
  memory_.free(to_gather_);
  layout_memory_.take(std::move(memory_));
  return {std::move(layout_), std::move(node_hit_), std::move(node_place_),
          std::move(vertex_radius_), std::move(layout_memory_)};
}

Status FieldSolver::put_in_order(Context& context, const mesh::TriangleMesh& mesh) {
  if (history_.updates == 0) return ok_status();
  history_.free(layout_memory_);
  SFUMATO_TRY_ASSIGN(auto&& order, solve::put_in_order(context, mesh, layout_memory_, layout_));
  Status status = reorder(context, order, memory_, node_hit_);
  if (status && keeps_places_) status = reorder(context, order, memory_, node_place_);
  layout_memory_.free(order);
  return status;
}

Status FieldSolver::list_free_nodes(const Context& context, TableMemory& memory,
                                    std::vector<std::uint32_t>& free) const {
  free.clear();
  SFUMATO_TRY(memory.reserve(context, free, layout_.node_count()));
  RarePoll<65536> poll(context);
  for (std::uint32_t node = 0; node < layout_.node_count(); ++node) {
    if (poll.cancelled()) return context.cancel_status();
    if (!layout_.is_fixed[node]) free.push_back(node);
  }
  return ok_status();
}

Result<std::size_t> FieldSolver::gather(Context& context, const gather::GatherOptions& options,
                                        bool all) {
  if (all) {
    SFUMATO_TRY(list_free_nodes(context, memory_, to_gather_));
  }
  const std::size_t count = to_gather_.size();
  if (count > 0) {
    SFUMATO_TRY(field_.gatherer.gather(context, {layout_.position, to_gather_}, options,
                                       layout_.value, node_hit_, true, node_place_));
  }
  if (history_.is_logged) SFUMATO_TRY(memory_.append(context, to_gather_, gathered_));
  memory_.free(to_gather_);
  return count;
}

Status FieldSolver::find_misses(Context& context, const mesh::TriangleMesh& mesh,
                                std::span<const std::uint32_t> triangles, const MissLimit& limit,
                                std::span<std::uint8_t> misses) const {
  const MissSearch::Field searched{mesh, layout_, field_.attributes, field_.gatherer,
                                   sees_curves_everywhere()};
  return MissSearch(context, searched, limit).run(triangles, misses);
}

Status FieldSolver::find_coarse(Context& context, const mesh::TriangleMesh& mesh,
                                std::span<const std::uint32_t> triangles, double edge_per_radius,
                                std::span<std::uint8_t> coarse) {
  // Per vertex: the smallest blur radius of the curves that pass or end there; 0: no blurred curve.
  // Cuts change only its last bit.
  const std::size_t vertices = mesh.vertex_position.size();
  SFUMATO_TRY(memory_.grow(context, vertex_radius_, vertices, vertices / 4 * 5));
  const auto lower = [&](std::uint32_t vertex, float radius) {
    float& known = vertex_radius_[vertex];
    if (radius > 0) known = known > 0 ? std::min(known, radius) : radius;
  };
  RarePoll<16384> poll(context);
  for (const std::uint32_t t : triangles) {
    if (poll.cancelled()) return context.cancel_status();
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      if (!seams_->is_seam(h)) continue;
      lower(mesh.origin(h), seams_->blur_radius(h, 0));
      lower(mesh.target(h), seams_->blur_radius(h, 1));
    }
  }
  for (const std::uint32_t t : triangles) {
    if (poll.cancelled()) return context.cancel_status();
    double radius = 0;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      const double r = vertex_radius_[mesh.origin(h)];
      if (r > 0) radius = radius > 0 ? std::min(radius, r) : r;
    }
    if (radius > 0 && longest_edge(mesh, t) > edge_per_radius * radius) coarse[t] = 1;
  }
  return ok_status();
}

bool FieldSolver::sees_some(const std::uint32_t* node) const {
  const auto hit = [&](std::uint32_t n) { return node_hit_[n] != 0; };
  return std::any_of(node, node + kNodes, hit) && !std::all_of(node, node + kNodes, hit);
}

/// Reserves memory for the values that fill_unseen_nodes() adds.
Status FieldSolver::make_room_for_means(Context& context) {
  RarePoll<16384> poll(context);
  std::size_t count = 0;
  for (std::size_t first = 0; first < layout_.triangle_node.size(); first += kNodes) {
    if (poll.cancelled()) return context.cancel_status();
    count += sees_some(layout_.triangle_node.data() + first);
  }
  if (count == 0) return ok_status();
  const std::size_t values =
      layout_.value.size() + count * static_cast<std::size_t>(layout_.channel_count);
  return layout_memory_.reserve(context, layout_.value, values);
}

Status FieldSolver::fill_unseen_nodes(Context& context) {
  if (sees_curves_everywhere()) return ok_status();
  SFUMATO_TRY(make_room_for_means(context));
  RarePoll<16384> poll(context);
  const auto channels = static_cast<std::size_t>(layout_.channel_count);
  std::vector<float> sum(channels);
  for (std::size_t first = 0; first < layout_.triangle_node.size(); first += kNodes) {
    if (poll.cancelled()) return context.cancel_status();
    std::uint32_t* node = layout_.triangle_node.data() + first;
    if (!sees_some(node)) continue;
    std::fill(sum.begin(), sum.end(), 0.0f);
    std::size_t seen = 0;
    for (std::size_t i = 0; i < kNodes; ++i) {
      if (!node_hit_[node[i]]) continue;
      ++seen;
      for (std::size_t c = 0; c < channels; ++c) sum[c] += layout_.value[channels * node[i] + c];
    }
    const auto mean = static_cast<std::uint32_t>(layout_.value.size() / channels);
    for (float channel : sum) layout_.value.push_back(channel / static_cast<float>(seen));
    for (std::size_t i = 0; i < kNodes; ++i) {
      if (!node_hit_[node[i]]) node[i] = mean;
    }
  }
  return ok_status();
}

bool FieldSolver::sees_curves_everywhere() const {
  return node_hit_.empty() || std::memchr(node_hit_.data(), 0, node_hit_.size()) == nullptr;
}

bool FieldSolver::sees_curves(std::uint32_t triangle, std::size_t place) const {
  return node_hit_[layout_.triangle_node[kNodes * triangle + place]] != 0;
}

Status FieldSolver::look(Context& context, std::span<const Vec2> points,
                         std::span<std::uint8_t> seen) const {
  const auto channels = static_cast<std::size_t>(channel_count());
  TableMemory scratch("points at a border");
  std::vector<float> values;
  std::vector<std::uint8_t> hits;
  SFUMATO_TRY(scratch.resize(context, values, points.size() * channels));
  SFUMATO_TRY(scratch.resize(context, hits, points.size()));
  SFUMATO_TRY(field_.gatherer.gather(context, points, {}, values, hits));
  for (std::size_t i = 0; i < points.size(); ++i) seen[i] &= hits[i];
  return ok_status();
}

Status FieldSolver::add_parts(Context& context, const BorderCuts& cuts) {
  const auto channels = static_cast<std::size_t>(channel_count());
  const std::uint32_t first = layout_.node_count();
  const std::size_t nodes = first + cuts.point.size();
  TableMemory& memory = layout_memory_;
  SFUMATO_TRY(memory.append(context, cuts.point, layout_.position));
  SFUMATO_TRY(memory.make_room(context, layout_.triangle_node, cuts.node.size()));
  SFUMATO_TRY(memory.resize(context, layout_.is_fixed, nodes));
  SFUMATO_TRY(memory.resize(context, layout_.value, nodes * channels));
  SFUMATO_TRY(memory_.resize(context, node_hit_, nodes));
  SFUMATO_TRY(size_places(context));
  SFUMATO_TRY(memory_.resize(context, to_gather_, cuts.point.size()));
  std::iota(to_gather_.begin(), to_gather_.end(), first);
  for (std::size_t i = 0; i < cuts.node.size(); ++i) {
    const std::int32_t node = cuts.node[i];
    layout_.triangle_node.push_back(node < 0
                                        ? first + static_cast<std::uint32_t>(-1 - node)
                                        : layout_.triangle_node[kNodes * cuts.parent[i / kNodes] +
                                                                static_cast<std::size_t>(node)]);
  }
  return context.check();
}

float FieldSolver::largest_value(std::uint32_t triangle, std::size_t first_channel,
                                 float enough) const {
  const auto channels = static_cast<std::size_t>(layout_.channel_count);
  float largest = 0;
  for (std::size_t i = 0; i < kNodes && largest < enough; ++i) {
    const float* value =
        layout_.value.data() + channels * layout_.triangle_node[kNodes * triangle + i];
    for (std::size_t c = first_channel; c < channels; ++c) largest = std::max(largest, value[c]);
  }
  return std::min(largest, enough);
}

Result<PatchField> split_channel(const Context& context, PatchField& field, int channel,
                                 TableMemory& memory) {
  const auto channels = static_cast<std::size_t>(field.channel_count);
  const std::size_t node_count = field.node_value.size() / channels;
  PatchField split{1, {}, {}, {}};
  SFUMATO_TRY(memory.reserve(context, split.triangle_node, field.triangle_node.size()));
  SFUMATO_TRY(memory.append(context, field.triangle_node, split.triangle_node));
  SFUMATO_TRY(memory.resize(context, split.node_value, node_count));
  float* rest = field.node_value.data();
  for (std::size_t node = 0; node < node_count; ++node) {
    for (std::size_t c = 0; c < channels; ++c) {
      const float value = field.node_value[channels * node + c];
      if (c == static_cast<std::size_t>(channel)) {
        split.node_value[node] = value;
      } else {
        *rest++ = value;
      }
    }
  }
  field.node_value.resize((channels - 1) * node_count);
  --field.channel_count;
  return split;
}

Result<PatchField> FieldSolver::copy(const Context& context, std::span<const std::uint8_t> keep,
                                     TableMemory& memory) const {
  PatchField field{layout_.channel_count, {}, {}, field_.attributes.shader};
  const auto kept = static_cast<std::size_t>(std::ranges::count(keep, 1));
  // Later frames reuse these tables and need some room.
  const std::vector<float>& value = layout_.value;
  SFUMATO_TRY(memory.assign(context, value, field.node_value, value.size() / 8));
  if (kept == keep.size()) {
    const std::vector<std::uint32_t>& node = layout_.triangle_node;
    SFUMATO_TRY(memory.assign(context, node, field.triangle_node, node.size() / 8));

    return field;
  }
  SFUMATO_TRY(memory.reserve(context, field.triangle_node, kNodes * kept));
  for (std::size_t t = 0; t < keep.size(); ++t) {
    if (!keep[t]) continue;
    const std::uint32_t* const node = layout_.triangle_node.data() + kNodes * t;
    field.triangle_node.insert(field.triangle_node.end(), node, node + kNodes);
  }
  return field;
}

PatchField FieldSolver::take(std::span<const std::uint8_t> keep) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < keep.size(); ++t) {
    if (!keep[t]) continue;
    std::copy_n(layout_.triangle_node.data() + kNodes * t, kNodes,
                layout_.triangle_node.data() + kNodes * kept++);
  }
  layout_.triangle_node.resize(kNodes * kept);
  return {layout_.channel_count, std::move(layout_.triangle_node), std::move(layout_.value),
          field_.attributes.shader};
}

}  // namespace sfumato::solve
