#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "cli/command_context.hpp"
#include "cli/commands/commands.hpp"
#include "cli/embedded.hpp"
#include "cli/files/document_input.hpp"
#include "cli/files/file_uses.hpp"
#include "cli/files/folder_loader.hpp"
#include "cli/files/paths.hpp"
#include "export/html/html_text.hpp"
#include "sfumato/api/draw_document.hpp"
#include "sfumato/base/native/file.hpp"
#include "sfumato/formats/svg/svg_write.hpp"
#include "sfumato/import/import_svg.hpp"

namespace sfumato::cli {
namespace {

/// Returns the SVG with a <title> as the first child of <svg>.
Result<std::string> with_title(const Context& context, std::string svg, std::string_view title) {
  if (title.empty()) return svg;
  const std::size_t end = svg.find('>', svg.find("<svg"));
  if (end == std::string::npos) return svg;
  const std::string element = "\n  <title>" + outputs::escaped_html(title) + "</title>";
  TableMemory memory("the new drawing");
  std::size_t charged = 0;
  SFUMATO_TRY(memory.settle(context, capacity_bytes(svg), charged));
  SFUMATO_TRY(memory.reserve(context, svg, svg.size() + element.size()));
  return svg.insert(end + 1, element);
}

Result<std::string> imported(Context& context, const InitArguments& arguments) {
  SFUMATO_TRY_ASSIGN(const std::string& bytes, read_drawing_text(context, arguments.input));
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context, capacity_bytes(bytes), "the input"));
  const FolderLoader loader(arguments, context);
  SFUMATO_TRY_ASSIGN(const ImportedSvg& made,
                     import_svg(context, bytes, display_name(arguments.input), &loader,
                                [](auto&&... tile) { return draw_document(tile...); }));
  if (!arguments.quiet) {
    for (const Diagnostic& warning : made.warnings) report_warning(warning);
  }
  SFUMATO_TRY(charge.add(context, bytes_of(made.document), "the new drawing"));
  SFUMATO_TRY_ASSIGN(auto&& svg, write_svg(context, made.document));
  return with_title(context, std::move(svg), made.title);
}

Status write_start(Context& context, const InitArguments& arguments) {
  SFUMATO_TRY_ASSIGN(auto&& svg, arguments.input.empty()
                                     ? std::string(embedded_file(arguments.template_name + ".svg"))
                                     : imported(context, arguments));
  if (context.cancelled()) return context.cancel_status();
  return write_file(arguments.output,
                    {reinterpret_cast<const std::uint8_t*>(svg.data()), svg.size()}, &context);
}

Status check_new(const InitArguments& arguments) {
  if (arguments.output == "-") return ok_status();
  const auto there = file_identity(arguments.output, FileUse::writes);
  if (there && !arguments.input.empty() &&
      there == file_identity(arguments.input, FileUse::reads)) {
    return make_error(StatusCode::io, "the new drawing would replace what it is made of",
                      {arguments.output, 0, 0});
  }
  if (there && there->name.empty() && !arguments.force) {
    return make_error(StatusCode::io, "exists already; use a new name, or replace it with --force",
                      {arguments.output, 0, 0});
  }
  return check_output(arguments.output);
}

}  // namespace

int init(const InitArguments& arguments) {
  const Status writable = check_new(arguments);
  if (!writable) return fail(writable);
  CommandContext command(arguments, 0);
  command.context().deadline = deadline_of(arguments.resources);
  const Status status = write_start(command.context(), arguments);
  const std::string& named = arguments.input.empty() ? arguments.output : arguments.input;
  return status ? kDone : fail(naming(named, status));
}

}  // namespace sfumato::cli
