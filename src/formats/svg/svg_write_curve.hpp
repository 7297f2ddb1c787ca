#pragma once

#include <span>
#include <string>
#include <vector>

#include "formats/svg/svg_write_text.hpp"
#include "sfumato/document/curve.hpp"
#include "sfumato/document/document.hpp"

/// Attributes of the elements that stand for curves, and values that others share.
namespace sfumato::svg {

/// Adds what the curve bears, and a stroke and a fill for other programs.
/// shader_id: per Document::shaders. Errors: limit (memory), cancelled.
Status add_curve(const Context& context, Attributes& attributes, const Curve& curve,
                 std::span<const std::string> shader_id);

/// Adds what the local curve bears, and a stroke for other programs. Errors: the same.
Status add_local_curve(const Context& context, Attributes& attributes, const LocalCurve& curve);

}  // namespace sfumato::svg
