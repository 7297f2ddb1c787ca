#include "cli/commands/stats.hpp"

#include <cmath>

#include "base/text/json.hpp"

namespace sfumato::cli {

double to_nanosecond(double seconds) {
  return std::round(seconds * 1e9) / 1e9;
}

std::string to_json(const RenderStats& stats, std::string_view input) {
  JsonWriter json;
  json.begin_object();
  if (!input.empty()) json.member("input", input);
  json.member("curves", stats.diffuse.curves)
      .member("segments", stats.diffuse.segments)
      .member("triangles", stats.diffuse.triangles)
      .member("vertices", stats.diffuse.vertices)
      .member("nodes", stats.diffuse.nodes)
      .member("threads", stats.threads);
  if (stats.layers) {
    json.key("layers")
        .begin_object()
        .member("kept", stats.layers->kept)
        .member("continued", stats.layers->continued)
        .member("begun", stats.layers->begun)
        .end_object();
  }
  json.key("seconds")
      .begin_object()
      .member("read", to_nanosecond(stats.read_seconds))
      .member("geometry", to_nanosecond(stats.diffuse.geometry_seconds))
      .member("triangulation", to_nanosecond(stats.diffuse.triangulation_seconds))
      .member("gather", to_nanosecond(stats.diffuse.gather_seconds))
      .member("rasterise", to_nanosecond(stats.rasterise_seconds))
      .member("export", to_nanosecond(stats.export_seconds))
      .member("write", to_nanosecond(stats.write_seconds))
      .member("total", to_nanosecond(stats.total_seconds))
      .end_object()
      .end_object();
  return json.text() + '\n';
}

}  // namespace sfumato::cli
