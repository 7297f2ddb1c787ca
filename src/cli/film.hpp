#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "base/native/file_stream.hpp"
#include "cli/jobs.hpp"
#include "cli/stats.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::cli {

/// Raw frames of one size, one behind the other in a file or a pipe.
class Film {
 public:
  /// hints   tells once, on stderr, by which options ffmpeg reads the frames
  Film(const std::string& path, OutputKind kind, bool hints)
      : stream_(path), kind_(kind), hints_(hints) {}

  /// Appends the frame of a drawing, whose size in pixels is in its figures. Errors: bad_input (it
  /// has another size than the first one), io, cancelled.
  Status add(const Context& context, const Job& job, std::span<const std::uint8_t> frame,
             const RenderStats& stats);

  /// After the last frame. A film without any is an empty file. Errors: io, cancelled.
  Status close(const Context& context);

 private:
  FileStream stream_;
  OutputKind kind_;
  bool hints_;
  std::string first_;  ///< the drawing of the first frame; empty: there is none yet
  int width_ = 0, height_ = 0;
};

}  // namespace sfumato::cli
