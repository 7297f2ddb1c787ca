#pragma once

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

/// The errors of shapes that need too much work. They name their limits.
namespace sfumato::svg_import {

/// Returns the error of a shape with more than Limits::chords chords.
Status too_long(const Context& context);

/// Returns the error of a shape with more than Limits::chords chords once it is cut at its
/// crossings.
Status has_too_many_crossings(const Context& context);

/// Returns the error of a shape with more than Limits::chord_pairs pairs.
Status has_too_many_pairs(const Context& context);

}  // namespace sfumato::svg_import
