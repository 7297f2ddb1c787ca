#include "cli/commands/jobs.hpp"

#include <cstdio>
#include <utility>

#include "base/native/folder.hpp"
#include "base/try.hpp"
#include "cli/files/paths.hpp"
#include "cli/messages.hpp"
#include "sfumato/base/native/file.hpp"

namespace sfumato::cli {
namespace {

class JobRun {
 public:
  JobRun(Context& context, const JobArguments& arguments, const JobWords& words, ProgressBar* bar)
      : context_(context), arguments_(arguments), words_(words), bar_(bar) {}

  int run(DoJob do_job);

 private:
  void run_job(std::size_t index, DoJob do_job);
  void report_failure(const Status& status);
  void report_end() const;
  bool has_ended() const { return is_cancelled_ || (arguments_.film && failed_ > 0); }
  /// True after a signal. A job that takes too long does not end the others.
  bool interrupted() const { return context_.cancel.load(); }

  Context& context_;
  const JobArguments& arguments_;
  const JobWords& words_;
  ProgressBar* bar_;
  std::string stats_;
  int exit_code_ = kDone;
  std::size_t done_ = 0, failed_ = 0;
  bool is_cancelled_ = false;  ///< and that was reported
};

void JobRun::report_failure(const Status& status) {
  const int code = fail(status);
  if (status.code == StatusCode::cancelled) is_cancelled_ = true;
  if (failed_++ == 0 || is_cancelled_) exit_code_ = code;
}

void JobRun::run_job(std::size_t index, DoJob do_job) {
  const Job& job = arguments_.jobs[index];
  if (bar_) {
    bar_->erase();
    bar_->set_job(index, arguments_.jobs.size());
  }
  std::string stats;
  Status status = check_output(job.output);
  if (status) status = do_job(job, stats);
  if (bar_ && !status) bar_->erase();
  if (!status) return report_failure(naming(job.input, std::move(status)));
  ++done_;
  stats_ += stats;
}

int JobRun::run(DoJob do_job) {
  for (std::size_t i = 0; i < arguments_.jobs.size() && !has_ended(); ++i) {
    // This also covers a signal between two jobs, or before the first.
    interrupted() ? report_failure(context_.cancel_status()) : run_job(i, do_job);
  }
  if (bar_) bar_->erase();
  if (!arguments_.stats.empty() && (arguments_.many || failed_ == 0) && !is_cancelled_) {
    const Status written = write_file(
        arguments_.stats, {reinterpret_cast<const std::uint8_t*>(stats_.data()), stats_.size()},
        &context_);
    if (!written) report_failure(written);
  }
  report_end();
  return exit_code_;
}

void JobRun::report_end() const {
  if (!arguments_.many || failed_ == 0 || is_cancelled_) return;
  if (arguments_.film) {
    std::fprintf(stderr, "sfumato: the film ends after %zu of %zu frames\n", done_,
                 arguments_.jobs.size());
  } else {
    std::fprintf(stderr, "sfumato: %zu of %zu %ss failed\n", failed_, arguments_.jobs.size(),
                 words_.input);
  }
}

}  // namespace

Status prepare_outputs(const JobArguments& arguments) {
  if (!arguments.output_folder.empty()) {
    SFUMATO_TRY(make_folder(arguments.output_folder));
  }
  return arguments.stats.empty() ? ok_status() : check_output(arguments.stats);
}

int run_jobs(Context& context, const JobArguments& arguments, const JobWords& words,
             ProgressBar* bar, DoJob do_job) {
  return JobRun(context, arguments, words, bar).run(do_job);
}

}  // namespace sfumato::cli
