#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "options/output_kind.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::cli {

using options::OutputKind;

/// Returns the kind for the extension of `path` (in any case); no value for "-".
std::optional<OutputKind> output_kind(const std::string& path);

/// Returns the kind for an extension without its dot, in any case.
std::optional<OutputKind> kind_of_format(const std::string& extension);

/// The allowed endings of output names.
struct OutputNames {
  std::optional<OutputKind> only{};  ///< empty: any kind
  bool is_solved = false;            ///< .sfp alone, instead of a kind
  bool takes_dash = true;            ///< for standard output
  bool takes_packed = false;         ///< .svgz as well
  bool takes_frames = false;         ///< raw frames as well
};

/// Returns whether the name is the name of an SVG packed by gzip: .svgz.
bool is_packed_name(const std::string& path);

/// The extension of solved pictures, without its dot.
inline constexpr const char* kSolvedExtension = "sfp";

/// Returns the extensions of these names, without their dots.
std::vector<std::string_view> extensions_of(const OutputNames& names);

/// Returns a message if the name of an output is not allowed, with the name that was probably
/// meant. Empty: the name is allowed.
std::string complaint_about_output(const std::string& name, const OutputNames& names);

/// Fails early if `path` certainly cannot be written: its folder is missing or not writable, or it
/// is a folder. Writes nothing. Errors: io.
Status check_output(const std::string& path);

/// Reads the whole input, up to max_bytes; "-" is standard input. Errors: bad_input if it cannot be
/// read, with the file that was probably meant; limit, cancelled.
Result<std::string> read_input(const Context& context, const std::string& path,
                               std::size_t max_bytes);

/// Returns the name of an input in messages: "<stdin>" for "-".
std::string display_name(const std::string& path);

/// Returns the status, with the name of the input if it failed without naming a file.
Status naming(const std::string& input, Status status);

}  // namespace sfumato::cli
