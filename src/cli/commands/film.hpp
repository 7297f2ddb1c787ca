#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/native/file_stream.hpp"
#include "cli/commands/jobs.hpp"
#include "cli/commands/stats.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::cli {

/// Writes raw frames of one size, one after another, to a file or a pipe.
class Film {
 public:
  /// hints: prints once, on stderr, the options for ffmpeg to read the frames
  Film(const std::string& path, OutputKind kind, bool hints)
      : stream_(path), kind_(kind), hints_(hints) {}

  /// Appends the frame of a drawing. `stats` has its size in pixels. Errors: bad_input (its size
  /// differs from the first frame's), io, cancelled.
  Status add(const Context& context, const Job& job, std::span<const std::uint8_t> frame,
             const RenderStats& stats);

  /// Ends the film after the last frame. A film without frames is an empty file. Errors: io,
  /// cancelled.
  Status close(const Context& context);

 private:
  FileStream stream_;
  OutputKind kind_;
  bool hints_;
  std::string first_;  ///< the drawing of the first frame; empty: there is none yet
  int width_ = 0, height_ = 0;
};

}  // namespace sfumato::cli
