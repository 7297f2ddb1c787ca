#pragma once

#include <type_traits>
#include <utility>

namespace sfumato {

/// Only the specialisation for function types is defined.
template <class Signature>
class FunctionRef;

/// A reference to something callable: two pointers, no allocation. It does not own what it refers
/// to, which must outlive it; use it for parameters alone.
template <class R, class... Args>
class FunctionRef<R(Args...)> {
 public:
  /// Refers to `callable`: a function object or a lambda.
  template <class F>
  requires(!std::is_same_v<std::remove_cvref_t<F>, FunctionRef>)
      FunctionRef(F&& callable)  // NOLINT: implicit on purpose, as for string_view
      : object_(const_cast<void*>(static_cast<const void*>(&callable))),
        call_([](void* object, Args... args) -> R {
          return (*static_cast<std::remove_reference_t<F>*>(object))(std::forward<Args>(args)...);
        }) {}

  /// Calls it.
  R operator()(Args... args) const { return call_(object_, std::forward<Args>(args)...); }

 private:
  void* object_;
  R (*call_)(void*, Args...);
};

}  // namespace sfumato
