#pragma once

#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <numeric>
#include <string_view>
#include <vector>

/// Chooses the number of random cases of a test. ctest runs few: enough to find the known faults
/// again. `make soak` sets SFUMATO_SOAK=1 and runs all.
namespace sfumato::test {

inline bool is_soak() {
  const char* const asked = std::getenv("SFUMATO_SOAK");
  return asked && std::string_view(asked) == "1";
}

/// Returns `full` in `make soak`, else `quick`. Use it if all cases are equally good.
template <class Count>
Count random_case_count(Count quick, Count full) {
  return is_soak() ? full : quick;
}

/// Returns the seeds from `first` to `last` in `make soak`, else the chosen ones. Use it if the
/// seeds that find faults are known.
inline std::vector<std::uint64_t> random_seeds(std::uint64_t first, std::uint64_t last,
                                               std::initializer_list<std::uint64_t> chosen) {
  if (!is_soak()) return chosen;
  std::vector<std::uint64_t> seeds(last - first + 1);
  std::iota(seeds.begin(), seeds.end(), first);
  return seeds;
}

}  // namespace sfumato::test
