#include "equal/tool/difference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace sfumato::test {
namespace {

const std::vector<Vec2> kPlaces = {{1, 2}, {3, 4.5}, {5, 6}};

/// Returns two stages: three points, then two floats at each.
Trace small_trace() {
  return {points("layer 0, mesh: vertices", kPlaces),
          numbers("layer 0, round 0: color node values",
                  std::vector<float>{0, 0.25f, 0.5f, 0.75f, 1, 2}, 2, kPlaces)};
}

Trace with_values(std::vector<float> values) {
  Trace trace = small_trace();
  trace[1] = numbers(trace[1].stage, values, 2, kPlaces);
  return trace;
}

TEST(Differences, are_none_between_the_same_bits) {
  EXPECT_FALSE(first_difference(small_trace(), small_trace()));
  EXPECT_FALSE(first_difference({}, {}));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(first_difference(with_values({nan}), with_values({nan})));
}

TEST(Differences, name_stage_item_place_and_bits_of_the_first_number) {
  const Trace b = with_values({0, 0.25f, 0.5f, std::nextafter(0.75f, 1.0f), 1, 3});
  const auto difference = first_difference(small_trace(), b);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->stage, "layer 0, round 0: color node values");
  EXPECT_EQ(difference->item, 1u);
  EXPECT_EQ(difference->channel, 1u);
  EXPECT_EQ(difference->position, (Vec2{3, 4.5}));
  EXPECT_EQ(difference->value[0], "0x3f400000 = 0.75");
  EXPECT_EQ(difference->value[1], "0x3f400001 = 0.75000006");
  EXPECT_EQ(difference->differing, 2u);
  EXPECT_EQ(to_string(*difference),
            "first differing stage: layer 0, round 0: color node values\n"
            "  item 1, number 1, at (3, 4.5)\n"
            "  a: 0x3f400000 = 0.75\n"
            "  b: 0x3f400001 = 0.75000006\n"
            "  numbers that differ: 2 of 6\n");
}

TEST(Differences, of_an_earlier_stage_go_before_those_of_a_later_one) {
  Trace b = with_values({9, 9, 9, 9, 9, 9});
  b[0] = points(b[0].stage, {{1, 2}, {3, 4.5}, {5, 6.5}});
  const auto difference = first_difference(small_trace(), b);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->stage, "layer 0, mesh: vertices");
  EXPECT_EQ(difference->item, 2u);
  EXPECT_EQ(difference->channel, 1u);
  EXPECT_EQ(difference->value[0], "0x4018000000000000 = 6");
  EXPECT_EQ(difference->value[1], "0x401a000000000000 = 6.5");
}

TEST(Differences, are_told_between_zeros_of_different_sign) {
  const auto difference = first_difference(with_values({0.0f}), with_values({-0.0f}));
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->value[1], "0x80000000 = -0");
}

TEST(Differences, of_length_are_at_the_end_of_the_shorter_unless_something_differs_before) {
  const auto longer = first_difference(with_values({1, 2, 3}), with_values({1, 2, 3, 4}));
  ASSERT_TRUE(longer);
  EXPECT_EQ(longer->item, 1u);
  EXPECT_EQ(longer->channel, 1u);
  EXPECT_EQ(longer->value[0], "nothing");
  EXPECT_EQ(longer->value[1], "0x40800000 = 4");
  EXPECT_EQ(longer->differing, 1u);
  EXPECT_EQ(longer->position, (Vec2{3, 4.5}));

  const auto both = first_difference(with_values({1, 7, 3}), with_values({1, 2}));
  ASSERT_TRUE(both);
  EXPECT_EQ(both->item, 0u);
  EXPECT_EQ(both->value[1], "0x40000000 = 2");
  EXPECT_EQ(both->differing, 2u);
}

TEST(Differences, of_steps_that_one_trace_lacks_are_told) {
  Trace b = small_trace();
  b.pop_back();
  const auto missing = first_difference(small_trace(), b);
  ASSERT_TRUE(missing);
  EXPECT_EQ(missing->value[0], "layer 0, round 0: color node values, f32 by 2");
  EXPECT_EQ(missing->value[1], "nothing");

  b = small_trace();
  b[1].stage = "layer 0, round 1: color node values";
  EXPECT_TRUE(first_difference(small_trace(), b));
  b = small_trace();
  b[1].width = 3;
  EXPECT_TRUE(first_difference(small_trace(), b));
}

TEST(Differences, of_whole_numbers_show_them) {
  const auto difference_of = [](auto a, auto b) {
    const auto difference =
        first_difference({numbers("n", std::vector{a}, 1)}, {numbers("n", std::vector{b}, 1)});
    return difference ? difference->value[0] + ", " + difference->value[1] : "none";
  };
  EXPECT_EQ(difference_of(std::uint8_t{7}, std::uint8_t{8}), "0x07 = 7, 0x08 = 8");
  EXPECT_EQ(difference_of(std::uint16_t{7}, std::uint16_t{65535}), "0x0007 = 7, 0xffff = 65535");
  EXPECT_EQ(difference_of(std::uint32_t{7}, 4294967295u),
            "0x00000007 = 7, 0xffffffff = 4294967295");
  EXPECT_EQ(difference_of(7, -1), "0x00000007 = 7, 0xffffffff = -1");
}

TEST(Traces, are_read_as_they_are_written) {
  const Result<Trace> read = parse_trace(trace_bytes(small_trace()));
  ASSERT_TRUE(read.ok());
  EXPECT_FALSE(first_difference(small_trace(), *read));
  EXPECT_EQ((*read)[1].position, kPlaces);
}

TEST(Traces, that_are_cut_off_or_none_are_refused) {
  const std::string bytes = trace_bytes(small_trace());
  std::size_t whole = 0;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    if (parse_trace(std::string_view(bytes).substr(0, size))) ++whole;
  }
  EXPECT_EQ(whole, 2u);  // no array, and the first of the two
  EXPECT_FALSE(parse_trace("something else"));
  EXPECT_FALSE(load_trace("/nowhere/at/all"));
}

}  // namespace
}  // namespace sfumato::test
