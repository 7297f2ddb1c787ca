#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "cli/solved_input.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/color.hpp"
#include "sfumato/base/color_space.hpp"

/// What `sfumato info` prints: lines that drawings and solved pictures share, and all of the
/// latter.
namespace sfumato::cli {

/// A line of the table, with its newline.
std::string table_row(std::string label, const std::string& content);

/// The shortest decimal.
std::string shortest(double number);

/// "640 x 480", and where it does not begin at the origin " at 10,20".
std::string size_text(const Box& box);

const char* interpolation_name(InterpolationSpace space);

/// "#rrggbb" or "none".
std::string background_text(const std::optional<Rgb>& background);

/// All about a solved picture, as a table or as a JSON object on one line.
/// name   of the file; bytes: its size
std::string solved_text(const std::string& name, const SolvedInput& solved, std::size_t bytes,
                        bool as_json);

}  // namespace sfumato::cli
