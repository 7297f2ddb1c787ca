#pragma once

#include <cstddef>
#include <string_view>

#include "sfumato/base/status.hpp"

namespace sfumato::svg {

/// Scans the text of an attribute by SVG's grammars. Positions in messages count characters from 1.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  bool at_end() const { return at_ == text_.size(); }
  /// Returns the next character; 0 at the end.
  char peek() const { return at_end() ? '\0' : text_[at_]; }
  /// Number of bytes consumed.
  std::size_t position() const { return at_; }
  std::string_view rest() const { return text_.substr(at_); }
  void skip_blanks();
  /// Blanks with at most one comma among them.
  void skip_separator();
  bool take(char c);
  /// Letters and digits.
  std::string_view take_word();
  /// A flag of an arc, 0 or 1, which needs no separator after it.
  Status take_flag(bool& flag);
  /// A number of at most limits::kCoordinate in magnitude.
  Status take_number(double& number);

  /// "at character 7, before "x 1": expected …".
  Status error(std::string_view expected) const;

 private:
  std::size_t number_end() const;

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace sfumato::svg
