#include "sfumato/lint/lint.hpp"

#include "base/try.hpp"
#include "cli/command_context.hpp"
#include "cli/commands/commands.hpp"
#include "cli/files/document_input.hpp"
#include "cli/files/paths.hpp"
#include "lint/hint_list.hpp"

namespace sfumato::cli {
namespace {

std::string counted(std::size_t count) {
  return count == 0 ? "no hints" : count == 1 ? "1 hint" : std::to_string(count) + " hints";
}

std::string as_text(const std::string& name, const Document& document,
                    const std::vector<Hint>& hints) {
  std::string text;
  for (const Hint& hint : hints) {
    text += output_line(name + ": " + (is_note(hint.kind) ? "note: " : "hint: ") +
                        place_text(document, hint) + ": " + hint.message + " [" +
                        std::string(hint_name(hint.kind)) + "]");
  }
  return text + output_line(name + ": " + counted(lint_detail::count_hints(hints)));
}

Result<std::string> as_json(const Context& context, const std::string& name,
                            const Document& document, const std::vector<Hint>& hints) {
  SFUMATO_TRY_ASSIGN(const auto& json, lint_detail::hints_json(context, name, document, hints));
  return std::string(json.begin(), json.end());
}

/// Prints the hints of arguments.input and returns their exit code.
int lint_one(Context& context, const LintArguments& arguments) {
  const std::string name = display_name(arguments.input);
  context.deadline = deadline_of(arguments.resources);
  const Result<ReadDocument> read = read_drawing(context, arguments);
  if (!read) return fail(naming(name, read.status()));
  Result<std::vector<Hint>> hints = sfumato::lint(context, read->document);
  if (!hints) return fail(naming(name, hints.status()));
  if (!arguments.verbose)
    std::erase_if(*hints, [](const Hint& hint) { return is_note(hint.kind); });
  const Result<std::string> text = arguments.json ? as_json(context, name, read->document, *hints)
                                                  : as_text(name, read->document, *hints);
  if (!text) return fail(naming(name, text.status()));
  const Status printed = print(*text, &context);
  if (!printed) return fail(printed);
  return arguments.strict && lint_detail::count_hints(*hints) > 0 ? kBadInput : kDone;
}

}  // namespace

int lint(const LintArguments& arguments) {
  CommandContext command(arguments.resources);
  Context& context = command.context();
  LintArguments one = arguments;
  int exit_code = kDone;
  for (const std::string& input : arguments.inputs) {
    if (exit_code >= kSignalled) break;
    if (context.cancel.load()) return fail(context.cancel_status());
    one.input = input;
    const int code = lint_one(context, one);
    // The exit code of the first drawing that failed; an interrupt takes precedence.
    if (exit_code == kDone || code >= kSignalled) exit_code = code;
  }
  return exit_code;
}

}  // namespace sfumato::cli
