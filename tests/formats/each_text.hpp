#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

namespace sfumato::test {

/// Expects that of(text) is `expected` for each of the texts.
template <class Of, class Value>
void expect_of_each(std::initializer_list<std::string> texts, Of of, const Value& expected) {
  for (const std::string& text : texts) EXPECT_EQ(of(text), expected) << text;
}

}  // namespace sfumato::test
