#include "hostile/growth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "hostile/documents.hpp"
#include "hostile/sandbox.hpp"

namespace sfumato::hostile {
namespace {

constexpr double kMostGrowth = 2.5;

/// Shorter runs are too inexact: n is doubled until the first run takes this long.
constexpr double kLeastSeconds = 0.05;
/// Noise of an allocator's pages.
constexpr double kLeastBytes = 4 << 20;

/// Other programs only lengthen runs, so the minimum of some runs is the best estimate.
constexpr int kRuns = 3;
/// Attempts until a generator fails.
constexpr int kAttempts = 4;

struct Cost {
  double seconds = std::numeric_limits<double>::infinity();
  double bytes = std::numeric_limits<double>::infinity();
};

/// One generator at n, 2n and 4n.
class Measurement {
 public:
  Measurement(const Growing& growing, const std::string& binary, const Cost& empty)
      : growing_(growing), binary_(binary), empty_(empty) {}

  /// Returns "" or the fault.
  std::string run() {
    if (!choose_size()) return failure_;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < kRuns; ++i) {
          if (!measure(n_ << k, cost_[k])) return failure_;
        }
      }
      if (time_growth() <= kMostGrowth && memory_growth() <= kMostGrowth) return {};
    }
    return time_growth() > kMostGrowth ? "time grows faster than its input"
                                       : "memory grows faster than its input";
  }

  void print() const {
    std::printf("| %s | %zu | %.0f | %.0f | %.0f | %.2f | %.1f | %.1f | %.1f | %.2f |\n",
                growing_.name.c_str(), n_, 1e3 * cost_[0].seconds, 1e3 * cost_[1].seconds,
                1e3 * cost_[2].seconds, time_growth(), mib(0), mib(1), mib(2), memory_growth());
  }

 private:
  bool choose_size() {
    for (n_ = growing_.first;; n_ *= 2) {
      Cost cost;
      if (!measure(n_, cost)) return false;
      if (cost.seconds >= kLeastSeconds || 8 * n_ > growing_.most) return true;
    }
  }

  bool measure(std::size_t n, Cost& least) {
    const Sandbox sandbox;
    Case of;
    of.files.emplace_back("in.svg", [&] { return growing_.document(n); });
    if (!sandbox.prepare(of)) return fail("its file cannot be made");
    const Ended ended = sandbox.run(binary_, growing_.arguments, {});
    if (ended.signal != 0) return fail("signal " + std::to_string(ended.signal));
    if (ended.exit_code != 0) return fail("n = " + std::to_string(n) + ": " + ended.err);
    least.seconds = std::min(least.seconds, std::max(0.0, ended.user_seconds - empty_.seconds));
    least.bytes = std::min(least.bytes, static_cast<double>(ended.peak_bytes) - empty_.bytes);
    return true;
  }

  bool fail(const std::string& why) {
    failure_ = why;
    return false;
  }

  double time_growth() const {
    return growth(cost_[0].seconds, cost_[2].seconds, kLeastSeconds / 2);
  }
  double memory_growth() const { return growth(cost_[0].bytes, cost_[2].bytes, kLeastBytes); }
  /// Returns the growth per doubling, from n to 4n, because a temporary slowdown of the machine
  /// distorts it half as much as a single doubling.
  static double growth(double from, double to, double least) {
    return std::sqrt(std::max(to, least) / std::max(from, least));
  }
  double mib(std::size_t k) const { return cost_[k].bytes / (1 << 20); }

  const Growing& growing_;
  const std::string& binary_;
  const Cost& empty_;
  std::size_t n_ = 0;
  std::array<Cost, 3> cost_{};
  std::string failure_;
};

/// Returns the command's cost for an empty drawing.
Cost cost_of_nothing(const std::string& binary) {
  Cost least;
  for (int i = 0; i < 2 * kRuns; ++i) {
    const Sandbox sandbox;
    Case of;
    of.files.emplace_back("in.svg", svg(kLayer));
    if (!sandbox.prepare(of)) continue;
    const Ended ended = sandbox.run(binary, {"info", "in.svg"}, {});
    least.seconds = std::min(least.seconds, ended.user_seconds);
    least.bytes = std::min(least.bytes, static_cast<double>(ended.peak_bytes));
  }
  return least;
}

}  // namespace

int run_growth(const std::string& binary, const std::string& only) {
  const Cost empty = cost_of_nothing(binary);
  std::printf("| generator | n | ms at n | 2n | 4n | growth | MiB at n | 2n | 4n | growth |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|\n");
  int count = 0, failed = 0;
  for (const Growing& growing : all_growing()) {
    if (!only.empty() && growing.name != only) continue;
    ++count;
    Measurement measurement(growing, binary, empty);
    const std::string complaint = measurement.run();
    measurement.print();
    std::fflush(stdout);
    if (complaint.empty()) continue;
    ++failed;
    std::printf("not ok growth/%s: %s\n", growing.name.c_str(), complaint.c_str());
  }
  std::printf("%d generators, %d failed\n", count, failed);
  return count > 0 && failed == 0 ? 0 : 1;
}

}  // namespace sfumato::hostile
