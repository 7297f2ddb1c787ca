#pragma once

#include <string_view>

#include "options/output_kind.hpp"
#include "options/settings.hpp"

namespace sfumato::options {

/// Options that do not go together: the one to name, and what is wrong with it, both as spelled()
/// explains. Without a key there is no conflict.
struct Conflict {
  std::string_view key;
  std::string_view complaint;
};

/// The first conflict of what was given with each other or with an output of this kind.
Conflict find_conflict(const Settings& given, OutputKind kind);

/// The first conflict of what was given with each other where a picture is solved and nothing is
/// made of it.
Conflict find_solve_conflict(const Settings& given);

/// Gives what was not given the values that it has for an output of this kind.
void settle(Settings& settings, OutputKind kind);

}  // namespace sfumato::options
