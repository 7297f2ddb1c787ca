#include "cli/drawing_jobs.hpp"

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <optional>

#include "base/stopwatch.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress_bar.hpp"
#include "cli/texture_uses.hpp"
#include "sfumato/base/native/file.hpp"
#include "sfumato/base/native/thread_pool.hpp"

namespace sfumato::cli {
namespace {

constexpr std::chrono::milliseconds kProgressDelay{1000};

/// `total` runs since the start of the job.
Status make_and_write(Context& context, const options::Resources& resources, const Job& job,
                      MakeFile make, RenderStats& stats) {
  const Stopwatch total;
  context.deadline = deadline_of(resources);
  stats.threads = context.thread_count();
  const auto file = make(context, job.input, stats);
  if (!file) return file.status();
  if (context.cancelled()) return context.cancel_status();
  const Stopwatch write_watch;
  const Status written = write_file(job.output, *file, &context);
  stats.write_seconds += write_watch.seconds();
  stats.total_seconds = total.seconds();
  return written;
}

}  // namespace

int run_drawing_jobs(const DocumentArguments& documents, const JobArguments& jobs, int threads,
                     const JobWords& words, MakeFile make) {
  ThreadPool executor(threads);
  std::optional<ProgressBar> progress;
  if (!documents.quiet && isatty(STDERR_FILENO) != 0) progress.emplace(stderr, kProgressDelay);
  Context context{.executor = &executor,
                  .progress = progress ? &*progress : nullptr,
                  .budget = Budget(documents.resources.memory_bytes),
                  .limits = documents.resources.limits};
  const CancelOnSignal cancel_on_signal(context.cancel);
  const std::string complaint = complaint_about_textures(context, documents, jobs);
  if (context.cancel.load()) return fail(context.cancel_status());
  if (!complaint.empty()) {
    report_error(make_error(StatusCode::bad_input, complaint));
    return kBadUsage;
  }
  const Status writable = prepare_outputs(jobs);
  if (!writable) return fail(writable);
  return run_jobs(context, jobs, words, progress ? &*progress : nullptr,
                  [&](const Job& job, std::string& line) {
                    RenderStats stats;
                    Status status = make_and_write(context, documents.resources, job, make, stats);
                    line = to_json(stats, jobs.many ? job.input : std::string());
                    return status;
                  });
}

}  // namespace sfumato::cli
