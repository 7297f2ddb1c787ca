#include <chrono>
#include <filesystem>
#include <string_view>
#include <thread>

#include "base/text/ascii.hpp"
#include "base/try.hpp"
#include "cli/commands/commands.hpp"
#include "cli/embedded.hpp"
#include "cli/files/document_input.hpp"
#include "cli/files/paths.hpp"
#include "cli/interrupt.hpp"
#include "cli/servers/browser.hpp"
#include "cli/servers/edit_server.hpp"
#include "sfumato/base/native/file.hpp"

namespace sfumato::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kSignalNap{200};  ///< between polls of signals
constexpr std::size_t kPageBytes = std::size_t{64} << 20;

/// Returns the editor as one file: from an installation, else from where `make editor` puts it
/// beside the command.
Result<std::string> editor_page() {
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  const fs::path installed = (folder / SFUMATO_SHARE_FROM_BIN / "editor.html").lexically_normal();
  for (const fs::path& path : {installed, folder / "editor.html"}) {
    if (fs::exists(path, error)) return read_file(path.string(), kPageBytes);
  }
  return make_error(StatusCode::io, "the editor's page is neither " + installed.string() +
                                        " nor beside the "
                                        "command; build it with `make editor`");
}

Status create(const std::string& path) {
  if (ascii_lower(path).ends_with(".svgz")) {
    return make_error(StatusCode::io, "does not exist; use a new name that ends in .svg",
                      {path, 0, 0});
  }
  const std::string_view blank = embedded_file("blank.svg");
  return write_file(path, {reinterpret_cast<const std::uint8_t*>(blank.data()), blank.size()});
}

/// Checks that the drawing can be read and written; creates it if it does not exist.
Status prepare(const EditArguments& arguments, const Context& context) {
  SFUMATO_TRY(check_output(arguments.input));
  std::error_code error;
  const fs::file_status target = fs::status(arguments.input, error);
  if (!fs::exists(target)) return create(arguments.input);
  if (!fs::is_regular_file(target)) {
    return make_error(StatusCode::bad_input, "is not a file", {arguments.input, 0, 0});
  }
  const auto bytes = read_file(arguments.input, context.limits.input_bytes);
  if (bytes && is_solved(*bytes)) return no_solved_picture("a drawing", arguments.input);
  return bytes ? ok_status() : bytes.status();
}

Status serve(const EditArguments& arguments, Context& context) {
  SFUMATO_TRY_ASSIGN(auto&& page, editor_page());
  SFUMATO_TRY(prepare(arguments, context));
  SFUMATO_TRY_ASSIGN(const auto& server, EditServer::start(arguments, context, std::move(page)));
  SFUMATO_TRY(print(server->address() + '\n'));
  if (arguments.opens_browser && !open_in_browser(server->address_for_once())) {
    report_warning({"no browser was found; open the address above", {}});
  }
  while (!context.cancel.load()) std::this_thread::sleep_for(kSignalNap);
  return context.cancel_status();
}

}  // namespace

int edit(const EditArguments& arguments) {
  Context context{.budget = Budget(arguments.resources.memory_bytes),
                  .limits = arguments.resources.limits};
  const CancelOnSignal cancel_on_signal(context.cancel);
  return fail(serve(arguments, context));
}

}  // namespace sfumato::cli
