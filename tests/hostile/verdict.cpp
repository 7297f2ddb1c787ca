#include "hostile/verdict.hpp"

#include <algorithm>
#include <iterator>

namespace sfumato::hostile {
namespace {

/// At most 101 lines of warnings and an error, each with short quotes.
constexpr std::size_t kMostMessageBytes = std::size_t{64} << 10;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Returns the last lines, which contain the error.
std::string shown(const std::string& err) {
  constexpr std::size_t kShown = 1500;
  std::string text = err.size() > kShown ? "…" + err.substr(err.size() - kShown) : err;
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.empty() ? "nothing" : text;
}

std::string complaint_of_sanitizers(const Ended& ended) {
  for (const char* mark : {"runtime error:", "ERROR: AddressSanitizer", "ERROR: LeakSanitizer",
                           "ERROR: ThreadSanitizer"}) {
    if (has(ended.err, mark)) return "a sanitizer reports:\n" + ended.err.substr(0, 6000);
  }
  return {};
}

std::string complaint_of_messages(const Case& of, const Ended& ended) {
  if (of.message.empty() && !ended.err.empty()) return "printed " + shown(ended.err);
  if (!has(ended.err, of.message))
    return "expected \"" + of.message + "\", got " + shown(ended.err);
  if (ended.err.size() > kMostMessageBytes) {
    return "printed " + std::to_string(ended.err.size()) + " bytes";
  }
  const bool is_usage = of.exit_code == kBadUsage;
  if (of.exit_code != kDone && !is_usage && !has(ended.err, "error: ")) {
    return "no error was printed, but " + shown(ended.err);
  }
  const auto is_control = [](char c) {
    return c != '\n' && (static_cast<unsigned char>(c) < 0x20 || c == 0x7f);
  };
  if (std::ranges::any_of(ended.err, is_control)) return "printed control characters";
  return {};
}

/// Expects a picture if one was made, and no other files.
std::string complaint_of_files(const Case& of, const std::vector<std::string>& before,
                               const std::vector<std::string>& after) {
  std::vector<std::string> made, gone;
  std::ranges::set_difference(after, before, std::back_inserter(made));
  std::ranges::set_difference(before, after, std::back_inserter(gone));
  if (!gone.empty()) return "removed " + gone.front();
  if (of.exit_code != kDone && !made.empty()) return "left " + made.front();
  const bool is_one = made.empty() || (made.size() == 1 && made.front().starts_with("out"));
  return is_one ? std::string() : "made " + made.front() + " and " + made.back();
}

}  // namespace

std::string complaint_of_cost(const Ended& ended, double granted_seconds) {
  if (ended.cpu_seconds > granted_seconds) {
    return "took " + std::to_string(ended.cpu_seconds) + " s of processor time, where " +
           std::to_string(granted_seconds) + " s are granted";
  }
  if (ended.peak_bytes > kMostBytes) {
    return "took " + std::to_string(ended.peak_bytes >> 20) + " MiB of memory";
  }
  return {};
}

std::string complaint(const Case& of, const Ended& ended, const std::vector<std::string>& before,
                      const std::vector<std::string>& after, double granted_seconds) {
  if (std::string found = complaint_of_sanitizers(ended); !found.empty()) return found;
  if (ended.signal != 0) {
    return "ended by signal " + std::to_string(ended.signal) + " after " +
           std::to_string(ended.cpu_seconds) + " s; printed " + shown(ended.err);
  }
  if (ended.exit_code != of.exit_code) {
    return "exit code " + std::to_string(ended.exit_code) + ", expected " +
           std::to_string(of.exit_code) + "; printed " + shown(ended.err);
  }
  if (std::string found = complaint_of_messages(of, ended); !found.empty()) return found;
  if (std::string found = complaint_of_files(of, before, after); !found.empty()) return found;
  return complaint_of_cost(ended, granted_seconds);
}

}  // namespace sfumato::hostile
