#pragma once

#include <span>
#include <string>
#include <vector>

#include "formats/svg/svg_write_text.hpp"
#include "sfumato/document/curve.hpp"
#include "sfumato/document/document.hpp"

/// Attributes of the elements that stand for curves, and values that others share.
namespace sfumato::svg {

/// Path data of cubics in absolute coordinates; a chain that ends where it begins is closed.
/// Precondition: 3 n + 1 points, n ≥ 1. Errors: cancelled.
Result<std::string> path_data(const Context& context, std::span<const Vec2> control_points);

/// Adds what the curve bears, and a stroke and a fill for other programs.
/// shader_id: per Document::shaders. Errors: cancelled.
Status add_curve(const Context& context, Attributes& attributes, const Curve& curve,
                 std::span<const std::string> shader_id);

/// Adds what the local curve bears, and a stroke for other programs. Errors: cancelled.
Status add_local_curve(const Context& context, Attributes& attributes, const LocalCurve& curve);

}  // namespace sfumato::svg
