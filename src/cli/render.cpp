#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>

#include "base/stopwatch.hpp"
#include "cli/commands.hpp"
#include "cli/document_input.hpp"
#include "cli/interrupt.hpp"
#include "cli/paths.hpp"
#include "cli/picture_file.hpp"
#include "cli/progress_bar.hpp"
#include "cli/stats.hpp"
#include "cli/texture_uses.hpp"
#include "sfumato/base/native/file.hpp"
#include "sfumato/base/native/thread_pool.hpp"

namespace sfumato::cli {
namespace {

constexpr std::chrono::milliseconds kProgressDelay{1000};

/// Reads, draws and writes the document of arguments.input; `total` runs since its start.
Status render_document(Context& context, const RenderArguments& arguments,
                       const std::string& output, RenderStats& stats) {
  const Stopwatch total;
  context.deadline = deadline_of(arguments.resources);
  Result<ReadDocument> read = read_drawing(context, arguments);
  if (!read) return read.status();
  stats.threads = context.thread_count();
  stats.read_seconds = total.seconds();
  const auto file = make_picture_file(context, read->document, arguments, stats);
  if (!file) return file.status();
  if (context.cancelled()) return context.cancel_status();
  const Stopwatch write_watch;
  const Status written = write_file(output, *file, &context);
  stats.write_seconds += write_watch.seconds();
  stats.total_seconds = total.seconds();
  return written;
}

/// The jobs of one call, one after another, each on all threads.
class Rendering {
 public:
  Rendering(Context& context, const RenderArguments& arguments, ProgressBar* bar)
      : context_(context), arguments_(arguments), bar_(bar) {}

  /// The exit code: of the first job that failed.
  int run();

 private:
  void run_job(std::size_t index);
  void report_failure(const Status& status);
  /// By a signal; one drawing that takes too long does not end the others.
  bool interrupted() const { return context_.cancel.load(); }

  Context& context_;
  RenderArguments arguments_;
  ProgressBar* bar_;
  std::string stats_;
  int exit_code_ = kDone;
  std::size_t failed_ = 0;
  bool is_cancelled_ = false;  ///< and that was reported
};

void Rendering::report_failure(const Status& status) {
  const int code = fail(status);
  if (status.code == StatusCode::cancelled) is_cancelled_ = true;
  if (failed_++ == 0 || is_cancelled_) exit_code_ = code;
}

void Rendering::run_job(std::size_t index) {
  const RenderJob& job = arguments_.jobs[index];
  arguments_.input = job.input;
  if (bar_) {
    bar_->erase();
    bar_->set_job(index, arguments_.jobs.size());
  }
  RenderStats stats;
  Status status = check_output(job.output);
  if (status) status = render_document(context_, arguments_, job.output, stats);
  if (bar_ && !status) bar_->erase();
  if (!status && status.where.file.empty()) status.where.file = display_name(job.input);
  if (!status) return report_failure(status);
  stats_ += to_json(stats, arguments_.many ? job.input : std::string());
}

int Rendering::run() {
  for (std::size_t i = 0; i < arguments_.jobs.size() && !is_cancelled_; ++i) {
    // Also where the signal came between two jobs, or before the first.
    interrupted() ? report_failure(context_.cancel_status()) : run_job(i);
  }
  if (bar_) bar_->erase();
  if (!arguments_.stats.empty() && (arguments_.many || failed_ == 0) && !is_cancelled_) {
    const Status written = write_file(
        arguments_.stats, {reinterpret_cast<const std::uint8_t*>(stats_.data()), stats_.size()},
        &context_);
    if (!written) report_failure(written);
  }
  if (arguments_.many && failed_ > 0 && !is_cancelled_) {
    std::fprintf(stderr, "sfumato: %zu of %zu drawings failed\n", failed_, arguments_.jobs.size());
  }
  return exit_code_;
}

Status prepare_outputs(const RenderArguments& arguments) {
  if (arguments.many) {
    const Status made = make_folder(arguments.output_folder);
    if (!made) return made;
  }
  return arguments.stats.empty() ? ok_status() : check_output(arguments.stats);
}

}  // namespace

int render(const RenderArguments& arguments) {
  ThreadPool executor(arguments.settings.threads);
  std::optional<ProgressBar> progress;
  if (!arguments.quiet && isatty(STDERR_FILENO) != 0) progress.emplace(stderr, kProgressDelay);
  Context context{.executor = &executor,
                  .progress = progress ? &*progress : nullptr,
                  .budget = Budget(arguments.resources.memory_bytes),
                  .limits = arguments.resources.limits};
  const CancelOnSignal cancel_on_signal(context.cancel);
  const std::string complaint = complaint_about_textures(context, arguments);
  if (context.cancel.load()) return fail(context.cancel_status());
  if (!complaint.empty()) {
    report_error(make_error(StatusCode::bad_input, complaint));
    return kBadUsage;
  }
  const Status writable = prepare_outputs(arguments);
  if (!writable) return fail(writable);
  return Rendering(context, arguments, progress ? &*progress : nullptr).run();
}

}  // namespace sfumato::cli
