#include "cli/commands/info_text.hpp"

#include <variant>

#include "base/text/json.hpp"
#include "base/text/number_text.hpp"
#include "cli/messages.hpp"
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
  std::string table = output_line(name);
  const auto row = [&table](const char* label, const std::string& content) {
    table += table_row(label, content);
  };
  const auto count = [&row](const char* label, std::size_t number) {
    row(label, std::to_string(number));
  };
  const Picture& picture = solved.picture;
  const Vec2 own = solved.origin.own_scale;
  row("format", "solved picture, version " + std::to_string(kPictureFileVersion));
  count("bytes", bytes);
  row("artboard", size_text(picture.artboard));
  row("viewport", size_text(picture.viewport));
  row("size", shortest(picture.viewport.width() * own.x) + " x " +
                  shortest(picture.viewport.height() * own.y) + " px");
  row("solved for", shortest(solved.origin.pixels_per_unit) + " pixels per user unit");
  row("max-error", max_error_text(solved.origin.max_error));
  row("background", background_text(picture.background));
  row("interpolation", interpolation_name(picture.interpolation));
  row("layers", std::to_string(picture.layers.size()) + " (" + std::to_string(facts.instances) +
                    (facts.instances == 1 ? " instance)" : " instances)"));
  count("groups", facts.groups);
  count("triangles", facts.tables.triangles);
  count("vertices", facts.tables.vertices);
  count("nodes", facts.tables.nodes);
  count("edges with fine blur", facts.soft_edges);
  count("local curves", facts.local_curves);
  count("gradients", facts.gradients);
  count("textures", facts.textures);
  return table;
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

std::string json_of(const std::string& name, const SolvedInput& solved, std::size_t bytes) {
  const SolvedFacts facts = count_facts(solved.picture);
  const Picture& picture = solved.picture;
  JsonWriter json;
  json.begin_object().member("file", name).member("format", "solved picture");
  json.member("version", int{kPictureFileVersion}).member("bytes", bytes);
  write_box(json, "artboard", picture.artboard);
  write_box(json, "viewport", picture.viewport);
  json.key("size_px")
      .begin_object()
      .member("width", picture.viewport.width() * solved.origin.own_scale.x)
      .member("height", picture.viewport.height() * solved.origin.own_scale.y)
      .end_object();
  json.member("pixels_per_unit", solved.origin.pixels_per_unit)
      .member("max_error", solved.origin.max_error)
      .member("background", background_text(picture.background))
      .member("interpolation", interpolation_name(picture.interpolation))
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

std::string table_row(std::string label, const std::string& content) {
  label.resize(kLabelWidth, ' ');
  return "  " + label + content + '\n';
}

std::string shortest(double number) {
  return JsonWriter().value(number).text();
}

std::string size_text(const Box& box) {
  std::string text = shortest(box.width()) + " x " + shortest(box.height());
  if (!(box.min == Vec2{})) text += " at " + shortest(box.min.x) + "," + shortest(box.min.y);
  return text;
}

const char* interpolation_name(InterpolationSpace space) {
  constexpr const char* kNames[] = {"srgb", "linear", "oklab"};
  return kNames[static_cast<std::size_t>(space)];
}

std::string background_text(const std::optional<Rgb>& background) {
  return background ? color_text(*background) : "none";
}

std::string solved_text(const std::string& name, const SolvedInput& solved, std::size_t bytes,
                        bool as_json) {
  return as_json ? json_of(name, solved, bytes) : table_of(name, solved, bytes);
}

}  // namespace sfumato::cli
