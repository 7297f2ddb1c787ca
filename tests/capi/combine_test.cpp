#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "capi/handles.hpp"

/// sfumato_combine_paths() combines regions that are written as path data.
namespace sfumato::test {
namespace {

constexpr const char* kSquare = "M0 0H10V10H0Z";
constexpr const char* kShifted = "M5 5h10v10h-10z";

std::string combined(const char* operation, const char* first, const char* second,
                     double tolerance = 1e-3) {
  const ContextHandle context = context_of();
  sfumato_bytes* path = nullptr;
  const std::int32_t code =
      sfumato_combine_paths(context.get(), operation, first, second, tolerance, &path);
  const BytesHandle handle(path);
  if (code != SFUMATO_OK) {
    EXPECT_EQ(path, nullptr);
    return std::to_string(code) + " " + sfumato_error_text(context.get());
  }
  return text_of(handle.get());
}

std::size_t count(const std::string& text, char letter) {
  return static_cast<std::size_t>(std::ranges::count(text, letter));
}

TEST(CombinePaths, makes_the_four_combinations) {
  EXPECT_EQ(count(combined("unite", kSquare, kShifted), 'C'), 1U);
  const std::string corner = combined("intersect", kSquare, kShifted);
  EXPECT_EQ(count(corner, 'Z'), 1U);
  EXPECT_NE(corner.find("5 10"), std::string::npos) << corner;
  EXPECT_NE(corner.find("10 5"), std::string::npos) << corner;
  EXPECT_EQ(corner.find("15"), std::string::npos) << corner;
  EXPECT_EQ(count(combined("subtract", kSquare, kShifted), 'Z'), 1U);
  const std::string either = combined("exclude", kSquare, kShifted);
  EXPECT_NE(either.find("15 15"), std::string::npos) << either;
  EXPECT_EQ(combined("intersect", either.c_str(), corner.c_str()), "");
}

TEST(CombinePaths, makes_a_hole_or_nothing) {
  EXPECT_EQ(count(combined("subtract", kSquare, "M2 2h3v3h-3z"), 'Z'), 2U);
  EXPECT_EQ(combined("subtract", "M2 2h3v3h-3z", kSquare), "");
  EXPECT_EQ(combined("intersect", kSquare, "M20 0h5v5h-5z"), "");
  EXPECT_EQ(combined("intersect", kSquare, ""), "");
  EXPECT_EQ(count(combined("unite", kSquare, ""), 'Z'), 1U);
}

TEST(CombinePaths, takes_arcs_and_open_paths) {
  const char* circle = "M0 5A5 5 0 0 1 10 5A5 5 0 0 1 0 5Z";
  EXPECT_EQ(count(combined("subtract", circle, "M3 5A5 5 0 0 1 13 5A5 5 0 0 1 3 5"), 'Z'), 1U);
  EXPECT_EQ(count(combined("unite", "M0 0L10 0L10 10", kShifted), 'Z'), 1U);
}

TEST(CombinePaths, answers_wrong_values) {
  EXPECT_NE(combined("union", kSquare, kShifted).find("use unite, intersect"), std::string::npos);
  EXPECT_EQ(combined("unite", "M0 0L", kShifted)[0], '1');
  EXPECT_EQ(combined("unite", "M0 0L9 9e9L9 0Z", kShifted)[0], '1');
  EXPECT_EQ(combined("unite", kSquare, kShifted, 0)[0], '1');
  EXPECT_EQ(combined("unite", kSquare, kShifted, -1)[0], '1');
  const ContextHandle context = context_of();
  sfumato_bytes* path = nullptr;
  EXPECT_EQ(sfumato_combine_paths(context.get(), nullptr, kSquare, kShifted, 1, &path),
            SFUMATO_BAD_USAGE);
  EXPECT_EQ(sfumato_combine_paths(context.get(), "unite", nullptr, kShifted, 1, &path),
            SFUMATO_BAD_USAGE);
  EXPECT_EQ(sfumato_combine_paths(context.get(), "unite", kSquare, kShifted, 1, nullptr),
            SFUMATO_BAD_USAGE);
  EXPECT_EQ(sfumato_combine_paths(nullptr, "unite", kSquare, kShifted, 1, &path),
            SFUMATO_BAD_USAGE);
}

}  // namespace
}  // namespace sfumato::test
