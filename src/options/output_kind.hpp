#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace sfumato::options {

/// The kinds of output files, and raw frames: pixels without a header, named as ffmpeg names them.
enum class OutputKind : std::uint8_t {
  png,
  jpeg,
  webp,
  rgb24,
  rgba,
  rgb48le,
  rgba64le,
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
  return kind <= OutputKind::rgba64le;
}

/// Whether it is a raw frame.
constexpr bool is_frame(OutputKind kind) {
  return kind >= OutputKind::rgb24 && kind <= OutputKind::rgba64le;
}

/// Whether pixels of the kind always have an alpha channel; others have one where it is needed, if
/// they know_alpha().
constexpr bool has_alpha(OutputKind kind) {
  return kind == OutputKind::rgba || kind == OutputKind::rgba64le;
}

/// Where not, what is transparent stands on white.
constexpr bool knows_alpha(OutputKind kind) {
  return kind != OutputKind::jpeg && kind != OutputKind::eps && kind != OutputKind::rgb24 &&
         kind != OutputKind::rgb48le;
}

/// Whether a channel of the kind has 16 bits whatever is asked for.
constexpr bool is_deep_frame(OutputKind kind) {
  return kind == OutputKind::rgb48le || kind == OutputKind::rgba64le;
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

/// All extensions of files that are known.
std::span<const KnownOutput> known_outputs();

/// Those of raw frames: "rgb24".
std::span<const KnownOutput> known_frames();

/// The kind for an extension, in any case and without its dot: "png".
std::optional<OutputKind> kind_of_extension(std::string_view extension);

/// The same for raw frames.
std::optional<OutputKind> frame_of_extension(std::string_view extension);

/// What ffmpeg calls pixels of raw frames.
std::string_view name_of_frame(OutputKind kind);

}  // namespace sfumato::options
