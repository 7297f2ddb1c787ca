#include "cli/messages.hpp"

#include <cstdio>

#include "base/utf8.hpp"
#include "cli/interrupt.hpp"
#include "sfumato/base/native/file.hpp"

namespace sfumato::cli {
namespace {

/// Names of files are as long as who calls likes.
constexpr std::size_t kMostMessageBytes = std::size_t{16} << 10;

/// What of the command helps against a limit: " (--limit curves=N sets another)".
std::string limit_advice(std::string_view limit) {
  if (limit.empty()) return {};
  if (limit == "memory") return " (--max-memory sets another)";
  if (limit == "time") return " (--max-time sets another)";
  const std::string advice = " (--limit " + std::string(limit) + "=N sets another";
  if (limit != "viewer-triangles") return advice + ")";
  return advice + "; a larger --max-error, a smaller --scale or --viewport makes fewer)";
}

std::string formatted(const SourcePlace& where, std::string_view severity,
                      const std::string& message) {
  std::string text = to_string(Diagnostic{{}, where});
  if (text.empty()) text = "sfumato: ";
  text += severity;
  text += ": " + message;
  if (text.size() > kMostMessageBytes) {
    // The place stands at the beginning, what is wrong at the end.
    text = text.substr(0, kMostMessageBytes / 2) + "…" +
           text.substr(text.size() - kMostMessageBytes / 2);
  }
  return output_line(text);
}

}  // namespace

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
  const bool cancelled = status.code == StatusCode::cancelled;
  const std::string text = cancelled ? "sfumato: interrupted\n" : format_message(status, "error");
  std::fputs(text.c_str(), stderr);
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
