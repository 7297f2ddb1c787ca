#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace sfumato::hostile {

/// A document of any size, and the call that reads it.
struct Growing {
  std::string name;
  std::size_t first;  ///< start of the measurement; doubled until it can be measured
  std::size_t most;   ///< the largest size within the limits
  std::function<std::string(std::size_t)> document;
  std::vector<std::string> arguments{"info", "in.svg"};
};

/// Returns all generators (growing.cpp).
std::vector<Growing> all_growing();

/// Runs each generator at n, 2n and 4n. Returns 1 if time or memory of one grows more than 2.5
/// times per doubling, else 0. `only`: one generator's name, or "" for all.
int run_growth(const std::string& binary, const std::string& only);

}  // namespace sfumato::hostile
