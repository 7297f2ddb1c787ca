#pragma once

#include "base/no_throw.hpp"
#include "base/try.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato {

/// Runs body(), which returns a Status or a Result, as every public verb does: only with a Context
/// that validate() accepts, and through no_throw().
template <class Body>
auto public_verb(const Context& context, Body&& body) -> decltype(body()) {
  return no_throw([&]() -> decltype(body()) {
    SFUMATO_TRY(validate(context));
    return body();
  });
}

}  // namespace sfumato
