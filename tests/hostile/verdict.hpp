#pragma once

#include <string>
#include <vector>

#include "hostile/case.hpp"
#include "hostile/sandbox.hpp"
#include "support/sanitizers.hpp"

namespace sfumato::hostile {

/// What every case has to stay below, whatever it is about: processor time of all threads together
/// (that of one thread is the wall clock's, without what waits for others) and resident memory.
/// Sanitizers take two to four times as long, and AddressSanitizer an eighth of the memory more and
/// what surrounds each block.
constexpr double kMostSeconds = SFUMATO_HAS_SANITIZER ? 8 : 2;
constexpr std::size_t kMostBytes = std::size_t{SFUMATO_HAS_SANITIZER ? 320 : 256} << 20;

/// What is wrong with how a case ended, in one line; "" where nothing is.
///
/// before, after   names in its folder, sorted
/// slowness        of the machine as the case ran: 1, or more and the case may take more time
/// (pace.hpp)
std::string complaint(const Case& of, const Ended& ended, const std::vector<std::string>& before,
                      const std::vector<std::string>& after, double slowness);

/// Of that what is about time and memory.
std::string complaint_of_cost(const Ended& ended, double slowness);

}  // namespace sfumato::hostile
