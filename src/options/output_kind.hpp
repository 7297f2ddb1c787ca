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

/// Returns whether the kind consists of pixels alone.
constexpr bool is_image(OutputKind kind) {
  return kind <= OutputKind::rgba64le;
}

/// Returns whether it is a raw frame.
constexpr bool is_frame(OutputKind kind) {
  return kind >= OutputKind::rgb24 && kind <= OutputKind::rgba64le;
}

/// Returns whether pixels of the kind always have an alpha channel. Other kinds have one only if it
/// is needed and they know_alpha().
constexpr bool has_alpha(OutputKind kind) {
  return kind == OutputKind::rgba || kind == OutputKind::rgba64le;
}

/// Returns whether the kind can have an alpha channel. Without one, transparent parts are drawn on
/// white.
constexpr bool knows_alpha(OutputKind kind) {
  return kind != OutputKind::jpeg && kind != OutputKind::eps && kind != OutputKind::rgb24 &&
         kind != OutputKind::rgb48le;
}

/// Returns whether a channel of the kind always has 16 bits.
constexpr bool is_deep_frame(OutputKind kind) {
  return kind == OutputKind::rgb48le || kind == OutputKind::rgba64le;
}

/// Returns whether the kind is the solution itself, as tables of numbers.
constexpr bool is_table(OutputKind kind) {
  return kind >= OutputKind::npz;
}

/// An extension, in lower case and without its dot, and what it stands for.
struct KnownOutput {
  std::string_view extension;
  OutputKind kind;
};

/// Returns all known extensions of files.
std::span<const KnownOutput> known_outputs();

/// Returns the known extensions of raw frames: "rgb24".
std::span<const KnownOutput> known_frames();

/// Returns the extensions of known_outputs(), followed by those of known_frames().
std::span<const std::string_view> known_formats();

/// Returns the kind for an extension, in any case and without its dot: "png".
std::optional<OutputKind> kind_of_extension(std::string_view extension);

/// Returns the same for raw frames.
std::optional<OutputKind> frame_of_extension(std::string_view extension);

/// Returns ffmpeg's name for the pixels of raw frames.
std::string_view name_of_frame(OutputKind kind);

}  // namespace sfumato::options
