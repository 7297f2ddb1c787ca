#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace sfumato::options {

/// The kinds of output files.
enum class OutputKind : std::uint8_t {
  png,
  jpeg,
  webp,
  html,
  pdf,
  eps,
  svg,
  glb,
  sfv,
  npz,
  ply,
  json
};

/// Whether the kind consists of pixels alone.
constexpr bool is_image(OutputKind kind) {
  return kind <= OutputKind::webp;
}

/// Whether the kind is the solution itself, as tables of numbers.
constexpr bool is_table(OutputKind kind) {
  return kind >= OutputKind::npz;
}

/// An extension, in lower case and without its dot, and what it stands for.
struct KnownOutput {
  std::string_view extension;
  OutputKind kind;
};

/// All extensions that are known.
std::span<const KnownOutput> known_outputs();

/// The kind for an extension, in any case and without its dot: "png".
std::optional<OutputKind> kind_of_extension(std::string_view extension);

}  // namespace sfumato::options
