#pragma once

#include <string>

#include "cli/arguments.hpp"
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

/// Reads the bytes of arguments.input, which are a solved picture's. Errors: bad_input, also where
/// there are options that only a drawing has a use for; limit, cancelled, out_of_memory.
Result<SolvedInput> read_solved(const Context& context, const RenderArguments& arguments,
                                const std::string& bytes);

/// The same without options.
Result<SolvedInput> read_solved(const Context& context, const std::string& input,
                                const std::string& bytes);

/// What is told where a picture is drawn larger than it was solved for; empty: nothing. Scales are
/// pixels per user unit.
std::string complaint_about_scale(double solved_scale, double drawn_scale);

}  // namespace sfumato::cli
