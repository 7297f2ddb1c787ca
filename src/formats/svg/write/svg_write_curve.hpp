#pragma once

#include <span>
#include <string>

#include "formats/svg/write/svg_write_text.hpp"
#include "sfumato/document/curve.hpp"
#include "sfumato/document/document.hpp"

/// Attributes of the elements that represent curves, and values that other elements share.
namespace sfumato::svg {

/// Adds the curve's attributes, and a stroke and a fill for other programs. shader_id: per
/// Document::shaders. Errors: limit (memory), cancelled.
Status add_curve(const Context& context, Attributes& attributes, const Curve& curve,
                 std::span<const std::string> shader_id);

/// Adds the local curve's attributes, and a stroke for other programs. Errors: the same.
Status add_local_curve(const Context& context, Attributes& attributes, const LocalCurve& curve);

}  // namespace sfumato::svg
