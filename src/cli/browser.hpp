#pragma once

#include <string>

namespace sfumato::cli {

/// Asks the desktop to open an address in a browser, which outlives this process and its terminal's
/// signals. false: there is no program that would.
bool open_in_browser(const std::string& address);

}  // namespace sfumato::cli
