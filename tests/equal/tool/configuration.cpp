#include "equal/tool/configuration.hpp"

#include <array>
#include <charconv>
#include <cstddef>

namespace sfumato::test {
namespace {

constexpr std::array<std::string_view, 3> kLevelNames = {"sse2", "avx2", "avx512"};
static_assert(kLevelNames.size() == static_cast<std::size_t>(SimdLevel::avx512) + 1);

std::string_view name_of(SimdLevel level) {
  return kLevelNames[static_cast<std::size_t>(level)];
}

}  // namespace

std::string to_string(const Configuration& configuration) {
  return std::to_string(configuration.threads) + '/' + std::string(name_of(configuration.simd));
}

std::optional<Configuration> parse_configuration(std::string_view text) {
  Configuration configuration;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), configuration.threads);
  if (error != std::errc() || configuration.threads < 1 ||
      configuration.threads > limits::kThreads) {
    return std::nullopt;
  }
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  for (SimdLevel level : simd_levels()) {
    if (text != '/' + std::string(name_of(level))) continue;
    configuration.simd = level;
    return configuration;
  }
  return std::nullopt;
}

std::vector<SimdLevel> simd_levels() {
  std::vector<SimdLevel> levels;
  for (SimdLevel level : {SimdLevel::sse2, SimdLevel::avx2, SimdLevel::avx512}) {
    if (level <= detected_simd_level()) levels.push_back(level);
  }
  return levels;
}

std::vector<Configuration> all_configurations() {
  std::vector<Configuration> configurations;
  for (int threads : kThreadCounts) {
    for (SimdLevel level : simd_levels()) configurations.push_back({threads, level});
  }
  return configurations;
}

std::vector<Configuration> configurations_of(std::uint64_t seed) {
  const std::vector<SimdLevel> levels = simd_levels();
  std::vector<Configuration> configurations;
  for (int threads : kThreadCounts) {
    configurations.push_back({threads, levels[(seed + configurations.size()) % levels.size()]});
  }
  return configurations;
}

}  // namespace sfumato::test
