#include <cstdio>
#include <string>

#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/document_facts.hpp"
#include "cli/commands/info_text.hpp"
#include "cli/files/document_input.hpp"
#include "cli/files/paths.hpp"
#include "cli/files/solved_input.hpp"
#include "cli/interrupt.hpp"
#include "document/names.hpp"

namespace sfumato::cli {
namespace {

const char* format_name(DocumentFormat format) {
  return format == DocumentFormat::orzan ? "Orzan XML" : "SVG";
}

Vec2 picture_size(const Document& document) {
  return document.size_px.value_or(Vec2{document.artboard.width(), document.artboard.height()});
}

std::string textures_text(const DocumentFacts& facts) {
  std::string text = std::to_string(facts.textures.size());
  for (const Texture* texture : facts.textures) {
    text += texture == facts.textures.front() ? " (" : ", ";
    text += std::to_string(texture->width) + " x " + std::to_string(texture->height);
  }
  return facts.textures.empty() ? text : text + ")";
}

std::string as_table(const std::string& name, const ReadDocument& read) {
  const DocumentFacts facts = count_facts(read.document);
  InfoTable table(name);
  table.row("format", format_name(read.format));
  table.row("artboard", size_text(read.document.artboard));
  const Vec2 size = picture_size(read.document);
  table.row("size", shortest(size.x) + " x " + shortest(size.y) + " px");
  table.row("background", background_text(read.document.background));
  table.row("interpolation", std::string(space_name(read.document.interpolation)));
  table.row("layers", std::to_string(facts.layers) + " (" + std::to_string(facts.instances) +
                          (facts.instances == 1 ? " instance)" : " instances)"));
  table.count("groups", facts.groups);
  table.row("curves", std::to_string(facts.curves) + " (" +
                          std::to_string(facts.curves - facts.closed_curves) + " open, " +
                          std::to_string(facts.closed_curves) + " closed)");
  table.count("  of colour", facts.color_curves);
  table.count("  of opacity", facts.opacity_curves);
  table.count("  of both", facts.both_curves);
  table.count("  barriers", facts.barrier_curves);
  table.count("  of nothing", facts.bare_curves);
  table.count("  with blur", facts.blurred_curves);
  table.count("  with a weight", facts.weighted_curves);
  table.count("  leaving the artboard", facts.leaving_curves);
  table.count("local curves", facts.local_curves);
  table.count("Bezier pieces", facts.bezier_pieces);
  table.count("control points", facts.control_points);
  table.count("colour stops", facts.color_stops);
  table.count("opacity stops", facts.opacity_stops);
  table.row("gradients", std::to_string(facts.linear_gradients + facts.radial_gradients) + " (" +
                             std::to_string(facts.linear_gradients) + " linear, " +
                             std::to_string(facts.radial_gradients) + " radial)");
  table.row("textures", textures_text(facts));
  table.count("warnings", warnings_of(read).size());
  return table.text();
}

void write_counts(JsonWriter& json, const DocumentFacts& facts) {
  json.member("layers", facts.layers)
      .member("instances", facts.instances)
      .member("groups", facts.groups)
      .member("curves", facts.curves)
      .member("open_curves", facts.curves - facts.closed_curves)
      .member("closed_curves", facts.closed_curves)
      .member("color_curves", facts.color_curves)
      .member("opacity_curves", facts.opacity_curves)
      .member("both_curves", facts.both_curves)
      .member("barrier_curves", facts.barrier_curves)
      .member("bare_curves", facts.bare_curves)
      .member("blurred_curves", facts.blurred_curves)
      .member("weighted_curves", facts.weighted_curves)
      .member("leaving_curves", facts.leaving_curves)
      .member("local_curves", facts.local_curves)
      .member("bezier_pieces", facts.bezier_pieces)
      .member("control_points", facts.control_points)
      .member("color_stops", facts.color_stops)
      .member("opacity_stops", facts.opacity_stops)
      .member("linear_gradients", facts.linear_gradients)
      .member("radial_gradients", facts.radial_gradients);
}

std::string as_json(const std::string& name, const ReadDocument& read) {
  const DocumentFacts facts = count_facts(read.document);
  JsonWriter json;
  json.begin_object().member("file", name).member("format", format_name(read.format));
  write_box(json, "artboard", read.document.artboard);
  write_size(json, picture_size(read.document));
  json.member("background", background_text(read.document.background))
      .member("interpolation", space_name(read.document.interpolation));
  write_counts(json, facts);
  json.key("textures").begin_array();
  for (const Texture* texture : facts.textures) {
    json.begin_object().member("width", texture->width).member("height", texture->height);
    json.end_object();
  }
  json.end_array().member("warnings", warnings_of(read).size()).end_object();
  return json.text() + '\n';
}

/// Returns the text to print about a drawing or a solved picture. The first bytes decide which it
/// is.
Result<std::string> text_of(Context& context, const InfoArguments& arguments,
                            const std::string& name) {
  SFUMATO_TRY_ASSIGN(const std::string& bytes, read_any_text(context, arguments.input));
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context, capacity_bytes(bytes), "the input"));
  if (is_solved(bytes)) {
    SFUMATO_TRY_ASSIGN(const SolvedInput& solved, read_solved(context, arguments.input, bytes));
    return solved_text(name, solved, bytes.size(), arguments.json);
  }
  SFUMATO_TRY_ASSIGN(const ReadDocument& read, read_drawing_of(context, arguments, bytes));
  return arguments.json ? as_json(name, read) : as_table(name, read);
}

}  // namespace

int info(const InfoArguments& arguments) {
  const std::string name = display_name(arguments.input);
  Context context{.budget = Budget(arguments.resources.memory_bytes),
                  .limits = arguments.resources.limits,
                  .deadline = deadline_of(arguments.resources)};
  const CancelOnSignal cancel_on_signal(context.cancel);
  const Result<std::string> text = text_of(context, arguments, name);
  if (!text) return fail(naming(arguments.input, text.status()));
  const Status printed = print(*text, &context);
  return printed ? kDone : fail(printed);
}

}  // namespace sfumato::cli
