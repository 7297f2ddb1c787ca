#include "sfumato/lint/lint.hpp"

#include <algorithm>

#include "base/json.hpp"
#include "cli/commands.hpp"
#include "cli/document_input.hpp"
#include "cli/interrupt.hpp"
#include "cli/paths.hpp"
#include "sfumato/base/native/thread_pool.hpp"

namespace sfumato::cli {
namespace {

std::string counted(std::size_t count) {
  return count == 0 ? "no hints" : count == 1 ? "1 hint" : std::to_string(count) + " hints";
}

std::size_t count_hints(const std::vector<Hint>& hints) {
  return static_cast<std::size_t>(
      std::ranges::count_if(hints, [](const Hint& hint) { return !is_note(hint.kind); }));
}

std::string as_text(const std::string& name, const Document& document,
                    const std::vector<Hint>& hints) {
  std::string text;
  for (const Hint& hint : hints) {
    text += output_line(name + ": " + (is_note(hint.kind) ? "note: " : "hint: ") +
                        place_text(document, hint) + ": " + hint.message + " [" +
                        std::string(hint_name(hint.kind)) + "]");
  }
  return text + output_line(name + ": " + counted(count_hints(hints)));
}

void write_place(JsonWriter& json, const Document& document, const Hint& hint) {
  if (hint.layer) {
    json.member("layer", *hint.layer).member("layer_id", document.layers[*hint.layer].id);
  }
  if (hint.curve) {
    json.member("curve", *hint.curve)
        .member("curve_id", document.layers[*hint.layer].curves[*hint.curve].id);
  }
  if (hint.side) json.member("side", *hint.side == CurveSide::left ? "left" : "right");
  if (hint.stack_item) json.member("stack_item", *hint.stack_item);
  if (hint.shader) {
    json.member("shader", *hint.shader).member("shader_id", document.shaders[*hint.shader].id);
  }
}

std::string as_json(const std::string& name, const Document& document,
                    const std::vector<Hint>& hints) {
  JsonWriter json;
  json.begin_object().member("file", name).key("hints").begin_array();
  for (const Hint& hint : hints) {
    json.begin_object().member("kind", hint_name(hint.kind));
    json.member("severity", is_note(hint.kind) ? "note" : "hint");
    write_place(json, document, hint);
    json.member("message", hint.message).end_object();
  }
  json.end_array().member("hint_count", count_hints(hints)).end_object();
  return json.text() + '\n';
}

/// The hints of arguments.input; its exit code.
int lint_one(Context& context, const LintArguments& arguments) {
  const std::string name = display_name(arguments.input);
  context.deadline = deadline_of(arguments.resources);
  const Result<ReadDocument> read = read_drawing(context, arguments);
  if (!read) return fail(read.status());
  Result<std::vector<Hint>> hints = sfumato::lint(context, read->document);
  if (!hints) return fail(hints.status());
  if (!arguments.verbose)
    std::erase_if(*hints, [](const Hint& hint) { return is_note(hint.kind); });
  const Status printed = print(arguments.json ? as_json(name, read->document, *hints)
                                              : as_text(name, read->document, *hints),
                               &context);
  if (!printed) return fail(printed);
  return arguments.strict && count_hints(*hints) > 0 ? kBadInput : kDone;
}

}  // namespace

int lint(const LintArguments& arguments) {
  ThreadPool executor;
  Context context{.executor = &executor,
                  .budget = Budget(arguments.resources.memory_bytes),
                  .limits = arguments.resources.limits};
  const CancelOnSignal cancel_on_signal(context.cancel);
  LintArguments one = arguments;
  int exit_code = kDone;
  for (const std::string& input : arguments.inputs) {
    if (exit_code >= kSignalled) break;
    if (context.cancel.load()) return fail(context.cancel_status());
    one.input = input;
    const int code = lint_one(context, one);
    // Of the first that failed; an interrupt goes before.
    if (exit_code == kDone || code >= kSignalled) exit_code = code;
  }
  return exit_code;
}

}  // namespace sfumato::cli
