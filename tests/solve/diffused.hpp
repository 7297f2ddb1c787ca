#pragma once

#include <gtest/gtest.h>

#include <utility>

#include "sfumato/solve/diffuse.hpp"

namespace sfumato::test {

/// The picture that diffuse() makes of a document, in a Context of its own.
inline Picture diffused(const Document& document, const DiffuseOptions& options = {}) {
  Context context;
  Result<Picture> picture = diffuse(context, document, options);
  EXPECT_TRUE(picture.ok()) << to_string(picture.status());
  return std::move(*picture);
}

}  // namespace sfumato::test
