#pragma once

#include <string_view>

/// The three files of the page of `sfumato watch`.
namespace sfumato::cli::watch_page {

extern const std::string_view kHtml;
extern const std::string_view kStyle;
extern const std::string_view kScript;

}  // namespace sfumato::cli::watch_page
