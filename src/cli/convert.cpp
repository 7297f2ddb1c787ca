#include <span>

#include "base/charge.hpp"
#include "cli/commands.hpp"
#include "cli/document_input.hpp"
#include "cli/interrupt.hpp"
#include "cli/paths.hpp"
#include "sfumato/base/native/file.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/formats/svg/svg_write.hpp"

namespace sfumato::cli {
namespace {

Status convert_document(Context& context, const ConvertArguments& arguments) {
  const Result<ReadDocument> read = read_drawing(context, arguments);
  if (!read) return read.status();
  ScopedCharge charge;
  Status status = charge.add(context, bytes_of(read->document), "the document");
  if (!status) return status;
  const Result<std::string> svg = write_svg(context, read->document);
  if (!svg) return svg.status();
  if (context.cancelled()) return context.cancel_status();
  return write_file(arguments.output,
                    {reinterpret_cast<const std::uint8_t*>(svg->data()), svg->size()}, &context);
}

}  // namespace

int convert(const ConvertArguments& arguments) {
  const Status writable = check_output(arguments.output);
  if (!writable) return fail(writable);
  ThreadPool executor;
  Context context{.executor = &executor,
                  .budget = Budget(arguments.resources.memory_bytes),
                  .limits = arguments.resources.limits,
                  .deadline = deadline_of(arguments.resources)};
  const CancelOnSignal cancel_on_signal(context.cancel);
  const Status status = convert_document(context, arguments);
  return status ? kDone : fail(status);
}

}  // namespace sfumato::cli
