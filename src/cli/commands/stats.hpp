#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sfumato/solve/diffuse.hpp"
#include "sfumato/solve/solution.hpp"

namespace sfumato::cli {

/// Sizes and times of one `sfumato render`, as --stats reports them.
struct RenderStats {
  DiffuseStats diffuse;
  int width = 0, height = 0;            ///< of an image: pixels
  std::optional<FrameLayers> layers{};  ///< where frames are coherent
  int threads = 1;
  double read_seconds = 0;       ///< reading and parsing the input
  double rasterise_seconds = 0;  ///< picture to pixels
  double export_seconds = 0;     ///< picture to a file that is not made of pixels alone
  double write_seconds = 0;      ///< encoding and writing the output
  double total_seconds = 0;      ///< from the start of the command to the written output
};

/// Rounds a time, so that JSON shows no digits that no clock has.
double to_nanosecond(double seconds);

/// Returns the JSON object of docs/cli.md on one line, with its newline; `input`, if any, is a
/// member.
std::string to_json(const RenderStats& stats, std::string_view input = {});

}  // namespace sfumato::cli
