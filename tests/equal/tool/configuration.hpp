#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sfumato/base/context.hpp"

namespace sfumato::test {

/// How a machine works on a scene. The configuration must not change the result.
struct Configuration {
  int threads = 1;
  SimdLevel simd = SimdLevel::sse2;

  friend bool operator==(const Configuration&, const Configuration&) = default;
};

inline constexpr int kThreadCounts[] = {1, 2, 3, 8};

/// "3/avx2".
std::string to_string(const Configuration& configuration);

/// Parses the text of to_string(). Empty for another text, or if the machine lacks the instruction
/// set.
std::optional<Configuration> parse_configuration(std::string_view text);

/// Returns the instruction sets of this machine, sse2 first.
std::vector<SimdLevel> simd_levels();

/// Returns every number of threads with every instruction set; one thread and sse2 come first.
std::vector<Configuration> all_configurations();

/// Returns one configuration for each number of threads, each instruction set at least once. Three
/// seeds in a row have all pairs.
std::vector<Configuration> configurations_of(std::uint64_t seed);

}  // namespace sfumato::test
