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

  /// Takes those options of a table that the call knows, and sets them in `target`, which must
  /// outlive this.
  template <class Target>
  void take(std::span<const Option<Target>> table, Target& target) {
    for (const Option<Target>& option : table) {
      if ((option.info.calls & call_) == 0) continue;
      known_.push_back(
          {&option.info, [&option, &target](const Value& value) { option.set(target, value); }});
    }
  }

  /// Takes "limit.NAME=VALUE" too.
  void take_limits(Limits& limits) { limits_ = &limits; }

  /// Sets what the text says, as OptionString describes it. Errors: bad_input, with the option's
  /// key in the message: one that the call does not know or that is given twice, a value that it
  /// does not take. Some targets may have been set then.
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
