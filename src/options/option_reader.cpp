#include "options/option_reader.hpp"

#include <algorithm>

#include "base/try.hpp"
#include "formats/text/suggestion.hpp"
#include "options/limit_option.hpp"

namespace sfumato::options {
namespace {

constexpr std::string_view kLimitPrefix = "limit.";

Status complaint(std::string_view key, const std::string& what) {
  return make_error(StatusCode::bad_input, std::string(key) + ": " + what);
}

}  // namespace

OptionReader::Known* OptionReader::find(std::string_view key) {
  const auto found =
      std::ranges::find_if(known_, [key](const Known& known) { return known.info->key == key; });
  return found == known_.end() ? nullptr : &*found;
}

Status OptionReader::unknown(std::string_view key) const {
  std::vector<std::string_view> keys;
  for (const Known& known : known_) keys.push_back(known.info->key);
  return make_error(StatusCode::bad_input, "unknown option " + text::quoted(key) +
                                               " for this call" + text::did_you_mean(key, keys));
}

Status OptionReader::set_known(Known& known, const Assignment& assignment) {
  const OptionInfo& info = *known.info;
  if (known.is_given) return complaint(info.key, "given twice; give it once");
  known.is_given = true;
  const bool is_flag = info.kind == ValueKind::flag;
  if (is_flag && assignment.value)
    return complaint(info.key, "takes no value; leave out the value");
  if (!is_flag && !assignment.value)
    return complaint(info.key, "no value given; write it as KEY=VALUE");
  const std::string text = assignment.value.value_or(std::string());
  const std::optional<Value> value = parse_value(info, text);
  if (!value) return complaint(info.key, complaint_about_value(info, text));
  known.set(*value);
  return ok_status();
}

Status OptionReader::set_limit_of(std::string_view name, const Assignment& assignment) {
  const std::string expected = set_limit(name, assignment.value.value_or(std::string()), *limits_);
  if (expected.empty()) return ok_status();
  return complaint(text::quoted(assignment.key), "use " + expected);
}

Status OptionReader::set(const Assignment& assignment) {
  const std::string_view key = assignment.key;
  if (limits_ && key.starts_with(kLimitPrefix)) {
    return set_limit_of(key.substr(kLimitPrefix.size()), assignment);
  }
  Known* known = find(key);
  return known ? set_known(*known, assignment) : unknown(key);
}

Status OptionReader::read(std::string_view text) {
  OptionString parts(text);
  while (true) {
    SFUMATO_TRY_ASSIGN(const Assignment& part, parts.next());
    if (part.key.empty()) break;
    SFUMATO_TRY(set(part));
  }
  for (const Known& known : known_) {
    const Known* other = known.info->excludes ? find(known.info->excludes) : nullptr;
    if (known.is_given && other && other->is_given) {
      return complaint(known.info->key,
                       "cannot be combined with " + std::string(known.info->excludes));
    }
  }
  return ok_status();
}

}  // namespace sfumato::options
