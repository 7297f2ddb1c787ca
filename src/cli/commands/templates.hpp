#pragma once

#include <span>
#include <string_view>

namespace sfumato::cli {

/// A drawing to start from.
struct Template {
  std::string_view name;
  std::string_view document;
};

/// Returns all templates; the first is the default. Those for docs/tutorial.md are its last steps.
std::span<const Template> templates();

/// Returns their names.
std::span<const std::string_view> template_names();

}  // namespace sfumato::cli
