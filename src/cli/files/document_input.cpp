#include "cli/files/document_input.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "base/charge.hpp"
#include "base/limit_error.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "cli/files/folder_loader.hpp"
#include "cli/files/paths.hpp"
#include "sfumato/picture/picture_file.hpp"

namespace sfumato::cli {
namespace {

/// Input from a pipe is read into a buffer that doubles: the old and the new one exist at once.
constexpr std::size_t kBytesPerPipedByte = 3;

/// Returns whether the input was longer than allowed, or the time ran out.
bool is_too_long(const Result<std::string>& read) {
  return read.status().code == StatusCode::limit && !is_lack_of_memory(read.status());
}

/// Returns whether the path is a regular file that begins as a solved picture does.
bool begins_solved(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;
  std::string begin(64, '\0');
  std::ifstream(path, std::ios::binary).read(begin.data(), 64);
  return is_solved(begin);
}

}  // namespace

Result<std::string> read_up_to(Context& context, const std::string& path, std::size_t most) {
  const std::size_t room = context.budget.room();
  const std::size_t readable = path == "-" ? room / kBytesPerPipedByte : room;
  Result<std::string> bytes = read_input(context, path, std::min(most, readable));
  if (bytes || bytes.status().code != StatusCode::limit) return bytes;
  if (context.cancelled()) return context.cancel_status();
  if (readable < most) return context.budget.charge(room + 1, "the input");
  return bytes;
}

Result<std::string> read_within(Context& context, const std::string& path,
                                std::size_t Limits::*limit, std::string_view what) {
  Result<std::string> bytes = read_up_to(context, path, context.limits.*limit);
  if (!is_too_long(bytes)) return bytes;
  if (context.cancelled()) return context.cancel_status();
  return limit_error(context.limits, limit, what, bytes.status().where);
}

/// Reads a drawing or a solved picture. A file that is too long for a drawing may be a solved
/// picture. A pipe is not read twice.
Result<std::string> read_any_text(Context& context, const std::string& path) {
  Result<std::string> bytes = read_within(context, path, &Limits::input_bytes, "bytes of input");
  if (!is_too_long(bytes) || !begins_solved(path)) return bytes;
  if (context.cancelled()) return context.cancel_status();
  return read_up_to(context, path, kPictureFileFactor * context.limits.input_bytes);
}

bool is_solved(const std::string& bytes) {
  return is_picture_file({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

Status no_solved_picture(std::string_view expected, const std::string& path) {
  return make_error(StatusCode::bad_input,
                    "this is a solved picture; use " + std::string(expected) +
                        " (`sfumato render` draws solved pictures, `sfumato info` describes them)",
                    {display_name(path)});
}

Result<std::string> read_drawing_text(Context& context, const std::string& path) {
  Result<std::string> bytes = read_any_text(context, path);
  if (bytes && is_solved(*bytes)) return no_solved_picture("a drawing", path);
  return bytes;
}

Result<ReadDocument> read_drawing(Context& context, const DocumentArguments& arguments) {
  SFUMATO_TRY_ASSIGN(const std::string& bytes, read_drawing_text(context, arguments.input));
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context, capacity_bytes(bytes), "the input"));
  return read_drawing_of(context, arguments, bytes);
}

Result<ReadDocument> read_drawing_of(Context& context, const DocumentArguments& arguments,
                                     const std::string& bytes) {
  const FolderLoader loader(arguments, context);
  Result<ReadDocument> read = read_document(context, bytes, display_name(arguments.input), &loader);
  if (!read || arguments.quiet) return read;
  for (const Diagnostic& warning : warnings_of(*read)) report_warning(warning);
  return read;
}

std::vector<Diagnostic> warnings_of(const ReadDocument& read) {
  std::vector<Diagnostic> warnings = read.warnings;
  if (read.is_foreign && !warnings.empty()) {
    warnings.push_back(
        {"to make curves from an ordinary SVG, use `sfumato init --from IN.svg OUT.svg`",
         {warnings.front().where.file}});
  }
  return warnings;
}

}  // namespace sfumato::cli
