#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sfumato/base/status.hpp"

namespace sfumato::options {

/// A key and its value in a string of options.
struct Assignment {
  std::string key;
  std::optional<std::string> value;  ///< none: the key has no value
};

/// Splits a string of options into its parts: "key=value key key=\"a value\"". Blanks separate the
/// parts. A value with blanks or quotes is quoted as a whole; in it, \" and \\ stand for a quote
/// and a backslash.
class OptionString {
 public:
  /// The text must outlive this object.
  explicit OptionString(std::string_view text) : rest_(text) {}

  /// Returns the next part; an empty key at the end. Errors: bad_input, with the key in the
  /// message.
  Result<Assignment> next();

 private:
  Result<std::string> quoted_value(std::string_view key);

  std::string_view rest_;
};

}  // namespace sfumato::options
