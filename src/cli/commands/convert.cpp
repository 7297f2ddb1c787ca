#include "base/charge.hpp"
#include "base/try.hpp"
#include "cli/command_context.hpp"
#include "cli/commands/commands.hpp"
#include "cli/files/document_input.hpp"
#include "cli/files/drawing_file.hpp"
#include "cli/files/paths.hpp"

namespace sfumato::cli {
namespace {

Status convert_document(Context& context, const ConvertArguments& arguments) {
  SFUMATO_TRY_ASSIGN(const ReadDocument& read, read_drawing(context, arguments));
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context, bytes_of(read.document), "the document"));
  return write_drawing(context, read.document, arguments.output);
}

}  // namespace

int convert(const ConvertArguments& arguments) {
  const Status writable = check_output(arguments.output);
  if (!writable) return fail(writable);
  CommandContext command(arguments.resources);
  command.context().deadline = deadline_of(arguments.resources);
  const Status status = convert_document(command.context(), arguments);
  return status ? kDone : fail(naming(arguments.input, status));
}

}  // namespace sfumato::cli
