#pragma once

#include <cstddef>
#include <cstring>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "trust/fields.hpp"

namespace sfumato::test {

inline bool are_same(std::string& a, std::string& b) {
  return a == b;
}

/// Returns whether two values are equal to the last bit, including the signs of zeros.
template <class T>
bool are_same(T& a, T& b);
template <class T>
bool are_same(std::vector<T>& a, std::vector<T>& b);
template <class T>
bool are_same(std::optional<T>& a, std::optional<T>& b);
template <class... T>
bool are_same(std::variant<T...>& a, std::variant<T...>& b);

template <class T>
bool are_same(std::vector<T>& a, std::vector<T>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!are_same(a[i], b[i])) return false;
  }
  return true;
}

template <class T>
bool are_same(std::optional<T>& a, std::optional<T>& b) {
  return a.has_value() == b.has_value() && (!a || are_same(*a, *b));
}

template <class... T>
bool are_same(std::variant<T...>& a, std::variant<T...>& b) {
  if (a.index() != b.index()) return false;
  return std::visit(
      [&b](auto& part) { return are_same(part, std::get<std::remove_cvref_t<decltype(part)>>(b)); },
      a);
}

template <class T>
bool are_same(T& a, T& b) {
  if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
    return std::memcmp(&a, &b, sizeof a) == 0;
  } else {
    return std::apply(
        [&b](auto&... of_a) {
          return std::apply([&](auto&... of_b) { return (are_same(of_a, of_b) && ...); },
                            fields(b));
        },
        fields(a));
  }
}

}  // namespace sfumato::test
