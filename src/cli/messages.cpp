#include "cli/messages.hpp"

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <optional>

#include "base/text/utf8.hpp"
#include "cli/interrupt.hpp"
#include "sfumato/base/limits.hpp"
#include "sfumato/base/native/file.hpp"

namespace sfumato::cli {
namespace {

constexpr ExitMeaning kExitMeanings[] = {
    {kDone, "done"},
    {kBadInput, "bad input: it cannot be read, understood or drawn; or lint --strict found a hint"},
    {kBadUsage, "bad usage"},
    {kResource, "a limit was reached, memory ran out, or an output cannot be written"},
    {kInternal, "internal error; please report it"},
    {kSignalled + SIGINT, "interrupted (128 plus the number of the signal)"}};

/// Names of files may have any length, so messages are cut.
constexpr std::size_t kMostMessageBytes = std::size_t{16} << 10;

/// Returns the largest value of a limit whose default is the largest; otherwise none.
std::optional<std::uint64_t> highest_if_default(std::string_view limit) {
  const auto known = std::ranges::find(limit_names(), limit, &LimitName::name);
  if (known == limit_names().end() || Limits{}.*(known->value) < known->highest) return {};
  return known->highest;
}

/// Returns the advice against a limit: "; raise the limit with --limit curves=N".
std::string limit_advice(std::string_view limit) {
  if (limit.empty()) return {};
  if (limit == "memory") return "; raise the limit with --max-memory MIB";
  if (limit == "time") return "; raise the limit with --max-time SECONDS";
  const std::string name(limit);
  const std::optional<std::uint64_t> highest = highest_if_default(limit);
  std::string advice = highest ? "; --limit " + name + "=N goes up to " + std::to_string(*highest)
                               : "; raise the limit with --limit " + name + "=N";
  if (limit == "image-side") advice += "; use a smaller image";
  if (limit == "viewer-triangles") {
    advice += ", or make fewer with a larger --max-error or a smaller --scale or --viewport";
  }
  return advice;
}

std::string formatted(const SourcePlace& where, std::string_view severity,
                      const std::string& message) {
  std::string text = to_string(Diagnostic{{}, where});
  if (text.empty()) text = "sfumato: ";
  text += severity;
  text += ": " + message;
  if (text.size() > kMostMessageBytes) {
    // The place is at the beginning of the message and the fault at the end; both are kept.
    text = text.substr(0, kMostMessageBytes / 2) + "…" +
           text.substr(text.size() - kMostMessageBytes / 2);
  }
  return output_line(text);
}

}  // namespace

std::span<const ExitMeaning> exit_meanings() {
  return kExitMeanings;
}

int exit_code(const Status& status) {
  switch (status.code) {
    case StatusCode::ok:
      return kDone;
    case StatusCode::bad_input:
      return kBadInput;
    case StatusCode::limit:
    case StatusCode::io:
    case StatusCode::out_of_memory:
    case StatusCode::unavailable:
      return kResource;
    case StatusCode::cancelled:
      return kSignalled + received_signal();
    case StatusCode::internal:
      return kInternal;
  }
  return kInternal;
}

std::string format_message(const Status& status, std::string_view severity) {
  return formatted(status.where, severity, status.message + limit_advice(status.limit));
}

std::string format_message(const Diagnostic& diagnostic, std::string_view severity) {
  return formatted(diagnostic.where, severity, diagnostic.message);
}

std::string output_line(std::string_view text) {
  return printable(text) + '\n';
}

void report_error(const Status& status) {
  if (status.code != StatusCode::cancelled) {
    std::fputs(format_message(status, "error").c_str(), stderr);
  } else if (received_signal() == SIGXCPU) {
    std::fputs("sfumato: error: the processor time is used up; raise it with ulimit -t\n", stderr);
  } else {
    std::fputs("sfumato: interrupted\n", stderr);
  }
}

void report_warning(const Diagnostic& warning) {
  std::fputs(format_message(warning, "warning").c_str(), stderr);
}

Status print(std::string_view text, const Context* context) {
  return write_file("-", {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()},
                    context);
}

int fail(const Status& status) {
  report_error(status);
  return exit_code(status);
}

}  // namespace sfumato::cli
