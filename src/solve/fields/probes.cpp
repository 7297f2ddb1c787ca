#include "solve/fields/probes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/parallel.hpp"
#include "base/try.hpp"
#include "picture/patch.hpp"

namespace sfumato::solve {
namespace {

constexpr int kInnerKinds = kEdgePlace;
constexpr int kProbeKinds = kInnerKinds + 3;

/// Barycentric coordinates: the inner probes lie half way between the barycentre and a corner,
/// as far from all nodes as a point of the triangle can be; then the centres of edges 01, 12, 20.
constexpr std::array<std::array<double, 3>, kProbeKinds> kBarycentric{{
    {4.0 / 6, 1.0 / 6, 1.0 / 6},
    {1.0 / 6, 4.0 / 6, 1.0 / 6},
    {1.0 / 6, 1.0 / 6, 4.0 / 6},
    {0.5, 0.5, 0},
    {0, 0.5, 0.5},
    {0.5, 0, 0.5},
}};

using BasisTable = std::array<PatchBasis, kProbeKinds>;

constexpr BasisTable make_basis(PatchOrder order) {
  BasisTable table{};
  for (int i = 0; i < kProbeKinds; ++i) {
    table[i] = patch_basis(order, kBarycentric[i][0], kBarycentric[i][1], kBarycentric[i][2]);
  }
  return table;
}

const std::uint32_t* nodes_of(const NodeLayout& layout, std::uint32_t t) {
  return layout.triangle_node.data() + std::size_t{kNodesPerTriangle} * t;
}

int kind_of(const ProbeSet& probes, std::size_t i) {
  if (probes.place[i] < kInnerKinds) return probes.place[i];
  return kInnerKinds + static_cast<int>(probes.half_edge[i] % 3);
}

Vec2 point(const mesh::TriangleMesh& mesh, std::uint32_t t, int kind) {
  Vec2 sum;
  for (std::uint32_t k = 0; k < 3; ++k) {
    sum = sum + mesh.vertex_position[mesh.triangle_vertex[3 * t + k]] * kBarycentric[kind][k];
  }
  return sum;
}

}  // namespace

namespace {

/// Finds the place of each triangle's probes in the list, and puts them there.
class ProbePlacer {
 public:
  ProbePlacer(const Context& context, const mesh::TriangleMesh& mesh, const NodeLayout& layout,
              std::span<const std::uint32_t> triangles, std::span<const ProbeChoice> choice)
      : context_(context), mesh_(mesh), layout_(layout), triangles_(triangles), choice_(choice) {}

  Result<ProbeSet> run() {
    const std::size_t ranges = (triangles_.size() + kTrianglesPerTask - 1) / kTrianglesPerTask;
    SFUMATO_TRY(scratch_.resize(context_, asks_edges_, mesh_.triangle_count()));
    SFUMATO_TRY(scratch_.resize(context_, first_, ranges + 1));
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      asks_edges_[triangles_[i]] = chooses(choice_[i], kEdgePlace);
    Status status = for_each_range([&](std::size_t begin, std::size_t end) {
      std::size_t& count = first_[begin / kTrianglesPerTask + 1];
      for (std::size_t i = begin; i < end; ++i)
        for_each_probe(i, [&](std::uint32_t, int) { ++count; });
    });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    ProbeSet probes;
    if (status) {
      status = probes.memory.resize_all(context_, first_.back(), probes.position, probes.half_edge,
                                        probes.place);
    }
    if (status) status = fill(probes);
    if (!status) return status;
    return probes;
  }

 private:
  static constexpr std::size_t kTrianglesPerTask = 256;

  Status for_each_range(FunctionRef<void(std::size_t, std::size_t)> body) {
    return parallel_for(context_, triangles_.size(), kTrianglesPerTask, body);
  }

  Status fill(ProbeSet& probes) {
    return for_each_range([&](std::size_t begin, std::size_t end) {
      std::size_t i = first_[begin / kTrianglesPerTask];
      const auto put = [&](std::uint32_t half_edge, int place) {
        probes.half_edge[i] = half_edge;
        probes.place[i] = static_cast<std::uint8_t>(place);
        probes.position[i] = point(mesh_, half_edge / 3, kind_of(probes, i));
        ++i;
      };
      for (std::size_t k = begin; k < end; ++k) for_each_probe(k, put);
    });
  }

  static bool chooses(ProbeChoice choice, int place) { return (choice >> place & 1) != 0; }

