#pragma once

#include <string>

#include "sfumato/base/status.hpp"

namespace sfumato {

/// Creates a folder and its parents if they do not exist. Errors: io.
Status make_folder(const std::string& path);

}  // namespace sfumato
