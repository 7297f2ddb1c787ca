#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::cli {

/// What a picture can be written as.
enum class OutputKind : std::uint8_t { png, jpeg, webp, html, pdf, eps, svg, glb };

/// Whether it is made of pixels alone.
constexpr bool is_image(OutputKind kind) {
  return kind <= OutputKind::webp;
}

/// The kind that the extension of `path` (in any case) stands for; nothing for "-".
std::optional<OutputKind> output_kind(const std::string& path);

/// The same of an extension without its dot: "png".
std::optional<OutputKind> kind_of_extension(std::string_view extension);

/// The extensions that output_kind knows, without their dots.
std::vector<std::string> known_extensions();

/// What names of an output may end in.
struct OutputNames {
  std::optional<OutputKind> only{};  ///< empty: any kind
  bool takes_dash = true;            ///< for standard output
};

/// What is wrong with the name of an output, and what it was probably meant to be; empty: nothing.
std::string complaint_about_output(const std::string& name, const OutputNames& names);

/// Fails early where `path` can certainly not be written: its folder is missing or not writable, or
/// it is a folder itself. Writes nothing. Errors: io.
Status check_output(const std::string& path);

/// Makes a folder, and those above it, where it is not there. Errors: io.
Status make_folder(const std::string& path);

/// The whole input, up to max_bytes; "-" is standard input.
/// Errors: bad_input where it cannot be read, limit, cancelled.
Result<std::string> read_input(const Context& context, const std::string& path,
                               std::size_t max_bytes);

/// How messages call an input: "<stdin>" for "-".
std::string display_name(const std::string& path);

}  // namespace sfumato::cli
