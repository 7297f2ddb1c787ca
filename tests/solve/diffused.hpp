#pragma once

#include <gtest/gtest.h>

#include <utility>

#include "sfumato/solve/diffuse.hpp"

namespace sfumato::test {

/// Returns the picture of diffuse() for a document, in a new Context.
inline Picture diffused(const Document& document, const DiffuseOptions& options = {},
                        DiffuseStats* stats = nullptr) {
  Context context;
  Result<Picture> picture = diffuse(context, document, options, stats);
  EXPECT_TRUE(picture.ok()) << to_string(picture.status());
  return picture ? std::move(*picture) : Picture{};
}

}  // namespace sfumato::test
