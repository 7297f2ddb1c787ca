#include "picture/checksum.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>

namespace sfumato::picture {
namespace {

constexpr std::uint64_t kPrime1 = 0x9E3779B185EBCA87;
constexpr std::uint64_t kPrime2 = 0xC2B2AE3D27D4EB4F;
constexpr std::uint64_t kPrime3 = 0x165667B19E3779F9;
constexpr std::uint64_t kPrime4 = 0x85EBCA77C2B2AE63;
constexpr std::uint64_t kPrime5 = 0x27D4EB2F165667C5;

constexpr std::size_t kStripe = 32;
/// Bytes between two polls of the cancel flag.
constexpr std::size_t kPart = std::size_t{2} << 20;

using Lanes = std::array<std::uint64_t, 4>;

/// Returns a number of the algorithm, which is little-endian.
template <class Number>
std::uint64_t number_at(const std::uint8_t* at) {
  if constexpr (std::endian::native == std::endian::little) {
    Number number;
    std::memcpy(&number, at, sizeof number);
    return number;
  } else {
    std::uint64_t number = 0;
    for (std::size_t i = sizeof(Number); i > 0; --i) number = number << 8 | at[i - 1];
    return number;
  }
}

std::uint64_t round(std::uint64_t lane, std::uint64_t input) {
  return std::rotl(lane + input * kPrime2, 31) * kPrime1;
}

void add_stripes(const std::uint8_t* at, const std::uint8_t* end, Lanes& lanes) {
  Lanes sums = lanes;
  for (; at != end; at += kStripe) {
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sums[i] = round(sums[i], number_at<std::uint64_t>(at + 8 * i));
    }
  }
  lanes = sums;
}

std::uint64_t merged(const Lanes& lanes) {
  std::uint64_t hash = std::rotl(lanes[0], 1) + std::rotl(lanes[1], 7) + std::rotl(lanes[2], 12) +
                       std::rotl(lanes[3], 18);
  for (const std::uint64_t lane : lanes) hash = (hash ^ round(0, lane)) * kPrime1 + kPrime4;
  return hash;
}

/// Adds the bytes after the last stripe.
std::uint64_t with_tail(std::uint64_t hash, const std::uint8_t* at, const std::uint8_t* end) {
  for (; end - at >= 8; at += 8) {
    hash = std::rotl(hash ^ round(0, number_at<std::uint64_t>(at)), 27) * kPrime1 + kPrime4;
  }
  if (end - at >= 4) {
    hash = std::rotl(hash ^ number_at<std::uint32_t>(at) * kPrime1, 23) * kPrime2 + kPrime3;
    at += 4;
  }
  for (; at != end; ++at) hash = std::rotl(hash ^ *at * kPrime5, 11) * kPrime1;
  return hash;
}

std::uint64_t mixed(std::uint64_t hash) {
  hash = (hash ^ hash >> 33) * kPrime2;
  hash = (hash ^ hash >> 29) * kPrime3;
  return hash ^ hash >> 32;
}

}  // namespace

Result<std::uint64_t> checksum(const Context& context, std::span<const std::uint8_t> bytes) {
  const std::uint8_t* at = bytes.data();
  const std::uint8_t* const end = at + bytes.size();
  const std::uint8_t* const tail = end - bytes.size() % kStripe;
  Lanes lanes{kPrime1 + kPrime2, kPrime2, 0, 0 - kPrime1};
  while (at != tail) {
    if (context.cancelled()) return context.cancel_status();
    const std::uint8_t* const next = at + std::min<std::ptrdiff_t>(kPart, tail - at);
    add_stripes(at, next, lanes);
    at = next;
  }
  const std::uint64_t begun = bytes.size() < kStripe ? kPrime5 : merged(lanes);
  return mixed(with_tail(begun + bytes.size(), at, end));
}

}  // namespace sfumato::picture
