#pragma once

#include <utility>

#include "base/no_throw.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato {

/// body(), which returns a Status or a Result, as every public verb does its work: with a Context
/// that is as validate() wants it, and through no_throw.
template <class Body>
auto public_verb(const Context& context, Body&& body) -> decltype(body()) {
  return no_throw([&]() -> decltype(body()) {
    if (Status status = validate(context); !status) return status;
    return body();
  });
}

}  // namespace sfumato
