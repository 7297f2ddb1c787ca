#pragma once

#include <cstdint>
#include <vector>

#include "sfumato/sfumato.h"

struct sfumato_bytes {
  std::vector<std::uint8_t> bytes;
};
