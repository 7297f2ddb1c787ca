#include "codecs/png/png_filter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <vector>

namespace sfumato {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Returns PNG's predictors, by the specification.
int predicted(int filter, int left, int up, int corner) {
  if (filter == 0) return 0;
  if (filter == 1) return left;
  if (filter == 2) return up;
  if (filter == 3) return (left + up) / 2;
  const int estimate = left + up - corner;
  const int by_left = std::abs(estimate - left), by_up = std::abs(estimate - up);
  const int by_corner = std::abs(estimate - corner);
  if (by_left <= by_up && by_left <= by_corner) return left;
  return by_up <= by_corner ? up : corner;
}

Bytes filtered(int filter, const Bytes& current, const Bytes& previous, std::size_t pixel_bytes) {
  Bytes out{static_cast<std::uint8_t>(filter)};
  for (std::size_t i = 0; i < current.size(); ++i) {
    const bool is_first = i < pixel_bytes;
    const int left = is_first ? 0 : current[i - pixel_bytes];
    const int corner = is_first ? 0 : previous[i - pixel_bytes];
    const int guess = predicted(filter, left, previous[i], corner);
    out.push_back(static_cast<std::uint8_t>(current[i] - guess));
  }
  return out;
}

int sum_of_magnitudes(const Bytes& row) {
  int sum = 0;
  for (std::size_t i = 1; i < row.size(); ++i) sum += std::abs(static_cast<std::int8_t>(row[i]));
  return sum;
}

/// Returns slopes with noise, so that each filter is the best one for some rows.
Bytes random_row(std::mt19937& random, std::size_t size) {
  const unsigned slope = random() % 4, spread = 1 + random() % 60, start = random();
  Bytes row(size);
  for (std::size_t i = 0; i < size; ++i) {
    row[i] = static_cast<std::uint8_t>(start + slope * i + random() % spread);
  }
  return row;
}

Bytes near(std::mt19937& random, const Bytes& row) {
  const unsigned shift = random() % 30, spread = 1 + random() % 20;
  Bytes result(row);
  for (std::uint8_t& byte : result)
    byte = static_cast<std::uint8_t>(byte + shift + random() % spread);
  return result;
}

TEST(PngFilter, short_row_has_the_filter_of_the_smallest_sum) {
  std::mt19937 random(1);
  int chosen[5] = {};
  for (int i = 0; i < 2000; ++i) {
    const std::size_t pixel_bytes = 1 + random() % 8, size = pixel_bytes * (1 + random() % 60);
    const Bytes previous = random_row(random, size);
    const Bytes current = i % 2 == 0 ? near(random, previous) : random_row(random, size);
    Bytes out(size + 1);
    codecs::filter_row(current.data(), previous.data(), size, pixel_bytes, out.data());
    Bytes best = filtered(0, current, previous, pixel_bytes);
    for (int filter = 1; filter < 5; ++filter) {
      const Bytes other = filtered(filter, current, previous, pixel_bytes);
      if (sum_of_magnitudes(other) < sum_of_magnitudes(best)) best = other;
    }
    ASSERT_TRUE(out == best) << i;
    ++chosen[out[0]];
  }
  for (const int times : chosen) EXPECT_GT(times, 0);
}

TEST(PngFilter, long_row_is_filtered_whole_by_the_filter_it_names) {
  std::mt19937 random(2);
  for (int i = 0; i < 200; ++i) {
    const std::size_t pixel_bytes = 1 + random() % 8, size = pixel_bytes * (1 + random() % 2000);
    const Bytes previous = random_row(random, size), current = near(random, previous);
    Bytes out(size + 1);
    codecs::filter_row(current.data(), previous.data(), size, pixel_bytes, out.data());
    ASSERT_LT(out[0], 5);
    ASSERT_TRUE(out == filtered(out[0], current, previous, pixel_bytes)) << i;
  }
}

}  // namespace
}  // namespace sfumato
