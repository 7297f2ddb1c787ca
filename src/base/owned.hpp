#pragma once

#include <memory>

namespace sfumato {

/// Deletes an object by a function of C.
template <auto kDelete>
struct DeleteBy {
  void operator()(auto* object) const { kDelete(object); }
};

/// An object that a function of C deletes.
template <class Object, auto kDelete>
using Owned = std::unique_ptr<Object, DeleteBy<kDelete>>;

}  // namespace sfumato
