#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace sfumato {

/// Writes one JSON value, compactly. Keys and values keep the caller's order. Infinities and NaN
/// become null. Bytes of text that are not UTF-8 become U+FFFD.
class JsonWriter {
 public:
  JsonWriter& begin_object() { return open('{'); }
  JsonWriter& end_object() { return close('}'); }
  JsonWriter& begin_array() { return open('['); }
  JsonWriter& end_array() { return close(']'); }

  JsonWriter& key(std::string_view name);
  JsonWriter& value(std::string_view text);
  JsonWriter& value(double number);
  JsonWriter& value(std::unsigned_integral auto number) { return raw(std::to_string(number)); }
  JsonWriter& value(std::signed_integral auto number) { return raw(std::to_string(number)); }

  /// Writes true or false. A separate function, since text would convert to bool too.
  JsonWriter& truth(bool is_true) { return raw(is_true ? "true" : "false"); }

  template <class Value>
  JsonWriter& member(std::string_view name, const Value& content) {
    return key(name).value(content);
  }

  /// Writes a key and an array of values.
  JsonWriter& array(std::string_view name, const auto& values) {
    key(name).begin_array();
    for (const auto& each : values) value(each);
    return end_array();
  }

  const std::string& text() const { return text_; }

 private:
  JsonWriter& open(char bracket);
  JsonWriter& close(char bracket);
  JsonWriter& raw(std::string_view token);
  void separate();

  std::string text_;
  bool first_ = true;  ///< the next value is the first at this level
};

}  // namespace sfumato
