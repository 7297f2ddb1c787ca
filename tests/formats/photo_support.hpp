#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "codecs/photo/photo.hpp"
#include "formats/png_chunks.hpp"

namespace sfumato::test {

using Warnings = std::vector<Diagnostic>;

/// Returns the image of a file's bytes, or the error.
inline Result<Image> photo_in(const Bytes& file, Warnings* warnings = nullptr) {
  Context context;
  Result<Image> image = codecs::read_photo(context, file, "a.file", warnings);
  EXPECT_EQ(context.budget.used(), 0u);
  return image;
}

}  // namespace sfumato::test
