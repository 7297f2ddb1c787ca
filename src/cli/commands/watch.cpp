#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "base/charge.hpp"
#include "base/limit_error.hpp"
#include "base/stopwatch.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "cli/command_context.hpp"
#include "cli/commands/commands.hpp"
#include "cli/files/document_input.hpp"
#include "cli/files/folder_loader.hpp"
#include "cli/files/paths.hpp"
#include "cli/files/picture_file.hpp"
#include "cli/servers/file_watch.hpp"
#include "cli/servers/watch_server.hpp"
#include "sfumato/base/native/file.hpp"

namespace sfumato::cli {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kWatchNap{500};  ///< between polls of signals
constexpr milliseconds kQuiet{40};      ///< without a change: the writer is done
constexpr int kMostQuiets = 25;         ///< then it is drawn although changes continue

/// Records the files that a drawing names, including missing ones.
class NotingLoader final : public ResourceLoader {
 public:
  NotingLoader(const ResourceLoader& loader, const std::string& document,
               std::set<std::string>& files)
      : loader_(loader), folder_(std::filesystem::path(document).parent_path()), files_(files) {}

  Result<std::vector<std::uint8_t>> load(std::string_view href) const override {
    files_.insert((folder_ / std::filesystem::path(href)).string());
    return loader_.load(href);
  }

 private:
  const ResourceLoader& loader_;
  std::filesystem::path folder_;
  std::set<std::string>& files_;
};

class Watching {
 public:
  Watching(Context& context, const WatchArguments& arguments, WatchServer& server)
      : context_(context), arguments_(arguments), server_(server) {}

  void run();

 private:
  Status draw();
  Result<ReadDocument> read();
  Status make(const Document& document);
  Result<std::vector<std::uint8_t>> make_file(const Document& document,
                                              const RenderArguments& arguments,
                                              std::optional<Solution>& kept);
  void update();
  void settle_down();
  bool interrupted() const { return context_.cancel.load(); }

  Context& context_;
  const WatchArguments& arguments_;
  WatchServer& server_;
  FileWatch files_;
  std::set<std::string> named_;  ///< by the newest drawing
  WatchState state_;
  std::optional<Solution> page_solution_, file_solution_;  ///< of the two outputs
};

Result<ReadDocument> Watching::read() {
  SFUMATO_TRY_ASSIGN(const std::string& bytes, read_drawing_text(context_, arguments_.input));
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context_, capacity_bytes(bytes), "the input"));
  const FolderLoader loader(arguments_, context_);
  const NotingLoader noting(loader, arguments_.input, named_);
  return read_document(context_, bytes, display_name(arguments_.input), &noting);
}

/// Solutions that are kept leave less memory for the work. If memory is too little, they are
/// dropped and everything is drawn again.
Result<std::vector<std::uint8_t>> Watching::make_file(const Document& document,
                                                      const RenderArguments& arguments,
                                                      std::optional<Solution>& kept) {
  RenderStats stats;
  Document copy = document;
  auto file = make_picture_file(context_, copy, arguments, stats, &kept);
  if (file || !is_lack_of_memory(file.status())) return file;
  page_solution_.reset();
  file_solution_.reset();
  copy = document;
  return make_picture_file(context_, copy, arguments, stats);
}

Status Watching::make(const Document& document) {
  SFUMATO_TRY_ASSIGN(state_.picture, make_file(document, arguments_.page, page_solution_));
  ++state_.picture_version;
  if (!arguments_.file) return ok_status();
  const std::string& output = arguments_.file->jobs.front().output;
  if (arguments_.file->kind == OutputKind::png) return write_file(output, state_.picture);
  const auto file = make_file(document, *arguments_.file, file_solution_);
  return file ? write_file(output, *file) : file.status();
}

Status Watching::draw() {
  named_.clear();
  state_.messages.clear();
  SFUMATO_TRY_ASSIGN(auto&& read_result, read());
  for (const Diagnostic& warning : warnings_of(read_result)) {
    if (!arguments_.quiet) report_warning(warning);
    state_.messages.push_back(format_message(warning, "warning"));
  }
  return make(read_result.document);
}

/// Draws, and reports the result.
void Watching::update() {
  const Stopwatch watch;
  context_.deadline = deadline_of(arguments_.resources);
  files_.look();
  const Status status = naming(arguments_.input, draw());
  if (interrupted()) return;
  state_.failed = !status;
  if (!status) {
    report_error(status);
    state_.messages.insert(state_.messages.begin(), format_message(status, "error"));
  } else {
    state_.seconds = watch.seconds();
    if (!arguments_.quiet) {
      const Status note =
          make_error(StatusCode::bad_input,
                     "drawn in " + std::to_string(static_cast<int>(state_.seconds * 1000)) + " ms",
                     {display_name(arguments_.input), 0, 0});
      std::fputs(format_message(note, "note").c_str(), stderr);
    }
  }
  for (std::string& message : state_.messages) {
    while (message.ends_with('\n')) message.pop_back();
  }
  std::vector<std::string> files{arguments_.input};
  files.insert(files.end(), named_.begin(), named_.end());
  files_.set_files(std::move(files));
  server_.publish(state_);
}

/// Waits until nothing changes for a moment: editors write in several steps.
void Watching::settle_down() {
  for (int i = 0; i < kMostQuiets && !interrupted(); ++i) {
    files_.look();
    if (!files_.wait(kQuiet)) return;
  }
}

void Watching::run() {
  state_.name = display_name(arguments_.input);
  files_.set_files({arguments_.input});
  update();
  while (!interrupted()) {
    if (!files_.wait(kWatchNap)) continue;
    settle_down();
    if (!interrupted()) update();
  }
}

}  // namespace

int watch(const WatchArguments& arguments) {
  if (arguments.file) {
    const Status writable = check_output(arguments.file->jobs.front().output);
    if (!writable) return fail(writable);
  }
  Result<std::unique_ptr<WatchServer>> server = WatchServer::start(arguments.port);
  if (!server) return fail(server.status());
  CommandContext command(arguments.resources, arguments.page.settings.threads);
  Context& context = command.context();
  const Status printed = print("http://127.0.0.1:" + std::to_string((*server)->port()) + "/\n");
  if (!printed) return fail(printed);
  Watching(context, arguments, **server).run();
  return fail(context.cancel_status());
}

}  // namespace sfumato::cli
