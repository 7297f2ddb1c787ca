#include <cstdio>
#include <string>

#include "base/native/tbb_executor.hpp"
#include "cli/commands.hpp"
#include "cli/document_facts.hpp"
#include "cli/folder_loader.hpp"
#include "cli/interrupt.hpp"
#include "cli/json.hpp"
#include "cli/paths.hpp"
#include "formats/read_document.hpp"

namespace sfumato::cli {
namespace {

const char* format_name(DocumentFormat format) {
  return format == DocumentFormat::orzan ? "Orzan XML" : "SVG";
}

std::string shortest(double number) {
  return JsonWriter().value(number).text();
}

std::string size_text(const Box& artboard) {
  std::string text = shortest(artboard.width()) + " x " + shortest(artboard.height());
  if (!(artboard.min == Vec2{})) {
    text += " at " + shortest(artboard.min.x) + "," + shortest(artboard.min.y);
  }
  return text;
}

std::string as_table(const std::string& name, const ReadDocument& read) {
  const DocumentFacts facts = count_facts(read.document);
  std::string table = name + '\n';
  const auto row = [&table](std::string label, const std::string& content) {
    label.resize(24, ' ');
    table += "  " + label + content + '\n';
  };
  row("format", format_name(read.format));
  row("artboard", size_text(read.document.artboard));
  row("layers", std::to_string(facts.layers));
  row("curves", std::to_string(facts.curves) + " (" +
                    std::to_string(facts.curves - facts.closed_curves) + " open, " +
                    std::to_string(facts.closed_curves) + " closed)");
  row("Bezier pieces", std::to_string(facts.bezier_pieces));
  row("control points", std::to_string(facts.control_points));
  row("colour stops", std::to_string(facts.color_stops));
  row("curves with blur", std::to_string(facts.blurred_curves));
  row("leaving the artboard", std::to_string(facts.leaving_curves));
  row("warnings", std::to_string(read.warnings.size()));
  return table;
}

std::string as_json(const std::string& name, const ReadDocument& read) {
  const DocumentFacts facts = count_facts(read.document);
  const Box& artboard = read.document.artboard;
  JsonWriter json;
  json.begin_object().member("file", name).member("format", format_name(read.format));
  json.key("artboard")
      .begin_object()
      .member("x", artboard.min.x)
      .member("y", artboard.min.y)
      .member("width", artboard.width())
      .member("height", artboard.height())
      .end_object();
  json.member("layers", facts.layers)
      .member("curves", facts.curves)
      .member("open_curves", facts.curves - facts.closed_curves)
      .member("closed_curves", facts.closed_curves)
      .member("bezier_pieces", facts.bezier_pieces)
      .member("control_points", facts.control_points)
      .member("color_stops", facts.color_stops)
      .member("blurred_curves", facts.blurred_curves)
      .member("leaving_curves", facts.leaving_curves)
      .member("warnings", read.warnings.size())
      .end_object();
  return json.text() + '\n';
}

}  // namespace

int info(const InfoArguments& arguments) {
  const Result<std::string> input = read_input(arguments.input, limits::kInputBytes);
  if (!input) return fail(input.status());
  const std::string name = display_name(arguments.input);
  Context context;
  const CancelOnSignal cancel_on_signal(context.cancel);
  const FolderLoader loader(arguments.input);
  const Result<ReadDocument> read = read_document(context, *input, name, &loader);
  if (!read) return fail(read.status());
  if (!arguments.quiet) {
    for (const Status& warning : read->warnings) report_warning(warning);
  }
  const Status printed = print(arguments.json ? as_json(name, *read) : as_table(name, *read));
  return printed ? kDone : fail(printed);
}

}  // namespace sfumato::cli
