#include "cli/commands/info_text.hpp"

#include <variant>

#include "base/text/number_text.hpp"
#include "cli/messages.hpp"
#include "document/names.hpp"
#include "picture/picture_counts.hpp"

namespace sfumato::cli {
namespace {

constexpr std::size_t kLabelWidth = 24;

/// Holds the counts of a solved picture's tables.
struct SolvedFacts {
  picture::PictureCounts tables;
  std::size_t soft_edges = 0;
  std::size_t instances = 0, local_curves = 0, groups = 0;
  std::size_t gradients = 0, textures = 0;
};

SolvedFacts count_facts(const Picture& picture) {
  SolvedFacts facts{.tables = picture::count_tables(picture)};
  for (const PatchLayer& layer : picture.layers) facts.soft_edges += layer.soft_edge.size();
  for (const PictureItem& item : picture.stack) {
    facts.instances += std::holds_alternative<PatchInstance>(item);
    facts.local_curves += std::holds_alternative<LocalStroke>(item);
    facts.groups += std::holds_alternative<GroupBegin>(item);
  }
  for (const Shader& shader : picture.shaders) {
    facts.textures += std::holds_alternative<Texture>(shader.paint);
  }
  facts.gradients = picture.shaders.size() - facts.textures;
  return facts;
}

std::string max_error_text(double max_error) {
  return max_error > 0 ? shortest(max_error) : "off";
}

std::string table_of(const std::string& name, const SolvedInput& solved, std::size_t bytes) {
  const SolvedFacts facts = count_facts(solved.picture);
  InfoTable table(name);
  const Picture& picture = solved.picture;
  const Vec2 own = solved.origin.own_scale;
  table.row("format", "solved picture, version " + std::to_string(kPictureFileVersion));
  table.count("bytes", bytes);
  table.row("artboard", size_text(picture.artboard));
  table.row("viewport", size_text(picture.viewport));
  table.row("size", shortest(picture.viewport.width() * own.x) + " x " +
                        shortest(picture.viewport.height() * own.y) + " px");
  table.row("solved for", shortest(solved.origin.pixels_per_unit) + " pixels per user unit");
  table.row("max-error", max_error_text(solved.origin.max_error));
  table.row("background", background_text(picture.background));
  table.row("interpolation", std::string(space_name(picture.interpolation)));
  table.row("layers", std::to_string(picture.layers.size()) + " (" +
                          std::to_string(facts.instances) +
                          (facts.instances == 1 ? " instance)" : " instances)"));
  table.count("groups", facts.groups);
  table.count("triangles", facts.tables.triangles);
  table.count("vertices", facts.tables.vertices);
  table.count("nodes", facts.tables.nodes);
  table.count("edges with fine blur", facts.soft_edges);
  table.count("local curves", facts.local_curves);
  table.count("gradients", facts.gradients);
  table.count("textures", facts.textures);
  return table.text();
}

std::string json_of(const std::string& name, const SolvedInput& solved, std::size_t bytes) {
  const SolvedFacts facts = count_facts(solved.picture);
  const Picture& picture = solved.picture;
  JsonWriter json;
  json.begin_object().member("file", name).member("format", "solved picture");
  json.member("version", int{kPictureFileVersion}).member("bytes", bytes);
  write_box(json, "artboard", picture.artboard);
  write_box(json, "viewport", picture.viewport);
  const Vec2 own = solved.origin.own_scale;
  write_size(json, {picture.viewport.width() * own.x, picture.viewport.height() * own.y});
  json.member("pixels_per_unit", solved.origin.pixels_per_unit)
      .member("max_error", solved.origin.max_error)
      .member("background", background_text(picture.background))
      .member("interpolation", space_name(picture.interpolation))
      .member("layers", picture.layers.size())
      .member("instances", facts.instances)
      .member("groups", facts.groups)
      .member("triangles", facts.tables.triangles)
      .member("vertices", facts.tables.vertices)
      .member("nodes", facts.tables.nodes)
      .member("soft_edges", facts.soft_edges)
      .member("local_curves", facts.local_curves)
      .member("gradients", facts.gradients)
      .member("textures", facts.textures)
      .end_object();
  return json.text() + '\n';
}

}  // namespace

InfoTable::InfoTable(const std::string& name) : text_(output_line(name)) {}

void InfoTable::row(std::string label, const std::string& content) {
  label.resize(kLabelWidth, ' ');
  text_ += "  " + label + content + '\n';
}

void write_box(JsonWriter& json, const char* key, const Box& box) {
  json.key(key)
      .begin_object()
      .member("x", box.min.x)
      .member("y", box.min.y)
      .member("width", box.width())
      .member("height", box.height())
      .end_object();
}

void write_size(JsonWriter& json, Vec2 size_px) {
  json.key("size_px").begin_object().member("width", size_px.x).member("height", size_px.y);
  json.end_object();
}

std::string shortest(double number) {
  return JsonWriter().value(number).text();
}

std::string size_text(const Box& box) {
  std::string text = shortest(box.width()) + " x " + shortest(box.height());
  if (!(box.min == Vec2{})) text += " at " + shortest(box.min.x) + "," + shortest(box.min.y);
  return text;
}

std::string background_text(const std::optional<Rgb>& background) {
  return background ? color_text(*background) : "none";
}

std::string solved_text(const std::string& name, const SolvedInput& solved, std::size_t bytes,
                        bool as_json) {
  return as_json ? json_of(name, solved, bytes) : table_of(name, solved, bytes);
}

}  // namespace sfumato::cli
