#pragma once

#include <string>

namespace sfumato::cli {

/// Asks the desktop to open an address in a browser. The browser outlives this process and ignores
/// its terminal's signals. Returns false if no program can open it.
bool open_in_browser(const std::string& address);

}  // namespace sfumato::cli
