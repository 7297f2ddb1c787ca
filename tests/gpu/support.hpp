#pragma once

#include <gtest/gtest.h>

#include "gpu/device.hpp"

/// Skips a test where there is no context of OpenGL ES 3.
#define SFUMATO_NEEDS_GPU()                                                        \
  if (const auto found = sfumato::gpu::Device::create(); !found) {                 \
    ASSERT_EQ(found.status().code, sfumato::StatusCode::unavailable);              \
    GTEST_SKIP() << found.status().message << " (libgl1-mesa-dri is enough here)"; \
  }
