#include "export/facets/facets.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include "base/half_edge.hpp"
#include "base/parallel.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"
#include "export/facets/facet_cuts.hpp"
#include "export/facets/facet_patch.hpp"
#include "export/facets/facet_tree.hpp"
#include "export/poll_interval.hpp"

namespace sfumato::outputs {
namespace {

constexpr std::size_t kTrianglesPerTask = 256;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Fills a FacetMesh from the cuts of its patches. Its vertices: corners, then the inner points of
/// edges, then points inside patches.
class FacetBuilder {
 public:
  FacetBuilder(const PatchLayer& layer, InterpolationSpace space, const FacetSource& source,
               double max_error, double smallest_side, const FacetCuts& cuts)
      : layer_(layer),
        space_(space),
        source_(source),
        max_error_(max_error),
        smallest_side_(smallest_side),
        cuts_(cuts) {}

  Status build(Context& context, FacetMesh* mesh);

 private:
  Status number_corners(Context& context);
  Status count(Context& context, FacetMesh* mesh);
  Status allocate(Context& context, FacetMesh* mesh) const;
  void fill(std::uint32_t triangle, FacetMesh* mesh) const;
  void set(std::uint32_t vertex, Vec2 position, const FacetPatch::Value& value,
           FacetMesh* mesh) const;
  void fill_edge(const FacetPatch& patch, std::uint32_t half_edge, FacetMesh* mesh) const;
  std::vector<std::uint32_t> vertices_of(std::uint32_t triangle, const FacetTree& tree) const;
  FacetTree tree_of(std::uint32_t triangle, const FacetPatch& patch) const;

