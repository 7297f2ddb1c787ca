#include "cli/commands/drawing_jobs.hpp"

#include "base/stopwatch.hpp"
#include "base/try.hpp"
#include "cli/command_context.hpp"
#include "cli/commands/film.hpp"
#include "cli/files/texture_uses.hpp"
#include "cli/messages.hpp"
#include "sfumato/base/native/file.hpp"
#include "sfumato/gpu/gather.hpp"

namespace sfumato::cli {
namespace {

/// Makes the outputs of jobs and writes them to their destinations.
class DrawingJobs {
 public:
  DrawingJobs(Context& context, const DocumentArguments& documents, const JobArguments& jobs,
              ProgressBar* bar, MakeFile make)
      : context_(context), documents_(documents), jobs_(jobs), bar_(bar), make_(make) {
    if (jobs.film) film_.emplace(documents.outputs.front(), *jobs.film, !documents.quiet);
  }

  int run(const JobWords& words);

 private:
  Status make_and_write(const Job& job, RenderStats& stats);
  Status write(const Job& job, const std::vector<std::uint8_t>& file, const RenderStats& stats);

  Context& context_;
  const DocumentArguments& documents_;
  const JobArguments& jobs_;
  ProgressBar* bar_;
  MakeFile make_;
  std::optional<Film> film_;
  std::optional<Solution> kept_;
};

Status DrawingJobs::write(const Job& job, const std::vector<std::uint8_t>& file,
                          const RenderStats& stats) {
  if (!film_) return write_file(job.output, file, &context_);
  if (bar_) bar_->erase();
  return film_->add(context_, job, file, stats);
}

/// `total` counts from the start of the job.
Status DrawingJobs::make_and_write(const Job& job, RenderStats& stats) {
  const Stopwatch total;
  context_.deadline = deadline_of(documents_.resources);
  stats.threads = context_.thread_count();
  SFUMATO_TRY_ASSIGN(const auto& file, make_(context_, job.input, stats, kept_));
  if (context_.cancelled()) return context_.cancel_status();
  const Stopwatch write_watch;
  const Status written = write(job, file, stats);
  stats.write_seconds += write_watch.seconds();
  stats.total_seconds = total.seconds();
  return written;
}

int DrawingJobs::run(const JobWords& words) {
  const int code = run_jobs(context_, jobs_, words, bar_, [&](const Job& job, std::string& line) {
    RenderStats stats;
    Status status = make_and_write(job, stats);
    line = to_json(stats, jobs_.many ? job.input : std::string());
    return status;
  });
  if (!film_ || code != kDone) return code;
  const Status closed = film_->close(context_);
  return closed ? code : fail(closed);
}

}  // namespace

int run_drawing_jobs(const DocumentArguments& documents, const JobArguments& jobs,
                     const options::Settings& settings, const JobWords& words, MakeFile make) {
  CommandContext work(documents, settings.threads);
  Context& context = work.context();
  const std::string complaint = complaint_about_textures(context, documents, jobs);
  if (context.cancel.load()) return fail(context.cancel_status());
  if (!complaint.empty()) {
    report_error(make_error(StatusCode::bad_input, complaint));
    return kBadUsage;
  }
  const Status writable = prepare_outputs(jobs);
  if (!writable) return fail(writable);
  const auto warn = [&](const std::string& what) {
    if (!documents.quiet) report_warning({what + "; the CPU computes the colours instead", {}});
  };
  GpuGather gpu;
  if (settings.gather == options::Device::gpu) {
    Result<GpuGather> made = GpuGather::create();
    if (!made) warn(made.status().message);
    if (made) gpu = std::move(*made);
  }
  context.point_source = gpu.source();
  const int code = DrawingJobs(context, documents, jobs, work.bar(), make).run(words);
  if (gpu.is_lost()) warn(gpu.device_name() + " stopped responding");
  return code;
}

}  // namespace sfumato::cli
