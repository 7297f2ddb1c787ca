#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato {

/// The version of the layout that write_picture() writes, and the only one that read_picture()
/// reads.
inline constexpr std::uint8_t kPictureFileVersion = 2;

/// Facts about the drawing and the options of a picture, for its outputs.
struct PictureOrigin {
  Vec2 own_scale{1, 1};        ///< pixels per user unit at the drawing's own size, above 0
  double pixels_per_unit = 1;  ///< DiffuseOptions::pixels_per_unit, above 0
  double max_error = 1;        ///< DiffuseOptions::max_error, 0 to 255

  /// Compares exactly.
  friend bool operator==(const PictureOrigin&, const PictureOrigin&) = default;
};

/// The factor for the longest picture file that is written or read: a solved picture may be this
/// many times as long as the text of a drawing, Limits::input_bytes.
inline constexpr std::size_t kPictureFileFactor = 16;

/// Returns whether these are the first bytes of a picture file, of any version.
bool is_picture_file(std::span<const std::uint8_t> bytes);

/// Writes a picture as a file, which read_picture() reads bit for bit (docs/picture-file.md). Use
/// it to solve a drawing once and draw it many times, also in other processes. The same picture
/// gives the same bytes on every machine of one byte order. Errors: bad_input (a picture that
/// cannot be painted, numbers that are not finite), limit, cancelled, out_of_memory.
Result<std::vector<std::uint8_t>> write_picture(const Context& context, const Picture& picture,
                                                const PictureOrigin& origin = {});

/// Reads a picture file. All of its content is checked as hostile input: the result can be painted
/// and exported.
///
/// - `bytes`: at any address
/// - `origin`: unless null, written on success
///
/// Errors: bad_input (not a picture file, of a later version, of the other byte order, cut off,
/// damaged), limit (kPictureFileFactor × Limits::input_bytes, layers, triangles, nodes, shaders,
/// stack, memory), cancelled, out_of_memory.
Result<Picture> read_picture(const Context& context, std::span<const std::uint8_t> bytes,
                             PictureOrigin* origin = nullptr);

}  // namespace sfumato
