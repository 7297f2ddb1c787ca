#pragma once

#include <string>
#include <string_view>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::cli {

/// What the process returns (docs/cli.md).
enum ExitCode : int {
  kDone = 0,
  kBadInput = 1,
  kBadUsage = 2,
  kResource = 3,  ///< a limit, memory, or an output that cannot be written
  kInternal = 4,
  kSignalled = 128  ///< plus the signal's number: 130 for an interrupt
};

/// The exit code of a failure; `cancelled` gives kSignalled plus the number of the signal that
/// cancelled.
int exit_code(const Status& status);

/// "file:line:column: error: message" as compilers write it, or "sfumato: error: message" where no
/// place is known. One line with its newline; controls (base/utf8.hpp) become '?'. An error that
/// names its limit is followed by the option that sets another.
std::string format_message(const Status& status, std::string_view severity);
std::string format_message(const Diagnostic& diagnostic, std::string_view severity);

/// A line of output: without controls (base/utf8.hpp: they become '?'), with its newline.
std::string output_line(std::string_view text);

/// Writes a message to standard error. An error that says `cancelled` says only "interrupted".
void report_error(const Status& status);
void report_warning(const Diagnostic& warning);

/// Writes text to standard output. Errors: io, cancelled, limit for the deadline.
Status print(std::string_view text, const Context* context = nullptr);

/// Reports the failure and gives its exit code.
int fail(const Status& status);

}  // namespace sfumato::cli
