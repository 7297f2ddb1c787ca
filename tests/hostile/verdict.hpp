#pragma once

#include <string>
#include <vector>

#include "hostile/case.hpp"
#include "hostile/sandbox.hpp"
#include "support/sanitizers.hpp"

namespace sfumato::hostile {

/// Resident memory that every case has to stay below, whatever it is about; pace.hpp has the time.
/// AddressSanitizer takes an eighth more and what surrounds each block.
constexpr std::size_t kMostBytes = std::size_t{SFUMATO_HAS_SANITIZER ? 320 : 256} << 20;

/// What is wrong with how a case ended, in one line; "" where nothing is.
///
/// before, after     names in its folder, sorted
/// granted_seconds   of processor time (pace.hpp)
std::string complaint(const Case& of, const Ended& ended, const std::vector<std::string>& before,
                      const std::vector<std::string>& after, double granted_seconds);

/// Of that what is about time and memory.
std::string complaint_of_cost(const Ended& ended, double granted_seconds);

}  // namespace sfumato::hostile
