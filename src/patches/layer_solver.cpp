#include "patches/layer_solver.hpp"

#include <algorithm>
#include <cmath>

#include "base/stopwatch.hpp"
#include "patches/patch.hpp"
#include "patches/probes.hpp"

namespace sfumato::patches {
namespace {

/// Each round halves a triangle that misses; the artboard is a few hundred smallest edges across.
constexpr int kMaxRounds = 12;

constexpr int kChannels = gather::kColorChannels;

Status check_limits(const mesh::TriangleMesh& mesh) {
  if (mesh.triangle_count() <= limits::kTriangles) return ok_status();
  return make_error(StatusCode::limit,
                    "more than " + std::to_string(limits::kTriangles) + " triangles");
}

constexpr std::size_t kBytesPerTriangle = 10 * sizeof(std::uint32_t) + 5 * 40 + 64;

}  // namespace

Result<PatchLayer> LayerSolver::solve() {
  const Stopwatch watch;
  if (Status status = scene_.mesher.refine(context_); !status) return status;
  if (stats_) stats_->triangulation_seconds += watch.seconds();
  // The exact gather decides where to refine; rays are shot once, on the mesh that comes of it.
  const bool refines = options_.max_error > 0;
  const std::uint64_t nodes_before = stats_ ? stats_->nodes : 0;
  const bool exact = options_.gather.method == gather::Method::exact;
  std::vector<std::uint32_t> missed;
  for (int round = 0;; ++round) {
    if (context_.progress) context_.progress->report("gather", round / double{kMaxRounds});
    if (Status status = next_mesh(); !status) return status;
    Status status = gather_free_nodes(refines ? gather::GatherOptions{} : options_.gather, false);
    if (!status) return status;
    if (!refines || round == kMaxRounds) break;
    status = find_misses(missed);
    if (!status) return status;
    if (missed.empty()) break;
    const Stopwatch refine_watch;
    status = scene_.mesher.refine_triangles(context_, missed, scene_.smallest_edge);
    if (!status) return status;
    if (stats_) stats_->triangulation_seconds += refine_watch.seconds();
  }
  if (refines && !exact) {
    if (stats_) stats_->nodes = nodes_before;
    if (Status status = gather_free_nodes(options_.gather, true); !status) return status;
  }
  drop_unseen_triangles();
  color_unseen_nodes();
  return take_patches();
}

/// Takes the mesher's present mesh, lays out its nodes and carries known values over from the
/// triangles that stayed.
Status LayerSolver::next_mesh() {
  const Stopwatch watch;
  const NodeLayout old_layout = std::move(layout_);
  const std::vector<std::uint8_t> old_hit = std::move(node_hit_);
  mesh_ = scene_.mesher.patch_mesh(&previous_triangle_);
  if (Status status = check_limits(mesh_); !status) return status;
  ScopedCharge charge;
  if (Status status = charge.add(context_, mesh_.triangle_count() * kBytesPerTriangle, "patches");
      !status) {
    return status;
  }
  layout_ = lay_out_nodes(mesh_, scene_.attributes);
  node_known_ = layout_.is_fixed;
  node_hit_.assign(layout_.node_count(), 1);
  for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
    if (old_layout.triangle_node.empty() || previous_triangle_[t] == mesh::kNone) continue;
    const auto p = static_cast<std::size_t>(previous_triangle_[t]);
    for (std::size_t i = 0; i < kNodesPerTriangle; ++i) {
      const std::uint32_t node = layout_.triangle_node[kNodesPerTriangle * t + i];
      if (node_known_[node]) continue;
      const std::uint32_t old = old_layout.triangle_node[kNodesPerTriangle * p + i];
      std::copy_n(old_layout.value.begin() + kChannels * old, kChannels,
                  layout_.value.begin() + kChannels * std::size_t{node});
      node_hit_[node] = old_hit[old];
      node_known_[node] = 1;
    }
  }
  if (stats_) stats_->triangulation_seconds += watch.seconds();
  return ok_status();
}

/// Gathers the free nodes whose value is not known yet, or all of them.
Status LayerSolver::gather_free_nodes(const gather::GatherOptions& options, bool all) {
  const Stopwatch watch;
  std::vector<std::uint32_t> nodes;
  std::vector<Vec2> points;
  for (std::uint32_t node = 0; node < layout_.node_count(); ++node) {
    if (layout_.is_fixed[node] || (node_known_[node] && !all)) continue;
    nodes.push_back(node);
    points.push_back(layout_.position[node]);
  }
  std::vector<float> values(points.size() * kChannels);
  std::vector<std::uint8_t> hits(points.size());
  Status status = scene_.gatherer.gather(context_, points, options, values, hits);
  if (!status) return status;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(kChannels * i), kChannels,
                layout_.value.begin() + kChannels * std::size_t{nodes[i]});
    node_hit_[nodes[i]] = hits[i];
  }
  if (stats_) {
    stats_->nodes += nodes.size();
    stats_->gather_seconds += watch.seconds();
  }
  return ok_status();
}