  const PatchLayer& layer_;
  InterpolationSpace space_;
  const FacetSource& source_;
  double max_error_;
  double smallest_side_;
  const FacetCuts& cuts_;
  TableMemory memory_{"places of facets"};
  std::vector<std::uint32_t> corner_vertex_;  ///< 3 per triangle
  std::vector<std::uint32_t> corner_owner_;   ///< per corner vertex, a triangle's corner
  std::vector<std::uint64_t> edge_first_;     ///< first vertex of an edge
  std::vector<std::uint64_t> inside_first_;   ///< first vertex inside a patch; the last: how many
};

FacetTree FacetBuilder::tree_of(std::uint32_t triangle, const FacetPatch& patch) const {
  std::array<Vec2, 3> corner;
  for (std::size_t k = 0; k < 3; ++k)
    corner[k] = layer_.vertex_position[layer_.triangle_vertex[std::size_t{3} * triangle + k]];
  return {patch, cuts_.of(layer_, triangle), corner, smallest_side_};
}

/// Corners with one node at one vertex are one vertex of the mesh.
Status FacetBuilder::number_corners(Context& context) {
  const PatchField& field = field_of(layer_, source_);
  const std::size_t channels = static_cast<std::size_t>(field.channel_count);
  const std::size_t nodes = field.node_value.size() / channels;
  TableMemory node_memory("places of facets");
  std::vector<std::uint32_t> of_node;
  SFUMATO_TRY(node_memory.resize(context, of_node, nodes, kNone));
  SFUMATO_TRY(memory_.resize(context, corner_vertex_, layer_.triangle_vertex.size()));
  RarePoll<kTurnsPerPoll> poll(context);
  for (std::uint32_t corner = 0; corner < corner_vertex_.size(); ++corner) {
    if (poll.cancelled()) return context.cancel_status();
    std::uint32_t& vertex = of_node[field.triangle_node[node_slot(corner / 3, corner % 3)]];
    if (vertex == kNone ||
        layer_.triangle_vertex[corner_owner_[vertex]] != layer_.triangle_vertex[corner]) {
      vertex = static_cast<std::uint32_t>(corner_owner_.size());
      SFUMATO_TRY(memory_.push_back(context, corner_owner_, corner));
    }
    corner_vertex_[corner] = vertex;
  }
  return ok_status();
}

/// Counts facets and places vertices.
Status FacetBuilder::count(Context& context, FacetMesh* mesh) {
  const std::size_t triangles = layer_.triangle_count();
  TableMemory count_memory("places of facets");
  std::vector<std::uint32_t> facets, inside;
  SFUMATO_TRY(count_memory.resize_all(context, triangles, facets, inside));
  SFUMATO_TRY(memory_.reserve(context, edge_first_, cuts_.edge.size()));
  SFUMATO_TRY(memory_.reserve(context, inside_first_, triangles + 1));
  SFUMATO_TRY(mesh->memory.reserve(context, mesh->patch_first_facet, triangles + 1));
  SFUMATO_TRY(
      parallel_for(context, triangles, kTrianglesPerTask, [&](std::size_t begin, std::size_t end) {
        for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t) {
          const FacetPatch patch(layer_, space_, source_, t, max_error_);
          const FacetTree tree = tree_of(t, patch);
          facets[t] = static_cast<std::uint32_t>(tree.facets().size());
          inside[t] = static_cast<std::uint32_t>(tree.points().size() - tree.first_inside());
        }
      }));
  std::uint64_t vertex = corner_owner_.size();
  RarePoll<kTurnsPerPoll> poll(context);
  for (const FacetEdge& edge : cuts_.edge) {
    if (poll.cancelled()) return context.cancel_status();
    edge_first_.push_back(vertex);
    vertex += static_cast<unsigned>(std::popcount(edge.steps));
  }
  std::uint64_t facet = 0;
  for (std::size_t t = 0; t < triangles; ++t) {
    if (poll.cancelled()) return context.cancel_status();
    mesh->patch_first_facet.push_back(static_cast<std::uint32_t>(facet));
    inside_first_.push_back(vertex);
    facet += facets[t];
    vertex += inside[t];
  }
  mesh->patch_first_facet.push_back(static_cast<std::uint32_t>(facet));
  inside_first_.push_back(vertex);
  if (std::max(facet, vertex) >= kNone)
    return make_error(StatusCode::limit, "more facets than 32 bits can number");
  return ok_status();
}

Status FacetBuilder::allocate(Context& context, FacetMesh* mesh) const {
  const std::uint64_t vertices = inside_first_.back();
  const std::uint64_t facets = mesh->patch_first_facet.back();
  const auto channels = static_cast<std::size_t>(mesh->channel_count);
  TableMemory& memory = mesh->memory;
  SFUMATO_TRY(memory.resize(context, mesh->vertex_position, vertices));
  SFUMATO_TRY(memory.resize(context, mesh->vertex_value, vertices * channels));
  return memory.resize(context, mesh->facet_vertex, facets * 3);
}

void FacetBuilder::set(std::uint32_t vertex, Vec2 position, const FacetPatch::Value& value,
                       FacetMesh* mesh) const {
  mesh->vertex_position[vertex] = position;
  const auto channels = static_cast<std::size_t>(mesh->channel_count);
  for (std::size_t c = 0; c < channels; ++c)
    mesh->vertex_value[channels * vertex + c] = static_cast<float>(value[c]);
}

/// Points between the ends of an edge, from the lower vertex to the higher one, so that positions
/// on the two sides of a curve are the same bits too.
void FacetBuilder::fill_edge(const FacetPatch& patch, std::uint32_t half_edge,
                             FacetMesh* mesh) const {
  const std::uint32_t index = cuts_.edge_of[half_edge];
  const std::uint32_t next = next_half_edge(half_edge);
  const bool is_low = is_low_first(layer_, half_edge);
  const std::uint32_t low = is_low ? half_edge : next, high = is_low ? next : half_edge;
  auto vertex = static_cast<std::uint32_t>(edge_first_[index]);
  for (int step = 1; step < kEdgeSteps; ++step) {
    if ((cuts_.edge[index].steps >> step & 1) == 0) continue;
    const double t = 1.0 * step / kEdgeSteps;
    Barycentric at{};
    at[low % 3] = 1 - t;
    at[high % 3] = t;
    set(vertex++,
        lerp(layer_.vertex_position[layer_.triangle_vertex[low]],
             layer_.vertex_position[layer_.triangle_vertex[high]], t),
        patch.shown(at), mesh);
  }
}

/// Returns the mesh's vertices for the points of a patch.
std::vector<std::uint32_t> FacetBuilder::vertices_of(std::uint32_t triangle,
                                                     const FacetTree& tree) const {
  std::vector<std::uint32_t> vertex(tree.points().size());
  std::size_t point = 0;
  for (; point < 3; ++point) vertex[point] = corner_vertex_[std::size_t{3} * triangle + point];
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::uint32_t half_edge = 3 * triangle + k;
    const std::uint32_t index = cuts_.edge_of[half_edge];
    const auto first = static_cast<std::uint32_t>(edge_first_[index]);
    const auto count = static_cast<std::uint32_t>(std::popcount(cuts_.edge[index].steps));
    for (std::uint32_t i = 0; i < count; ++i)
      vertex[point++] = first + (is_low_first(layer_, half_edge) ? i : count - 1 - i);
  }
  auto inside = static_cast<std::uint32_t>(inside_first_[triangle]);
  for (; point < vertex.size(); ++point) vertex[point] = inside++;
  return vertex;
}

