#pragma once

#include <string>

#include "cli/options/arguments.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"
#include "sfumato/picture/picture_file.hpp"

namespace sfumato::cli {

/// A solved picture as a command reads it.
struct SolvedInput {
  Picture picture;
  PictureOrigin origin;
};

/// Reads a solved picture from the bytes of arguments.input. Errors: bad_input (also for options
/// that apply to drawings only), limit, cancelled, out_of_memory.
Result<SolvedInput> read_solved(const Context& context, const RenderArguments& arguments,
                                const std::string& bytes);

/// Does the same without options.
Result<SolvedInput> read_solved(const Context& context, const std::string& input,
                                const std::string& bytes);

/// Returns a warning if a picture is drawn larger than it was solved for; empty otherwise. Scales
/// are pixels per user unit.
std::string complaint_about_scale(double solved_scale, double drawn_scale);

}  // namespace sfumato::cli
