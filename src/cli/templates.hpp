#pragma once

#include <span>
#include <string_view>

namespace sfumato::cli {

/// A drawing to begin with.
struct Template {
  std::string_view name;
  std::string_view document;
};

/// All, the one that is taken by default first. Those of docs/tutorial.md are its last steps.
std::span<const Template> templates();

}  // namespace sfumato::cli
