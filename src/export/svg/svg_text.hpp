#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "sfumato/base/affine.hpp"
#include "sfumato/base/vec2.hpp"

/// Compact text for SVG, since files of triangles are mostly numbers.
namespace sfumato::outputs {

/// The value rounded to a multiple of 10^power, without unnecessary zeros: "-.5", "1200".
/// Precondition: |value| below 1e15.
void append_number(std::string& text, double value, int power);

/// Two numbers, with a blank between them if the second has no sign.
void append_numbers(std::string& text, Vec2 values, int power);

/// Appends "M10 20l3-4 5 6z", with points rounded to whole numbers. Appends nothing if fewer than
/// three points differ from their predecessors, or if a point is not finite or beyond 2^53.
void append_closed_path(std::string& text, std::span<const Vec2> points);

/// Returns the id with this number: "a", "b", … "z", "aa".
std::string short_id(std::uint64_t number);

/// "#rrggbb" or "#rgb"; channels of 8 bits.
void append_color(std::string& text, int r, int g, int b);

/// transform="…" preceded by a blank; empty for the identity.
std::string transform_attribute(const Affine& map);

}  // namespace sfumato::outputs
