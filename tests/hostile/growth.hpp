#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace sfumato::hostile {

/// A document of any size, and what reads it.
struct Growing {
  std::string name;
  std::size_t first;  ///< where measuring begins; doubled until it can be measured
  std::size_t most;   ///< the largest that stays within the limits
  std::function<std::string(std::size_t)> document;
  std::vector<std::string> arguments{"info", "in.svg"};
};

/// Every generator there is (growing.cpp).
std::vector<Growing> all_growing();

/// Runs each generator at n, 2n and 4n. 1 where time or memory grow more than 2.5 times per
/// doubling in one, else 0. `only`: one generator's name, or "" for all.
int run_growth(const std::string& binary, const std::string& only);

}  // namespace sfumato::hostile
