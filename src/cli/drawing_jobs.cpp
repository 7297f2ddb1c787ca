#include "cli/drawing_jobs.hpp"

#include "base/stopwatch.hpp"
#include "cli/command_context.hpp"
#include "cli/texture_uses.hpp"
#include "sfumato/base/native/file.hpp"

namespace sfumato::cli {
namespace {

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
  CommandContext work(documents, threads);
  Context& context = work.context();
  const std::string complaint = complaint_about_textures(context, documents, jobs);
  if (context.cancel.load()) return fail(context.cancel_status());
  if (!complaint.empty()) {
    report_error(make_error(StatusCode::bad_input, complaint));
    return kBadUsage;
  }
  const Status writable = prepare_outputs(jobs);
  if (!writable) return fail(writable);
  return run_jobs(context, jobs, words, work.bar(), [&](const Job& job, std::string& line) {
    RenderStats stats;
    Status status = make_and_write(context, documents.resources, job, make, stats);
    line = to_json(stats, jobs.many ? job.input : std::string());
    return status;
  });
}

}  // namespace sfumato::cli
