#pragma once

#include <string>
#include <string_view>

#include "sfumato/trace/trace.hpp"

namespace sfumato::cli {

/// Holds the figures of one `sfumato trace` for --stats and the last line.
struct TraceFacts {
  TraceStats trace;
  int threads = 1;
  double read_seconds = 0;   ///< reading and decoding the picture
  double trace_seconds = 0;  ///< making the drawing
  double write_seconds = 0;  ///< writing it
  double total_seconds = 0;  ///< from the start of the picture to the written drawing
};

/// Returns the JSON object of docs/cli.md on one line, with its newline; `input`, if any, is a
/// member.
std::string to_json(const TraceFacts& facts, std::string_view input = {});

/// Returns "30.6 dB", or "no difference" if the drawing equals the picture.
std::string psnr_text(double psnr_db);

/// Returns "drawing.svg: 312 curves, 1,998 points, 30.6 dB in 4.1 s".
std::string summary(const TraceFacts& facts, std::string_view output);

}  // namespace sfumato::cli
