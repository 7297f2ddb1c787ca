#pragma once

#include <gtest/gtest.h>

#include <utility>

#include "sfumato/solve/diffuse.hpp"

namespace sfumato::test {

/// The picture that diffuse() makes of a document, in a Context of its own.
inline Picture diffused(const Document& document, const DiffuseOptions& options = {},
                        DiffuseStats* stats = nullptr) {
  Context context;
  Result<Picture> picture = diffuse(context, document, options, stats);
  EXPECT_TRUE(picture.ok()) << to_string(picture.status());
  return picture ? std::move(*picture) : Picture{};
}

}  // namespace sfumato::test
