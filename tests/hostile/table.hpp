#pragma once

#include <string>
#include <vector>

#include "hostile/case.hpp"

namespace sfumato::hostile {

/// Prints the differences between the counts of README.md and the cases. Returns whether all agree:
/// for every family, the number of cases and the number for each exit code.
bool check_table(const std::vector<Family>& families, const std::string& readme);

}  // namespace sfumato::hostile
