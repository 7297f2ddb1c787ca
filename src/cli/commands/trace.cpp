#include "sfumato/trace/trace.hpp"

#include <cstdio>

#include "base/charge.hpp"
#include "base/stopwatch.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "cli/command_context.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/trace_stats.hpp"
#include "cli/files/document_input.hpp"
#include "cli/files/drawing_file.hpp"
#include "cli/files/paths.hpp"
#include "cli/progress_bar.hpp"
#include "codecs/photo/photo.hpp"
#include "trace/curves/curve_choice.hpp"
#include "trace/sized_trace.hpp"

namespace sfumato::cli {
namespace {

/// Shows on the bar how close the drawing is to the picture.
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

  /// Reads the drawing of --colors-only, if there is one.
  Status read_drawing_to_color();
  Status trace_picture(const Job& job, TraceFacts& facts);
  void say(const TraceFacts& facts, const Job& job);

 private:
  Result<codecs::SizedPhoto> read_picture(const std::string& path);
  void give_time_for_the_rest();
  Result<Document> make_drawing(const codecs::SizedPhoto& photo, TraceStats& stats);
  void warn_of_time(const TraceStats& stats, const std::string& input);
  void warn_of_points(const TraceStats& stats, const std::string& input);
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
  SFUMATO_TRY_ASSIGN(auto&& read, read_drawing(context_, arguments_));
  drawing_ = std::move(read.document);
  Status status = drawing_charge_.add(context_, bytes_of(*drawing_), "the drawing");
  if (status) status = tracing::check_curves(context_, *drawing_, arguments_.fit.only);
  return naming(arguments_.input, std::move(status));
}

Result<codecs::SizedPhoto> Tracing::read_picture(const std::string& path) {
  SFUMATO_TRY_ASSIGN(const std::string& bytes,
                     read_within(context_, path, &Limits::image_file_bytes, "bytes of a picture"));
  if (is_solved(bytes)) return no_solved_picture("a PNG, JPEG or WebP", path);
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context_, capacity_bytes(bytes), "the input"));
  const int max_side = drawing_ ? arguments_.fit.max_side : arguments_.options.max_side;
  std::vector<Diagnostic> warnings;
  Result<codecs::SizedPhoto> picture = codecs::read_sized_photo(
      context_, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()},
      display_name(path), max_side, &warnings);
  for (const Diagnostic& warning : warnings) warn(warning);
  return picture;
}

Result<Document> Tracing::make_drawing(const codecs::SizedPhoto& photo, TraceStats& stats) {
  if (drawing_) return fit_colors(context_, *drawing_, photo.image, arguments_.fit, &stats);
  TraceOptions options = arguments_.options;
  options.watch = &watch_;
  return tracing::trace_sized(context_, photo.image, photo.width, photo.height, options, &stats);
}

/// Warns if the time ended the trace, because a slow machine then makes another drawing than a fast
/// one.
void Tracing::warn_of_time(const TraceStats& stats, const std::string& input) {
  if (!stats.ended_early) return;
  warn({"stopped early at --max-time; raise it for a closer drawing", {display_name(input)}});
}

/// Warns of lost strokes: a page of text would lose words without a sign.
void Tracing::warn_of_points(const TraceStats& stats, const std::string& input) {
  if (stats.points_needed == 0) return;
  warn(
      {"thin strokes are lost; trace is for photographs, and all strokes of this picture need "
       "about " +
           std::to_string(stats.points_needed) + " control points (--points)",
       {display_name(input)}});
}

/// A round that began in time may finish, and the drawing may be written.
void Tracing::give_time_for_the_rest() {
  options::Resources resources = arguments_.resources;
  if (!resources.seconds) return;
  *resources.seconds += limits::kSeconds;
  context_.deadline = deadline_of(resources);
}

Status Tracing::trace_picture(const Job& job, TraceFacts& facts) {
  const Stopwatch total;
  context_.deadline = deadline_of(arguments_.resources);
  if (bar_) bar_->set_note({});
  SFUMATO_TRY_ASSIGN(const codecs::SizedPhoto& picture, read_picture(job.input));
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context_, capacity_bytes(picture.image.bytes), "the picture"));
  if (!drawing_) give_time_for_the_rest();
  facts.threads = context_.thread_count();
  facts.read_seconds = total.seconds();
  const Stopwatch tracing;
  const Result<Document> drawing = make_drawing(picture, facts.trace);
  facts.trace_seconds = tracing.seconds();
  SFUMATO_TRY(drawing);
  SFUMATO_TRY(charge.add(context_, bytes_of(*drawing), "the drawing"));
  if (facts.trace.ended_early) give_time_for_the_rest();
  const Stopwatch writing;
  Status status = write_drawing(context_, *drawing, job.output);
  facts.write_seconds = writing.seconds();
  facts.total_seconds = total.seconds();
  if (status) warn_of_time(facts.trace, job.input);
  if (status) warn_of_points(facts.trace, job.input);
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
    SFUMATO_TRY(tracing.trace_picture(job, facts));
    line = to_json(facts, arguments.many ? job.input : std::string());
    tracing.say(facts, job);
    Status traced;
    return traced;
  });
}

}  // namespace sfumato::cli
