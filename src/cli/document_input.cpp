#include "cli/document_input.hpp"

#include "cli/folder_loader.hpp"
#include "cli/paths.hpp"

namespace sfumato::cli {

Result<ReadDocument> read_given_document(Context& context, const DocumentArguments& arguments,
                                         const std::string& bytes) {
  const FolderLoader loader(arguments.input, arguments.allowed_folders);
  Result<ReadDocument> read = read_document(context, bytes, display_name(arguments.input), &loader);
  if (!read || arguments.quiet) return read;
  for (const Status& warning : read->warnings) report_warning(warning);
  return read;
}

}  // namespace sfumato::cli