/// Triangles new in this round whose patch misses the exact gather by more than max_error.
Status LayerSolver::find_misses(std::vector<std::uint32_t>& missed) {
  const Stopwatch watch;
  std::vector<std::uint8_t> is_new(mesh_.triangle_count());
  for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
    is_new[t] = previous_triangle_[t] == mesh::kNone;
  }
  const ProbeSet probes = place_probes(mesh_, layout_, is_new);
  std::vector<float> exact(probes.position.size() * kChannels);
  const gather::GatherOptions options;
  Status status = scene_.gatherer.gather(context_, probes.position, options, exact);
  if (!status) return status;
  std::vector<std::uint8_t> misses(mesh_.triangle_count(), 0);
  const auto limit = static_cast<float>(options_.max_error / 255);
  for (std::size_t i = 0; i < probes.position.size(); ++i) {
    float color[kChannels];
    patch_color_at_probe(probes, i, layout_, options_.order, color);
    float worst = 0;
    for (int c = 0; c < kChannels; ++c) {
      worst = std::max(worst, std::fabs(color[c] - exact[kChannels * i + c]));
    }
    if (worst <= limit) continue;
    misses[probes.half_edge[i] / 3] = 1;
    const std::int32_t twin = mesh_.half_edge_twin[probes.half_edge[i]];
    if (probes.place[i] == 3 && twin != mesh::kNone) misses[twin / 3] = 1;
  }
  missed.clear();
  for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
    if (misses[t]) missed.push_back(t);
  }
  if (stats_) stats_->gather_seconds += watch.seconds();
  return ok_status();
}

/// A region from which no curve is seen is transparent: it has no triangles.
void LayerSolver::drop_unseen_triangles() {
  std::uint32_t kept = 0;
  for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
    const std::size_t centre = kNodesPerTriangle * std::size_t{t} + 9;
    if (!node_hit_[layout_.triangle_node[centre]]) continue;
    std::copy_n(mesh_.triangle_vertex.begin() + 3 * std::size_t{t}, 3,
                mesh_.triangle_vertex.begin() + 3 * std::size_t{kept});
    std::copy_n(layout_.edge_is_curve.begin() + 3 * std::size_t{t}, 3,
                layout_.edge_is_curve.begin() + 3 * std::size_t{kept});
    std::copy_n(layout_.triangle_node.begin() + kNodesPerTriangle * std::size_t{t},
                kNodesPerTriangle,
                layout_.triangle_node.begin() + kNodesPerTriangle * std::size_t{kept});
    ++kept;
  }
  mesh_.triangle_vertex.resize(std::size_t{3} * kept);
  layout_.edge_is_curve.resize(std::size_t{3} * kept);
  layout_.triangle_node.resize(std::size_t{kNodesPerTriangle} * kept);
}

/// Where a triangle lies across the border of what sees a curve, its nodes beyond the border have
/// no colour: in this triangle they take the mean of the others.
void LayerSolver::color_unseen_nodes() {
  for (std::size_t first = 0; first < layout_.triangle_node.size(); first += kNodesPerTriangle) {
    std::uint32_t* node = layout_.triangle_node.data() + first;
    float sum[kChannels] = {};
    int seen = 0;
    for (int i = 0; i < kNodesPerTriangle; ++i) {
      if (!node_hit_[node[i]]) continue;
      ++seen;
      for (int c = 0; c < kChannels; ++c) sum[c] += layout_.value[kChannels * node[i] + c];
    }
    if (seen == kNodesPerTriangle) continue;
    const auto mean = static_cast<std::uint32_t>(layout_.value.size() / kChannels);
    for (float channel : sum) layout_.value.push_back(channel / static_cast<float>(seen));
    for (int i = 0; i < kNodesPerTriangle; ++i) {
      if (!node_hit_[node[i]]) node[i] = mean;
    }
  }
}

PatchLayer LayerSolver::take_patches() {
  PatchLayer layer;
  layer.frame = scene_.frame;
  layer.order = options_.order;
  layer.vertex_position = std::move(mesh_.vertex_position);
  layer.triangle_vertex = std::move(mesh_.triangle_vertex);
  layer.edge_is_curve = std::move(layout_.edge_is_curve);
  layer.color = {kChannels, std::move(layout_.triangle_node), std::move(layout_.value), {}};
  if (stats_) {
    stats_->triangles += layer.triangle_count();
    stats_->vertices += layer.vertex_position.size();
  }
  return layer;
}

}  // namespace sfumato::patches
