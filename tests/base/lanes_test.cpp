#include "base/lanes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace sfumato {
namespace {

constexpr int kCount = 16;
using Row = std::array<float, kCount>;

/// Returns numbers of every size and sign, with zeros, infinities and NaN.
std::vector<Row> samples() {
  const float kSpecial[] = {0.0f, -0.0f, 1.0f, -1.0f, 1e-45f, -3e38f, INFINITY, -INFINITY, NAN};
  std::vector<Row> rows(500);
  std::uint32_t state = 12345;
  for (Row& row : rows) {
    for (float& x : row) {
      state = state * 1664525u + 1013904223u;
      const std::uint32_t pick = state >> 28;
      if (pick < std::size(kSpecial)) {
        x = kSpecial[pick];
        continue;
      }
      const std::uint32_t bits = (state & 0x83ffffffu) | 0x3c000000u;
      std::memcpy(&x, &bits, sizeof(x));
    }
  }
  return rows;
}

/// Returns the results of every operation on two rows, as bits.
template <int W, int K>
std::vector<std::uint32_t> all_operations(const Row& left, const Row& right) {
  using F = Lanes<W, K>;
  const F a = F::load(left.data());
  const F b = F::load(right.data());
  const auto less = a < b;
  const auto equal = a == b;
  const F finite = min(max(a, F(-1e6f)), F(1e6f));
  const F results[] = {a + b,
                       a - b,
                       a * b,
                       a / b,
                       select(less, a, b),
                       zero_unless(a >= b, a),
                       min(a, b),
                       max(a, b),
                       sqrt(abs(b)),
                       reciprocal(finite),
                       reciprocal_sqrt(abs(finite) + F(1e-20f)),
                       to_float(to_int(finite)),
                       F(-0.0f),
                       as_float((as_int(a) & IntLanes<W, K>(0xffff)) - IntLanes<W, K>(7))};
  std::vector<std::uint32_t> bits;
  for (const F& result : results) {
    float values[kCount];
    result.store(values);
    for (float value : values) {
      std::uint32_t word;
      std::memcpy(&word, &value, sizeof(word));
      bits.push_back(std::isnan(value) ? 0x7fc00000u : word);
    }
  }
  bits.push_back(mask_bits(less));
  bits.push_back(mask_bits(and_not(less | equal, a > F(0))));
  bits.push_back(mask_bits(less & (b >= F(0))));
  bits.push_back(mask_bits(decltype(less)::from_bits(0xb14c)));
  bits.push_back(any(equal) ? 1 : 0);
  bits.push_back(all(a <= F(INFINITY)) ? 1 : 0);
  return bits;
}

TEST(Lanes, every_width_gives_the_bits_of_one_lane_at_a_time) {
  const std::vector<Row> rows = samples();
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    const auto expected = all_operations<1, 16>(rows[i], rows[i + 1]);
    EXPECT_EQ(expected, (all_operations<4, 4>(rows[i], rows[i + 1]))) << i;
    EXPECT_EQ(expected, (all_operations<8, 2>(rows[i], rows[i + 1]))) << i;
    EXPECT_EQ(expected, (all_operations<16, 1>(rows[i], rows[i + 1]))) << i;
  }
}

TEST(Lanes, min_and_max_return_the_second_operand_beside_a_nan) {
  const Lanes<1> nan(NAN), one(1);
  EXPECT_EQ(min(nan, one)[0], 1);
  EXPECT_EQ(max(nan, one)[0], 1);
  EXPECT_TRUE(std::isnan(min(one, nan)[0]));
}

TEST(Lanes, reciprocals_are_as_close_as_they_say) {
  double worst = 0;
  double worst_root = 0;
  for (float x = 1e-12f; x < 1e12f; x *= 1.00007f) {
    worst = std::fmax(worst, std::fabs(reciprocal(Lanes<1>(x))[0] * double{x} - 1));
    worst = std::fmax(worst, std::fabs(reciprocal(Lanes<1>(-x))[0] * -double{x} - 1));
    const double root = reciprocal_sqrt(Lanes<1>(x))[0] * std::sqrt(double{x});
    worst_root = std::fmax(worst_root, std::fabs(root - 1));
  }
  EXPECT_LT(worst, 2e-6);
  EXPECT_LT(worst_root, 5e-7);
}

TEST(Lanes, a_mask_from_bits_has_these_bits) {
  for (std::uint32_t bits : {0u, 1u, 0x8000u, 0xffffu, 0xa5c3u}) {
    EXPECT_EQ(mask_bits(LaneMask<1, 16>::from_bits(bits)), bits);
    EXPECT_EQ(mask_bits(LaneMask<4, 4>::from_bits(bits)), bits);
    EXPECT_EQ(mask_bits(LaneMask<8, 2>::from_bits(bits)), bits);
    EXPECT_EQ(mask_bits(LaneMask<16, 1>::from_bits(bits)), bits);
    EXPECT_EQ(any(LaneMask<4, 4>::from_bits(bits)), bits != 0);
    EXPECT_EQ(all(LaneMask<4, 4>::from_bits(bits)), bits == 0xffff);
  }
}

}  // namespace
}  // namespace sfumato
