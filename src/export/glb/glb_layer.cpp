#include "export/glb/glb_layer.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "export/facets/facets.hpp"
#include "export/joined_field.hpp"
#include "export/poll_interval.hpp"
#include "sfumato/base/color_space.hpp"

namespace sfumato::outputs {
namespace {

constexpr std::size_t kVerticesPerTask = 4096;

/// The input for facets of light.
Result<PatchLayer> light_layer(Context& context, const PatchLayer& layer, TableMemory& memory) {
  PatchLayer light;
  light.frame = layer.frame;
  light.order = layer.order;
  SFUMATO_TRY(memory.append(context, layer.vertex_position, light.vertex_position));
  SFUMATO_TRY(memory.append(context, layer.triangle_vertex, light.triangle_vertex));
  SFUMATO_TRY_ASSIGN(light.color, joined_field(context, layer.color, layer.opacity, memory));
  return light;
}

std::uint16_t share_of_16_bits(double value) {
  return static_cast<std::uint16_t>(std::lround(65535 * std::clamp(value, 0.0, 1.0)));
}

void add_vertex(GlbMesh& mesh, Vec2 p, Vec2 origin) {
  mesh.position.push_back(static_cast<float>(p.x - origin.x));
  mesh.position.push_back(static_cast<float>(origin.y - p.y));
  mesh.position.push_back(0);
}

/// Two triangles; corners from the upper left one on, clockwise on the screen.
GlbMesh box_mesh(const Box& box, Vec2 origin) {
  GlbMesh mesh;
  for (const Vec2 p : {box.min, Vec2{box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}) {
    add_vertex(mesh, p, origin);
  }
  mesh.index = {0, 2, 1, 0, 3, 2};
  return mesh;
}

}  // namespace

Result<GlbMesh> make_glb_layer(Context& context, const PatchLayer& layer, InterpolationSpace space,
                               Vec2 origin, double max_error, double smallest_side) {
  GlbMesh mesh;
  if (layer.triangle_count() == 0) return mesh;
  TableMemory copy("colours and opacity of a layer");
  const Result<PatchLayer> light = light_layer(context, layer, copy);
  SFUMATO_TRY(light);
  const FacetSource source{FacetSource::Kind::light, 0};
  SFUMATO_TRY_ASSIGN(const auto& facets,
                     make_facets(context, *light, space, source, max_error, smallest_side));
  const std::size_t vertices = facets.vertex_position.size();
  SFUMATO_TRY(mesh.memory.reserve(context, mesh.position, 3 * vertices));
  SFUMATO_TRY(mesh.memory.resize(context, mesh.color, 4 * vertices));
  SFUMATO_TRY(mesh.memory.reserve(context, mesh.index, facets.facet_vertex.size()));
  RarePoll<kTurnsPerPoll> poll(context);
  for (const Vec2 p : facets.vertex_position) {
    if (poll.cancelled()) return context.cancel_status();
    add_vertex(mesh, p, origin);
  }
  SFUMATO_TRY(
      parallel_for(context, vertices, kVerticesPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = 4 * begin; i < 4 * end; ++i) {
          const double value = facets.vertex_value[i];
          mesh.color[i] = share_of_16_bits(i % 4 == 3 ? value : linear_from_code(value));
        }
      }));
  // Turned over with the y axis, they run the other way.
  for (std::size_t i = 0; i < facets.facet_vertex.size(); i += 3) {
    if (poll.cancelled()) return context.cancel_status();
    const std::uint32_t* corner = facets.facet_vertex.data() + i;
    mesh.index.insert(mesh.index.end(), {corner[0], corner[2], corner[1]});
  }
  return mesh;
}

GlbMesh make_glb_box(const Box& box, Vec2 origin, const Rgb& color) {
  GlbMesh mesh = box_mesh(box, origin);
  for (int corner = 0; corner < 4; ++corner) {
    for (const float channel : {color.r, color.g, color.b}) {
      mesh.color.push_back(share_of_16_bits(linear_from_code(channel)));
    }
    mesh.color.push_back(65535);
  }
  return mesh;
}

GlbMesh make_glb_picture(const Box& box, Vec2 origin) {
  GlbMesh mesh = box_mesh(box, origin);
  mesh.texture = {0, 0, 1, 0, 1, 1, 0, 1};
  return mesh;
}

}  // namespace sfumato::outputs
