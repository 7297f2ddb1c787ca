#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sfumato/base/status.hpp"

namespace sfumato::options {

/// A key and its value as they stand in a string of options.
struct Assignment {
  std::string key;
  std::optional<std::string> value;  ///< none: the key stands alone
};

/// Cuts a string of options into its parts: "key=value key key=\"a value\"". Blanks separate. A
/// value with blanks or quotes is quoted as a whole, and \" and \\ stand for a quote and a
/// backslash in it.
class OptionString {
 public:
  /// The text must outlive this.
  explicit OptionString(std::string_view text) : rest_(text) {}

  /// The next part; an empty key at the end. Errors: bad_input, with the key in the message.
  Result<Assignment> next();

 private:
  Result<std::string> quoted_value(std::string_view key);

  std::string_view rest_;
};

}  // namespace sfumato::options
