#include "base/charge.hpp"
#include "cli/commands.hpp"
#include "cli/document_input.hpp"
#include "cli/drawing_file.hpp"
#include "cli/interrupt.hpp"
#include "cli/paths.hpp"
#include "sfumato/base/native/thread_pool.hpp"

namespace sfumato::cli {
namespace {

Status convert_document(Context& context, const ConvertArguments& arguments) {
  const Result<ReadDocument> read = read_drawing(context, arguments);
  if (!read) return read.status();
  ScopedCharge charge;
  Status status = charge.add(context, bytes_of(read->document), "the document");
  if (!status) return status;
  return write_drawing(context, read->document, arguments.output);
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
