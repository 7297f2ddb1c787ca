#include "sfumato/trace/trace.hpp"

#include <cstdio>
#include <optional>

#include "base/charge.hpp"
#include "base/stopwatch.hpp"
#include "base/table_memory.hpp"
#include "cli/command_context.hpp"
#include "cli/commands.hpp"
#include "cli/document_input.hpp"
#include "cli/drawing_file.hpp"
#include "cli/paths.hpp"
#include "cli/progress_bar.hpp"
#include "cli/trace_stats.hpp"
#include "codecs/photo.hpp"
#include "trace/curve_choice.hpp"

namespace sfumato::cli {
namespace {

/// Shows on the bar how near a drawing has come.
class BarWatch : public TraceWatch {
 public:
  explicit BarWatch(ProgressBar* bar) : bar_(bar) {}
  void reached(const TraceState& state, const Document&) override {
    if (bar_) bar_->set_note(psnr_text(state.psnr_db));
  }

 private:
  ProgressBar* bar_;
};

/// Makes one drawing after another.
class Tracing {
 public:
  Tracing(Context& context, const TraceArguments& arguments, ProgressBar* bar)
      : context_(context), arguments_(arguments), watch_(bar), bar_(bar) {}

  /// The drawing of --colors-only, where there is one.
  Status read_drawing_to_color();
  Status trace_picture(const Job& job, TraceFacts& facts);
  void say(const TraceFacts& facts, const Job& job);

 private:
  Result<Image> read_picture(const std::string& path);
  void give_time_for_the_round();
  Result<Document> make_drawing(const Image& picture, TraceStats& stats);
  void warn_of_time(const TraceStats& stats, const std::string& input);
  void warn(const Diagnostic& warning);

  Context& context_;
  const TraceArguments& arguments_;
  BarWatch watch_;
  ProgressBar* bar_;
  std::optional<Document> drawing_;
  ScopedCharge drawing_charge_;
};

void Tracing::warn(const Diagnostic& warning) {
  if (arguments_.quiet) return;
  if (bar_) bar_->erase();
  report_warning(warning);
}

Status Tracing::read_drawing_to_color() {
  if (arguments_.input.empty()) return ok_status();
  context_.deadline = deadline_of(arguments_.resources);
  Result<ReadDocument> read = read_drawing(context_, arguments_);
  if (!read) return read.status();
  drawing_ = std::move(read->document);
  Status status = drawing_charge_.add(context_, bytes_of(*drawing_), "the drawing");
  if (status) status = tracing::check_curves(context_, *drawing_, arguments_.fit.only);
  if (!status && status.where.file.empty()) status.where.file = display_name(arguments_.input);
  return status;
}

Result<Image> Tracing::read_picture(const std::string& path) {
  const Result<std::string> bytes =
      read_within(context_, path, &Limits::image_file_bytes, "bytes of a picture");
  if (!bytes) return bytes.status();
  if (is_solved(*bytes)) return no_solved_picture("a PNG, JPEG or WebP", path);
  ScopedCharge charge;
  Status status = charge.add(context_, capacity_bytes(*bytes), "the input");
  if (!status) return status;
  std::vector<Diagnostic> warnings;
  Result<Image> picture = codecs::read_photo(
      context_, {reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size()},
      display_name(path), &warnings);
  for (const Diagnostic& warning : warnings) warn(warning);
  return picture;
}

Result<Document> Tracing::make_drawing(const Image& picture, TraceStats& stats) {
  if (drawing_) return fit_colors(context_, *drawing_, picture, arguments_.fit, &stats);
  TraceOptions options = arguments_.options;
  options.watch = &watch_;
  return trace(context_, picture, options, &stats);
}

/// So that nobody takes what a slow machine has made for the same as a fast one's.
void Tracing::warn_of_time(const TraceStats& stats, const std::string& input) {
  const double most = arguments_.options.max_seconds;
  if (drawing_ || most <= 0 || stats.rounds.empty()) return;
  const TraceState& last = stats.rounds.back();
  if (last.seconds < most || last.round + 1 >= last.round_count) return;
  warn({"ended early, after the time of --max-time; a longer one lets the drawing come nearer",
        {display_name(input)}});
}

/// What is begun before the time is over may end, and be written.
void Tracing::give_time_for_the_round() {
  options::Resources resources = arguments_.resources;
  if (drawing_ || !resources.seconds) return;
  *resources.seconds += limits::kSeconds;
  context_.deadline = deadline_of(resources);
}

Status Tracing::trace_picture(const Job& job, TraceFacts& facts) {
  const Stopwatch total;
  context_.deadline = deadline_of(arguments_.resources);
  if (bar_) bar_->set_note({});
  const Result<Image> picture = read_picture(job.input);
  if (!picture) return picture.status();
  ScopedCharge charge;
  Status status = charge.add(context_, capacity_bytes(picture->bytes), "the picture");
  if (!status) return status;
  give_time_for_the_round();
  facts.threads = context_.thread_count();
  facts.read_seconds = total.seconds();
  const Stopwatch tracing;
  const Result<Document> drawing = make_drawing(*picture, facts.trace);
  facts.trace_seconds = tracing.seconds();
  if (!drawing) return drawing.status();
  status = charge.add(context_, bytes_of(*drawing), "the drawing");
  if (!status) return status;
  const Stopwatch writing;
  status = write_drawing(context_, *drawing, job.output);
  facts.write_seconds = writing.seconds();
  facts.total_seconds = total.seconds();
  if (status) warn_of_time(facts.trace, job.input);
  return status;
}

void Tracing::say(const TraceFacts& facts, const Job& job) {
  if (arguments_.quiet) return;
  if (bar_) bar_->erase();
  const std::string name = job.output == "-" ? "<stdout>" : job.output;
  std::fputs(output_line(summary(facts, name)).c_str(), stderr);
}

}  // namespace

int trace(const TraceArguments& arguments) {
  CommandContext work(arguments, arguments.threads);
  Context& context = work.context();
  ProgressBar* const bar = work.bar();
  Tracing tracing(context, arguments, bar);
  Status status = prepare_outputs(arguments);
  if (status && !arguments.many) status = check_output(arguments.jobs.front().output);
  if (status) status = tracing.read_drawing_to_color();
  if (!status) return fail(status);
  return run_jobs(context, arguments, kTraceWords, bar, [&](const Job& job, std::string& line) {
    TraceFacts facts;
    const Status traced = tracing.trace_picture(job, facts);
    if (!traced) return traced;
    line = to_json(facts, arguments.many ? job.input : std::string());
    tracing.say(facts, job);
    return traced;
  });
}

}  // namespace sfumato::cli
