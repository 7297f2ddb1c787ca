#pragma once

#include <span>
#include <string>
#include <string_view>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::cli {

/// The exit codes of the process (docs/cli.md); exit_meanings() says what they mean.
enum ExitCode : int {
  kDone = 0,
  kBadInput = 1,
  kBadUsage = 2,
  kResource = 3,
  kInternal = 4,
  kSignalled = 128  ///< plus the signal's number: 130 for an interrupt
};

/// The meaning of an exit code, for the help.
struct ExitMeaning {
  int code;
  const char* meaning;
};
std::span<const ExitMeaning> exit_meanings();

/// Returns the exit code of a failure; `cancelled` gives kSignalled plus the number of the signal.
int exit_code(const Status& status);

/// Returns "file:line:column: error: message" as compilers write it, or "sfumato: error: message"
/// if no place is known. The text is one line with its newline; control characters
/// (base/text/utf8.hpp) become '?'. If the error names a limit, the option that changes it is
/// appended.
std::string format_message(const Status& status, std::string_view severity);
std::string format_message(const Diagnostic& diagnostic, std::string_view severity);

/// Returns a line of output with its newline; control characters (base/text/utf8.hpp) become '?'.
std::string output_line(std::string_view text);

/// Writes a message to standard error. For `cancelled` it is "interrupted", or for SIGXCPU that the
/// processor time is used up.
void report_error(const Status& status);
void report_warning(const Diagnostic& warning);

/// Writes text to standard output. Errors: io, cancelled, limit for the deadline.
Status print(std::string_view text, const Context* context = nullptr);

/// Reports the failure and returns its exit code.
int fail(const Status& status);

}  // namespace sfumato::cli
