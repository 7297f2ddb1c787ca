#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "trust/fields.hpp"

namespace sfumato::test {

/// Called while one field has a wrong value; `place` names the field.
using Attempt = std::function<void(const std::string& place)>;

namespace wrong {

template <class T>
std::vector<T> numbers() {
  using Limits = std::numeric_limits<T>;
  if constexpr (std::is_floating_point_v<T>) {
    return {Limits::quiet_NaN(),
            Limits::infinity(),
            -Limits::infinity(),
            Limits::max(),
            -Limits::max(),
            Limits::min(),
            Limits::denorm_min(),
            T(-1),
            T(0),
            T(0.5),
            T(1.0001),
            T(1e8)};
  } else {
    return {Limits::max(), Limits::min(), T(-1), T(0), T(1), T(2), T(77), T(Limits::max() / 2)};
  }
}

inline std::vector<std::string> strings() {
  return {"",
          std::string("\0\x01\x1b[2J\n", 7),
          "\xff\xc3",
          "\"><script>]]>-->",
          "\xe2\x80\xae",
          std::string(5000, 'x')};
}

/// Sets `value` to each of `values`, and back.
template <class T>
void try_each(T& value, const std::vector<T>& values, const std::string& place,
              const Attempt& attempt) {
  const T right = value;
  for (std::size_t i = 0; i < values.size(); ++i) {
    value = values[i];
    attempt(place + ", wrong value " + std::to_string(i));
  }
  value = right;
}

template <class T>
void of(T& value, const std::string& place, const Attempt& attempt);

template <class T>
void of(std::optional<T>& value, const std::string& place, const Attempt& attempt) {
  try_each(value, {std::nullopt, T{}}, place, attempt);
  const std::optional<T> right = value;
  if (!value) value.emplace();
  of(*value, place + "?", attempt);
  value = right;
}

template <class... T>
void of(std::variant<T...>& value, const std::string& place, const Attempt& attempt) {
  try_each(value, {std::variant<T...>(T{})...}, place, attempt);
  std::visit([&](auto& held) { of(held, place + "|" + std::to_string(value.index()), attempt); },
             value);
}

/// Sets wrong lengths, then wrong elements: the first and the last.
template <class T>
void of(std::vector<T>& value, const std::string& place, const Attempt& attempt) {
  std::vector<T> longer = value, shorter = value, doubled = value;
  longer.push_back(value.empty() ? T{} : value.back());
  if (!shorter.empty()) shorter.pop_back();
  doubled.insert(doubled.end(), value.begin(), value.end());
  try_each(value, {{}, longer, shorter, doubled}, place + " as long", attempt);
  if (value.empty()) return;
  of(value.front(), place + "[0]", attempt);
  if (value.size() > 1) of(value.back(), place + "[last]", attempt);
}

template <class T>
void of(T& value, const std::string& place, const Attempt& attempt) {
  if constexpr (std::is_same_v<T, std::string>) {
    try_each(value, strings(), place, attempt);
  } else if constexpr (std::is_same_v<T, bool>) {
    try_each(value, {!value}, place, attempt);
  } else if constexpr (std::is_enum_v<T>) {
    std::vector<T> all;
    for (int i = 0; i < 18; ++i) all.push_back(static_cast<T>(i));
    for (const int i : {99, 200, 255}) all.push_back(static_cast<T>(i));
    try_each(value, all, place, attempt);
  } else if constexpr (std::is_arithmetic_v<T>) {
    try_each(value, numbers<T>(), place, attempt);
  } else {
    int index = 0;
    std::apply(
        [&](auto&... field) { (of(field, place + "." + std::to_string(index++), attempt), ...); },
        fields(value));
  }
}

}  // namespace wrong

/// Gives wrong values to every field of `value` and of its parts, one field at a time.
template <class T>
void try_wrong_values(T& value, const std::string& name, const Attempt& attempt) {
  wrong::of(value, name, attempt);
}

}  // namespace sfumato::test
