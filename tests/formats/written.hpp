#pragma once

#include <gtest/gtest.h>

#include <string>

#include "sfumato/formats/svg/svg_write.hpp"

namespace sfumato::test {

/// Returns the document as SVG.
inline std::string written(const Document& document) {
  Context context;
  const Result<std::string> text = write_svg(context, document);
  EXPECT_TRUE(text.ok()) << to_string(text.status());
  return text ? *text : std::string();
}

}  // namespace sfumato::test
