#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "cli/commands.hpp"
#include "cli/document_input.hpp"
#include "cli/file_uses.hpp"
#include "cli/folder_loader.hpp"
#include "cli/interrupt.hpp"
#include "cli/paths.hpp"
#include "cli/templates.hpp"
#include "export/html/html_text.hpp"
#include "sfumato/base/native/file.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/formats/svg/svg_write.hpp"
#include "sfumato/import/import_svg.hpp"

namespace sfumato::cli {
namespace {

/// The <title> as the first of what stands in <svg>.
Result<std::string> with_title(const Context& context, std::string svg, std::string_view title) {
  if (title.empty()) return svg;
  const std::size_t end = svg.find('>', svg.find("<svg"));
  if (end == std::string::npos) return svg;
  const std::string element = "\n  <title>" + outputs::escaped_html(title) + "</title>";
  TableMemory memory("the new drawing");
  std::size_t charged = 0;
  Status status = memory.settle(context, capacity_bytes(svg), charged);
  if (status) status = memory.reserve(context, svg, svg.size() + element.size());
  if (!status) return status;
  return svg.insert(end + 1, element);
}

Result<std::string> imported(Context& context, const InitArguments& arguments) {
  const Result<std::string> bytes = read_drawing_text(context, arguments.input);
  if (!bytes) return bytes.status();
  ScopedCharge charge;
  Status status = charge.add(context, capacity_bytes(*bytes), "the input");
  if (!status) return status;
  const FolderLoader loader(arguments, context);
  const Result<ImportedSvg> made =
      import_svg(context, *bytes, display_name(arguments.input), &loader);
  if (!made) return made.status();
  if (!arguments.quiet) {
    for (const Diagnostic& warning : made->warnings) report_warning(warning);
  }
  status = charge.add(context, bytes_of(made->document), "the new drawing");
  if (!status) return status;
  Result<std::string> svg = write_svg(context, made->document);
  if (!svg) return svg;
  return with_title(context, std::move(*svg), made->title);
}

std::string template_text(std::string_view name) {
  for (const Template& known : templates()) {
    if (known.name == name) return std::string(known.document);
  }
  return std::string(templates().front().document);
}

Status write_start(Context& context, const InitArguments& arguments) {
  Result<std::string> svg = arguments.input.empty() ? template_text(arguments.template_name)
                                                    : imported(context, arguments);
  if (!svg) return svg.status();
  if (context.cancelled()) return context.cancel_status();
  return write_file(arguments.output,
                    {reinterpret_cast<const std::uint8_t*>(svg->data()), svg->size()}, &context);
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
    return make_error(StatusCode::io, "is there already; expected a new name, or --force",
                      {arguments.output, 0, 0});
  }
  return check_output(arguments.output);
}

}  // namespace

int init(const InitArguments& arguments) {
  const Status writable = check_new(arguments);
  if (!writable) return fail(writable);
  ThreadPool executor;
  Context context{.executor = &executor,
                  .budget = Budget(arguments.resources.memory_bytes),
                  .limits = arguments.resources.limits,
                  .deadline = deadline_of(arguments.resources)};
  const CancelOnSignal cancel_on_signal(context.cancel);
  const Status status = write_start(context, arguments);
  return status ? kDone : fail(status);
}

}  // namespace sfumato::cli
