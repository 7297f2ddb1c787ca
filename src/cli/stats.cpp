#include "cli/stats.hpp"

#include "cli/json.hpp"

namespace sfumato::cli {

std::string to_json(const RenderStats& stats) {
  JsonWriter json;
  json.begin_object()
      .member("curves", stats.diffuse.curves)
      .member("segments", stats.diffuse.segments)
      .member("triangles", stats.diffuse.triangles)
      .member("vertices", stats.diffuse.vertices)
      .member("nodes", stats.diffuse.nodes)
      .member("threads", stats.threads);
  json.key("seconds")
      .begin_object()
      .member("read", stats.read_seconds)
      .member("geometry", stats.diffuse.geometry_seconds)
      .member("triangulation", stats.diffuse.triangulation_seconds)
      .member("gather", stats.diffuse.gather_seconds)
      .member("rasterise", stats.rasterise_seconds)
      .member("write", stats.write_seconds)
      .member("total", stats.total_seconds)
      .end_object()
      .end_object();
  return json.text() + '\n';
}

}  // namespace sfumato::cli
