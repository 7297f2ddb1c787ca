#include "export/svg/svg_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "export/svg/svg_text.hpp"

namespace sfumato::outputs {
namespace {

constexpr std::uint32_t kFacetsPerPoll = 1024;
/// A facet with less difference than this in a channel has one value there.
constexpr double kFlat = 1.5 / 255;
/// A facet with less area, in squares of the grid, is also small.
constexpr double kSmallestArea = 1e-3;
/// Ends of a gradient are rounded to this share of its length or less: a quarter of a code value.
constexpr double kEndRounding = 1e-3;
/// A value that is affine in the plane: value + dot(slope, p - center).
struct Affinity {
  Vec2 center;
  double value = 0;
  Vec2 slope;
  bool is_flat = true;
};

float finite_share(float value) {
  return value > 0 ? std::min(value, 1.0f) : 0;  // NaN is 0
}

class SvgMeshWriter {
 public:
  SvgMeshWriter(const SvgMesh& mesh, const Ink& ink, SvgIds& ids)
      : mesh_(mesh), ink_(ink), ids_(ids) {}

  /// One channel of all facets, in their order.
  Status append(Context& context, int channel, OutputBuffer& text);

 private:
  /// The ground below small facets: the values of their centres.
  Status append_small(const Context& context, int channel, OutputBuffer& text) const;
  Affinity affinity(std::uint32_t facet, int channel) const;
  std::string gradient(const Affinity& field, std::string& text);

  const SvgMesh& mesh_;
  const Ink& ink_;
  SvgIds& ids_;
};

Affinity SvgMeshWriter::affinity(std::uint32_t facet, int channel) const {
  Vec2 p[3];
  double v[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t vertex = mesh_.mesh->facet_vertex[std::size_t{3} * facet + k];
    p[k] = mesh_.grid_from_layer(mesh_.mesh->vertex_position[vertex]);
    v[k] = finite_share(
        mesh_.mesh->vertex_value[vertex * static_cast<std::size_t>(mesh_.mesh->channel_count) +
                                 static_cast<std::size_t>(channel)]);
  }
  Affinity result{(p[0] + p[1] + p[2]) / 3, (v[0] + v[1] + v[2]) / 3, {}, true};
  const auto [low, high] = std::minmax({v[0], v[1], v[2]});
  const double area = cross(p[1] - p[0], p[2] - p[0]);
  if (high - low < kFlat || !(area > kSmallestArea)) return result;
  const Vec2 a = (p[2] - p[0]) * (v[1] - v[0]), b = (p[1] - p[0]) * (v[2] - v[0]);
  result.slope = Vec2{a.y - b.y, b.x - a.x} / area;
  result.is_flat = false;
  return result;
}

/// Writes a gradient from where the channel is 0 to where it is 1. Returns its id.
std::string SvgMeshWriter::gradient(const Affinity& field, std::string& text) {
  const Vec2 whole = field.slope / length_squared(field.slope);
  const Vec2 from = field.center - whole * field.value;
  const Vec2 to = from + whole;
  const int power = static_cast<int>(std::floor(std::log10(kEndRounding * length(whole))));
  std::string id = short_id(ids_.next++);
  text += "<linearGradient id=\"" + id + "\" xlink:href=\"#" + ink_.stops;
  const auto attribute = [&](const char* name, double value) {
    text += name;
    append_number(text, value, power);
  };
  attribute("\" x1=\"", from.x);
  attribute("\" y1=\"", from.y);
  attribute("\" x2=\"", to.x);
  attribute("\" y2=\"", to.y);
  text += "\"/>";
  return id;
}

void append_fill(double value, const Ink& ink, std::string& text) {
  const auto code = [&](int full) { return static_cast<int>(std::lround(value * full)); };
  text += "<path fill=\"";
  append_color(text, code(ink.full[0]), code(ink.full[1]), code(ink.full[2]));
}

Status SvgMeshWriter::append_small(const Context& context, int channel, OutputBuffer& text) const {
  if (mesh_.small.empty()) return ok_status();
  RarePoll<kFacetsPerPoll> poll(context);
  text += "<g" + mesh_.small_clip + ">\n";
  std::string line;
  for (const SmallFacet& small : mesh_.small) {
    if (poll.cancelled()) return context.cancel_status();
    std::array<Vec2, 3> corner = small.grown;
    for (Vec2& p : corner) p = mesh_.grid_from_layer(p);
    line.clear();
    append_fill(affinity(small.facet, channel).value, ink_, line);
    line += "\" d=\"";
    append_closed_path(line, corner);
    text += line += "\"/>\n";
    if (!text.status()) break;
  }
  text += "</g>\n";
  return text.status();
}

Status SvgMeshWriter::append(Context& context, int channel, OutputBuffer& text) {
  const auto count = static_cast<std::uint32_t>(mesh_.mesh->facet_vertex.size() / 3);
  SFUMATO_TRY(append_small(context, channel, text));
  std::vector<Vec2> outline;
  std::string path, line;
  RarePoll<kFacetsPerPoll> poll(context);
  for (std::uint32_t facet = 0; facet < count && text.status(); ++facet) {
    if (poll.cancelled()) return context.cancel_status();
    outline.clear();
    for (const Vec2 p : mesh_.outlines.of(facet)) outline.push_back(mesh_.grid_from_layer(p));
    path.clear();
    append_closed_path(path, outline);
    if (path.empty()) continue;
    const Affinity field = affinity(facet, channel);
    line.clear();
    if (field.is_flat) {
      append_fill(field.value, ink_, line);
    } else {
      const std::string id = gradient(field, line);
      line += "<path fill=\"url(#" + id + ")";
    }
    text += line += "\" d=\"" + path + "\"/>\n";
  }
  return text.status();
}

}  // namespace

Status append_channel(Context& context, const SvgMesh& mesh, int channel, const Ink& ink,
                      SvgIds& ids, OutputBuffer& text) {
  return SvgMeshWriter(mesh, ink, ids).append(context, channel, text);
}

void append_stops(const Ink& ink, OutputBuffer& text) {
  std::string line = std::string("<linearGradient id=\"") + ink.stops +
                     "\" gradientUnits=\"userSpaceOnUse\"><stop/><stop offset=\"1\" stop-color=\"";
  append_color(line, ink.full[0], ink.full[1], ink.full[2]);
  text += line += "\"/></linearGradient>\n";
}

}  // namespace sfumato::outputs
