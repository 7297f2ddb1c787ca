#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sfumato/base/context.hpp"

namespace sfumato::test {

/// How a machine works on a scene. None of it may show in what comes out.
struct Configuration {
  int threads = 1;
  SimdLevel simd = SimdLevel::sse2;

  friend bool operator==(const Configuration&, const Configuration&) = default;
};

inline constexpr int kThreadCounts[] = {1, 2, 3, 8};

/// "3/avx2".
std::string to_string(const Configuration& configuration);

/// The inverse. Empty where the text is none, or the machine lacks the instruction set.
std::optional<Configuration> parse_configuration(std::string_view text);

/// The instruction sets that this machine has, sse2 first.
std::vector<SimdLevel> simd_levels();

/// Every number of threads with every instruction set; one thread and sse2 come first.
std::vector<Configuration> all_configurations();

/// One configuration for each number of threads, each instruction set at least once; three seeds in
/// a row have all pairs of both.
std::vector<Configuration> configurations_of(std::uint64_t seed);

}  // namespace sfumato::test
