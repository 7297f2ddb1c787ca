#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "base/status.hpp"

namespace sfumato::cli {

/// What an output's extension says is to be made.
enum class OutputKind : std::uint8_t { png };

/// The kind that the extension of `path` (in any case) stands for; "-" is a PNG.
std::optional<OutputKind> output_kind(const std::string& path);

/// The extensions that output_kind knows, for messages: ".png".
std::string known_extensions();

/// Fails early where `path` can certainly not be written: its folder is missing or not writable, or
/// it is a folder itself. Writes nothing. Errors: io.
Status check_output(const std::string& path);

/// The whole input, up to max_bytes; "-" is standard input.
/// Errors: bad_input where it cannot be read, limit.
Result<std::string> read_input(const std::string& path, std::size_t max_bytes);

/// How messages call an input: "<stdin>" for "-".
std::string display_name(const std::string& path);

}  // namespace sfumato::cli