void FacetBuilder::fill(std::uint32_t triangle, FacetMesh* mesh) const {
  const FacetPatch patch(layer_, space_, source_, triangle, max_error_);
  const FacetTree tree = tree_of(triangle, patch);
  const std::vector<std::uint32_t> vertex = vertices_of(triangle, tree);
  const std::vector<Barycentric>& point = tree.points();
  Vec2 corner[3];
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::uint32_t half_edge = 3 * triangle + k;
    corner[k] = layer_.vertex_position[layer_.triangle_vertex[half_edge]];
    if (corner_owner_[vertex[k]] == half_edge)
      set(vertex[k], corner[k], patch.shown(point[k]), mesh);
    if (cuts_.edge[cuts_.edge_of[half_edge]].half_edge == half_edge)
      fill_edge(patch, half_edge, mesh);
  }
  for (std::size_t i = tree.first_inside(); i < point.size(); ++i) {
    const Barycentric& at = point[i];
    set(vertex[i], corner[0] * at[0] + corner[1] * at[1] + corner[2] * at[2], patch.shown(at),
        mesh);
  }
  std::uint32_t* facet =
      mesh->facet_vertex.data() + std::size_t{3} * mesh->patch_first_facet[triangle];
  for (const auto& points : tree.facets())
    for (std::uint32_t point_index : points) *facet++ = vertex[point_index];
}

Status FacetBuilder::build(Context& context, FacetMesh* mesh) {
  const std::size_t triangles = layer_.triangle_count();
  mesh->channel_count = channel_count_of(source_);
  SFUMATO_TRY(number_corners(context));
  SFUMATO_TRY(count(context, mesh));
  SFUMATO_TRY(allocate(context, mesh));
  return parallel_for(context, triangles, kTrianglesPerTask,
                      [&](std::size_t begin, std::size_t end) {
                        for (std::size_t t = begin; t < end; ++t)
                          fill(static_cast<std::uint32_t>(t), mesh);
                      });
}

}  // namespace

Result<FacetMesh> make_facets(Context& context, const PatchLayer& layer, InterpolationSpace space,
                              const FacetSource& source, double max_error, double smallest_side) {
  SFUMATO_TRY_ASSIGN(auto&& cuts,
                     find_cuts(context, layer, space, source, max_error, smallest_side));
  FacetMesh mesh;
  SFUMATO_TRY(
      FacetBuilder(layer, space, source, max_error, smallest_side, cuts).build(context, &mesh));
  return mesh;
}

}  // namespace sfumato::outputs
