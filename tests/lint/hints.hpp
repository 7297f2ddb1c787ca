#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "sfumato/lint/lint.hpp"

namespace sfumato::test {

/// The middle of the artboard of one_layer().
inline constexpr Vec2 kMiddle{50, 50};

inline std::vector<Hint> hints_of(const Document& document) {
  Context context;
  Result<std::vector<Hint>> hints = lint(context, document);
  EXPECT_TRUE(hints.ok()) << hints.status().message;
  return hints ? *hints : std::vector<Hint>();
}

inline std::vector<Hint> of_kind(const std::vector<Hint>& hints, HintKind kind) {
  std::vector<Hint> found;
  std::ranges::copy_if(hints, std::back_inserter(found),
                       [kind](const Hint& hint) { return hint.kind == kind; });
  return found;
}

inline std::size_t count(const Document& document, HintKind kind) {
  return of_kind(hints_of(document), kind).size();
}

}  // namespace sfumato::test
