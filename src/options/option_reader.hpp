#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "options/option.hpp"
#include "options/option_string.hpp"
#include "sfumato/base/limits.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::options {

/// Reads the option strings of one call.
class OptionReader {
 public:
  explicit OptionReader(Call call) : call_(call) {}

  /// Takes the options of a table that the call knows, and sets them in `target`, which must
  /// outlive this object.
  template <class Target>
  void take(std::span<const Option<Target>> table, Target& target) {
    for (const Option<Target>& option : table) {
      if ((option.info.calls & call_) == 0) continue;
      known_.push_back(
          {&option.info, [&option, &target](const Value& value) { option.set(target, value); }});
    }
  }

  /// Also takes "limit.NAME=VALUE".
  void take_limits(Limits& limits) { limits_ = &limits; }

  /// Sets the options of a text that has the form of OptionString. Errors: bad_input, with the
  /// option's key in the message: the call does not know the option, it is given twice, or it does
  /// not take the value. Some targets may be set even then.
  Status read(std::string_view text);

 private:
  struct Known {
    const OptionInfo* info;
    std::function<void(const Value&)> set;
    bool is_given = false;
  };

  Known* find(std::string_view key);
  Status set(const Assignment& assignment);
  Status set_known(Known& known, const Assignment& assignment);
  Status set_limit_of(std::string_view name, const Assignment& assignment);
  Status unknown(std::string_view key) const;

  Call call_;
  std::vector<Known> known_;
  Limits* limits_ = nullptr;
};

}  // namespace sfumato::options
