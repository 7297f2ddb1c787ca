#include "gather/rows_reference.hpp"

#include <algorithm>
#include <vector>

#include "base/half_edge.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"
#include "gather/gather_reference.hpp"
#include "gather/point_terms.hpp"
#include "gather/rows/row_sources.hpp"

namespace sfumato::gather {
namespace {

using mesh::TriangleMesh;

/// Returns where the ray cuts the edge, as a fraction from a to b.
double cut(Vec2 a, Vec2 b, Vec2 ray) {
  const double along = cross(ray, b - a);
  return along == 0 ? 0 : std::clamp(-cross(ray, a) / along, 0.0, 1.0);
}

class RowReference {
 public:
  RowReference(Context& context, const TriangleMesh& mesh, const Scene& scene,
               const RowSources& sources)
      : context_(context), poll_(context), mesh_(mesh), scene_(scene), terms_(sources) {
    code_.resize(mesh.triangle_vertex.size());
    for (std::size_t t = 0; t < scene.triangle.size(); ++t)
      std::ranges::copy(scene.triangle[t].edge, code_.begin() + 3 * scene.source[t]);
  }

  Status add(Vec2 p, float negligible, std::vector<RowTerm>& out) {
    const std::int32_t triangle = find_triangle(mesh_, p);
    if (triangle == mesh::kNone) return ok_status();
    p_ = p;
    terms_.begin(p);
    const std::uint32_t first = 3 * static_cast<std::uint32_t>(triangle);
    for (std::uint32_t h = first; h < first + 3; ++h)
      waiting_.push_back({h, seen(mesh_.origin(h)), seen(mesh_.target(h))});
    while (!waiting_.empty()) {
      if (poll_.cancelled()) return context_.cancel_status();
      const Window window = waiting_.back();
      waiting_.pop_back();
      follow(window);
    }
    terms_.add_ends();
    terms_.store(negligible, out);
    return ok_status();
  }

 private:
  /// Directions through a half-edge: from `right` to `left`, counter-clockwise.
  struct Window {
    std::uint32_t half_edge;
    Vec2 right, left;
  };

  Vec2 seen(std::uint32_t vertex) const { return mesh_.vertex_position[vertex] - p_; }

  void follow(const Window& window) {
    const EdgeCode code = code_[window.half_edge];
    if (is_hit(code)) return integrate(window, hit_index(code));
    if (code == kBorder) return;
    const auto twin = static_cast<std::uint32_t>(mesh_.half_edge_twin[window.half_edge]);
    const Vec2 apex = seen(mesh_.apex(twin));
    const bool reaches_right = cross(window.right, apex) > 0;
    const bool reaches_left = cross(apex, window.left) > 0;
    if (reaches_right) {
      waiting_.push_back({next_half_edge(twin), window.right, reaches_left ? apex : window.left});
    }
    if (reaches_left) {
      waiting_.push_back(
          {previous_half_edge(twin), reaches_right ? apex : window.right, window.left});
    }
  }

  void integrate(const Window& window, std::uint32_t source) {
    const Vec2 a = seen(mesh_.origin(window.half_edge));
    const Vec2 b = seen(mesh_.target(window.half_edge));
    const double from = window.right == a ? 0 : cut(a, b, window.right);
    const double to = window.left == b ? 1 : cut(a, b, window.left);
    const double k = scene_.hit_edge[source].weight;
    const PartMoment part = part_moment({a, b, from, to});
    terms_.add_varied(source, k, from, to, {k * part.weight, k * part.moment});
  }

  Context& context_;
  RarePoll<4096> poll_;
  const TriangleMesh& mesh_;
  const Scene& scene_;
  std::vector<EdgeCode> code_;  ///< per half-edge of the mesh
  Vec2 p_;
  std::vector<Window> waiting_;
  PointTerms terms_;
};

}  // namespace

Result<Rows> rows_reference(Context& context, const TriangleMesh& mesh,
                            const curves::SegmentAttributes& places, std::span<const Vec2> points,
                            const RowOptions& options) {
  SFUMATO_TRY_ASSIGN(const Scene& scene, build_scene(context, mesh, places));
  SFUMATO_TRY_ASSIGN(auto&& sources,
                     find_row_sources(context, mesh, places, scene, options.values));
  RowReference reference(context, mesh, scene, sources);
  Rows rows;
  std::vector<RowTerm> terms;
  rows.begin.push_back(0);
  for (const Vec2 p : points) {
    SFUMATO_TRY(reference.add(p, options.negligible, terms));
    rows.begin.push_back(static_cast<std::uint32_t>(terms.size()));
  }
  rows.term.assign(terms.begin(), terms.end());
  rows.source = std::move(sources.source);
  rows.memory.take(std::move(sources.memory));
  return rows;
}

}  // namespace sfumato::gather
