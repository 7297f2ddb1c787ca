#pragma once

#include <string>
#include <vector>

#include "hostile/case.hpp"
#include "hostile/sandbox.hpp"
#include "support/sanitizers.hpp"

namespace sfumato::hostile {

/// Limit for the resident memory of every case; pace.hpp has the time. AddressSanitizer takes an
/// eighth more and the surroundings of each block.
constexpr std::size_t kMostBytes = std::size_t{SFUMATO_HAS_SANITIZER ? 320 : 256} << 20;

/// Returns the fault of a case's end, in one line; "" if there is none.
///
/// before, after: names in its folder, sorted
/// granted_seconds: allowed processor time (pace.hpp)
std::string complaint(const Case& of, const Ended& ended, const std::vector<std::string>& before,
                      const std::vector<std::string>& after, double granted_seconds);

/// Returns only the faults in time and memory.
std::string complaint_of_cost(const Ended& ended, double granted_seconds);

}  // namespace sfumato::hostile
