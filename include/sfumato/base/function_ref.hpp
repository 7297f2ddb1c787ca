#pragma once

#include <type_traits>
#include <utility>

namespace sfumato {

/// Declares the template; only the specialisation for function types is defined.
template <class Signature>
class FunctionRef;

/// A reference to a callable object: two pointers, no allocation. It does not own the object, which
/// must outlive it. Use it only for parameters.
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

  /// Calls the object.
  R operator()(Args... args) const { return call_(object_, std::forward<Args>(args)...); }

 private:
  void* object_;
  R (*call_)(void*, Args...);
};

}  // namespace sfumato
