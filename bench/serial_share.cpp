#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string>

#include "sfumato/formats/read_document.hpp"
#include "sfumato/solve/diffuse.hpp"

// How much of diffuse() threads can share: its CPU time (work), and the time of its longest chain
// of steps that wait for each other (span). With any number of threads it takes at least the span.
// share is span / work, and two is work over the time that Amdahl's law predicts for two threads.
//
//   build/bench/serial_share [--width PIXELS] FILE...
//
// Tasks run one after another in one thread, so the figures do not depend on the number of free
// cores.
namespace sfumato {
namespace {

double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Runs tasks in order, with a clock for each one that starts at their common beginning.
class SpanExecutor final : public Executor {
 public:
  void start() { seconds_ = 0, since_ = thread_seconds(); }

  /// Returns the time of the longest chain since start().
  double span_seconds() {
    advance();
    return seconds_;
  }

  void run(std::size_t task_count, FunctionRef<void(std::size_t)> task) override {
    advance();
    const double begin = seconds_;
    double end = begin;
    for (std::size_t i = 0; i < task_count; ++i) {
      seconds_ = begin;
      task(i);
      advance();
      end = std::max(end, seconds_);
    }
    seconds_ = end;
  }

  int thread_count() const override { return 8; }

 private:
  void advance() {
    const double now = thread_seconds();
    seconds_ += now - since_;
    since_ = now;
  }

  double seconds_ = 0;
  double since_ = 0;
};

bool measure(const std::string& path, double width_px) {
  std::ifstream stream(path, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  const std::string name = path.substr(path.rfind('/') + 1);
  SpanExecutor executor;
  Context context;
  context.executor = &executor;
  const Result<ReadDocument> read = read_document(context, text, name);
  if (!read) return false;
  const Document& document = read->document;
  const DiffuseOptions options{.pixels_per_unit = width_px / document.artboard.width()};
  double work = 0, span = 0;
  constexpr int kRuns = 3;
  for (int i = 0; i < kRuns; ++i) {  // the fastest run; the others were disturbed
    executor.start();
    const double begin = thread_seconds();
    if (!diffuse(context, document, options)) return false;
    const double seconds = thread_seconds() - begin;
    if (i > 0 && seconds >= work) continue;
    work = seconds;
    span = executor.span_seconds();
  }
  std::printf("%-24s work %7.1f ms  span %7.1f ms  share %4.1f%%  two %4.2f\n", name.c_str(),
              1e3 * work, 1e3 * span, 100 * span / work, work / (span + 0.5 * (work - span)));
  return true;
}

}  // namespace
}  // namespace sfumato

int main(int argc, char** argv) {
  double width_px = 1024;
  bool is_good = argc > 1;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--width" && i + 1 < argc) {
      width_px = std::atof(argv[++i]);
    } else if (!sfumato::measure(argument, width_px)) {
      std::fprintf(stderr, "%s cannot be drawn\n", argument.c_str());
      is_good = false;
    }
  }
  return is_good ? 0 : 1;
}
