#include <unistd.h>

#include <chrono>
#include <cstdio>
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
  RenderArguments current = arguments;
  return run_jobs(context, arguments, kRenderWords, progress ? &*progress : nullptr,
                  [&](const Job& job, std::string& line) {
                    current.input = job.input;
                    RenderStats stats;
                    Status status = render_document(context, current, job.output, stats);
                    line = to_json(stats, arguments.many ? job.input : std::string());
                    return status;
                  });
}

}  // namespace sfumato::cli
