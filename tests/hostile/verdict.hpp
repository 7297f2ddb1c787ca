#pragma once

#include <string>
#include <vector>

#include "hostile/case.hpp"
#include "hostile/sandbox.hpp"

namespace sfumato::hostile {

/// What every case has to stay below, whatever it is about: processor time of all threads together
/// (a busy machine does not change it; of one thread it is the wall clock's) and resident memory.
constexpr double kMostSeconds = 2;
constexpr std::size_t kMostBytes = std::size_t{256} << 20;

/// What is wrong with how a case ended, in one line; "" where nothing is.
///
/// before, after   names in its folder, sorted
std::string complaint(const Case& of, const Ended& ended, const std::vector<std::string>& before,
                      const std::vector<std::string>& after);

}  // namespace sfumato::hostile
