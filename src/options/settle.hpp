#pragma once

#include <string_view>

#include "options/output_kind.hpp"
#include "options/settings.hpp"

namespace sfumato::options {

/// A conflict of options: the option to name and what is wrong with it, both in the form that
/// spelled() explains. Without a key there is no conflict.
struct Conflict {
  std::string_view key;
  std::string_view complaint;
};

/// Returns the first conflict among the given options, or of an option with an output of this kind.
Conflict find_conflict(const Settings& given, OutputKind kind);

/// Returns the first conflict among the given options for a picture that is solved but not written.
Conflict find_solve_conflict(const Settings& given);

/// Sets the options that were not given to their defaults for an output of this kind.
void settle(Settings& settings, OutputKind kind);

}  // namespace sfumato::options
