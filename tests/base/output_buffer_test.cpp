#include "base/output_buffer.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace sfumato {
namespace {

std::string text_of(const std::vector<std::uint8_t>& bytes) {
  return {bytes.begin(), bytes.end()};
}

TEST(OutputBuffer, holds_what_was_written_in_its_order) {
  Context context;
  OutputBuffer out(context, "a file");
  std::string expected;
  for (int i = 0; i < 30'000; ++i) {
    out += "line ";
    out += std::to_string(i);
    out += '\n';
    expected += "line " + std::to_string(i) + '\n';
  }
  const std::string large(300'000, 'x');
  out += large;
  EXPECT_EQ(out.size(), expected.size() + large.size());
  const auto file = out.finish();
  ASSERT_TRUE(file.ok());
  EXPECT_EQ(text_of(*file), expected + large);
}

TEST(OutputBuffer, charges_its_room_and_gives_it_back) {
  Context context;
  {
    OutputBuffer out(context, "a file");
    for (int i = 0; i < 1000; ++i) out += "a few bytes";
    EXPECT_GE(context.budget.used(), out.size());
    EXPECT_LE(context.budget.used(), 2 * out.size());
  }
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(OutputBuffer, a_failure_stays_and_gives_the_room_back) {
  Context context{.budget = Budget(1000)};
  OutputBuffer out(context, "a file");
  out += std::string(600, 'x');
  ASSERT_TRUE(out.status().ok());
  out += std::string(600, 'x');
  EXPECT_EQ(out.status().code, StatusCode::limit);
  EXPECT_NE(out.status().message.find("a file"), std::string::npos) << out.status().message;
  EXPECT_EQ(context.budget.used(), 0u);
  out += 'y';
  EXPECT_EQ(out.size(), 0u);
  EXPECT_EQ(out.finish().status().code, StatusCode::limit);
}

TEST(OutputBuffer, keeps_the_first_reason_to_fail) {
  Context context;
  OutputBuffer out(context, "a file");
  out.fail(ok_status());
  EXPECT_TRUE(out.status().ok());
  out.fail(make_error(StatusCode::bad_input, "first"));
  out.fail(make_error(StatusCode::bad_input, "second"));
  EXPECT_EQ(out.finish().status().message, "first");
}

TEST(OutputBuffer, a_large_piece_looks_at_the_cancel_flag) {
  Context context;
  OutputBuffer out(context, "a file");
  context.cancel = true;
  out += std::string(1'000'000, 'x');
  EXPECT_EQ(out.status().code, StatusCode::cancelled);
}

TEST(OutputBuffer, makes_room_before_it_is_needed) {
  Context context;
  OutputBuffer out(context, "a file");
  out.reserve(1'000'000);
  const std::size_t used = context.budget.used();
  EXPECT_GE(used, 1'000'000u);
  for (int i = 0; i < 1000; ++i) out += std::string(1000, 'x');
  EXPECT_EQ(context.budget.used(), used);
}

}  // namespace
}  // namespace sfumato
