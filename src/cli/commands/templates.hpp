#pragma once

#include <array>
#include <string_view>

namespace sfumato::cli {

/// The drawings to start from: src/cli/templates/NAME.svg. The first is the default. Those for
/// docs/tutorial.md are its last steps.
inline constexpr std::array<std::string_view, 5> kTemplates{"shape", "sky", "sphere", "eye",
                                                            "logo"};

}  // namespace sfumato::cli