  /// Calls visit(half_edge, place) for the probes that the triangle at this index has to place.
  template <class Visit>
  void for_each_probe(std::size_t index, Visit visit) const {
    const std::uint32_t t = triangles_[index];
    for (int place = 0; place < kInnerKinds; ++place) {
      if (chooses(choice_[index], place)) visit(3 * t, place);
    }
    if (!asks_edges_[t]) return;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      if (layout_.edge_is_curve[h]) continue;
      const std::int32_t twin = mesh_.half_edge_twin[h];
      const bool other_asks = twin != mesh::kNone &&
                              asks_edges_[static_cast<std::uint32_t>(twin) / 3] &&
                              static_cast<std::uint32_t>(twin) < h;
      if (!other_asks) visit(h, kEdgePlace);
    }
  }

  const Context& context_;
  const mesh::TriangleMesh& mesh_;
  const NodeLayout& layout_;
  std::span<const std::uint32_t> triangles_;
  std::span<const ProbeChoice> choice_;
  TableMemory scratch_{"probes of patches"};
  std::vector<std::uint8_t> asks_edges_;  ///< per triangle of the mesh
  std::vector<std::size_t> first_;        ///< per range of triangles_: its first probe
};

}  // namespace

Result<ProbeSet> place_probes(const Context& context, const mesh::TriangleMesh& mesh,
                              const NodeLayout& layout, std::span<const std::uint32_t> triangles,
                              std::span<const ProbeChoice> choice) {
  return ProbePlacer(context, mesh, layout, triangles, choice).run();
}

void patch_value_at_probe(const ProbeSet& probes, std::size_t i, const NodeLayout& layout,
                          PatchOrder order, float* value) {
  static constexpr std::array<BasisTable, 3> kBasis{make_basis(PatchOrder::linear),
                                                    make_basis(PatchOrder::quadratic),
                                                    make_basis(PatchOrder::cubic)};
  const auto& basis = kBasis[static_cast<std::size_t>(order)][kind_of(probes, i)];
  const std::uint32_t* node = nodes_of(layout, probes.half_edge[i] / 3);
  const auto channel_count = static_cast<std::size_t>(layout.channel_count);
  for (std::size_t channel = 0; channel < channel_count; ++channel) {
    double sum = 0;
    for (int n = 0; n < kNodesPerTriangle; ++n) {
      sum += basis[n] * layout.value[channel_count * node[n] + channel];
    }
    value[channel] = static_cast<float>(sum);
  }
}

// Cubic less quadratic (eq. 18 - 17) is 0 for every quadratic. Four of the ten values remain: an
// edge's cubic term t, with opposite signs seen from its ends, and the part of the center that
// edges and corners do not predict. At the inner probe near corner k the difference is center / 2 +
// (t of the edge that leaves k - t of the edge that enters k) / 8.
ProbeChoice foretell_miss(const NodeLayout& layout, std::uint32_t t, const MissFactors& factors,
                          float* miss) {
  const auto channel_count = static_cast<std::size_t>(layout.channel_count);
  const std::uint32_t* node = nodes_of(layout, t);
  float most = 0;
  ProbeChoice worst = kInnerProbes;
  for (std::size_t channel = 0; channel < channel_count; ++channel) {
    std::array<float, kNodesPerTriangle> value;
    for (std::size_t n = 0; n < value.size(); ++n)
      value[n] = layout.value[channel_count * node[n] + channel];
    float corners = 0, edges = 0;
    std::array<float, 3> term;
    for (std::size_t k = 0; k < term.size(); ++k) {
      const float near = value[near_node(k)], far = value[far_node(k)];
      corners += value[k];
      edges += near + far;
      term[k] = value[(k + 1) % 3] - value[k] + 3 * (near - far);
    }
    const float center = 0.5f * (value[kCenterNode] - 0.25f * edges + corners / 6);
    float cubic_part = 0;
    std::size_t corner = 0;
    for (std::size_t k = 0; k < term.size(); ++k) {
      const float difference = std::fabs(center + 0.125f * (term[k] - term[(k + 2) % 3]));
      if (difference > cubic_part) corner = k;
      cubic_part = std::max(cubic_part, difference);
    }
    float low = value[0], high = value[0];
    for (const float v : value) low = std::min(low, v), high = std::max(high, v);
    const float by_cubic = factors.per_cubic_part * cubic_part;
    const float by_range = factors.per_range * (high - low);
    miss[channel] = std::max(by_cubic, by_range);
    if (miss[channel] > most) {
      most = miss[channel];
      worst = by_cubic > by_range ? static_cast<ProbeChoice>(1 << corner) : kInnerProbes;
    }
  }
  return worst;
}

}  // namespace sfumato::solve
