#include "cli/document_input.hpp"

#include "cli/folder_loader.hpp"
#include "cli/paths.hpp"

namespace sfumato::cli {

Result<ReadDocument> read_drawing(Context& context, const DocumentArguments& arguments) {
  const Result<std::string> bytes = read_input(arguments.input, context.limits.input_bytes);
  if (!bytes) {
    Status status = bytes.status();
    if (status.code != StatusCode::limit) return status;
    return limit_error(context.limits, &Limits::input_bytes, "bytes of input", status.where);
  }
  ScopedCharge charge;
  if (Status status = charge.add(context, bytes->size(), "the input"); !status) return status;
  const FolderLoader loader(arguments.input, arguments.allowed_folders, context.limits);
  Result<ReadDocument> read =
      read_document(context, *bytes, display_name(arguments.input), &loader);
  if (!read || arguments.quiet) return read;
  for (const Status& warning : read->warnings) report_warning(warning);
  return read;
}

}  // namespace sfumato::cli
