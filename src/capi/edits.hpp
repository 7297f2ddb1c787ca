#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "sfumato/document/change.hpp"

namespace sfumato::capi {

/// A curve's indices.
struct CurvePlace {
  std::uint32_t layer = 0;
  std::uint32_t curve = 0;

  friend bool operator==(const CurvePlace&, const CurvePlace&) = default;
};

/// A state of a document.
struct Revision {
  std::shared_ptr<const char> document;  ///< which one it is; not read
  std::uint64_t edits = 0;               ///< that it has had

  friend bool operator==(const Revision&, const Revision&) = default;
};

/// The edits of one document: what has changed since an earlier state is found without comparing
/// documents.
class Edits {
 public:
  const Revision& now() const { return now_; }

  /// Notes an edit that replaced one curve, or any other. A run of edits of one curve begins with
  /// the first of them; after any other edit no run has begun.
  void note(std::optional<CurvePlace> replaced) {
    if (!replaced || replaced != curve_) before_run_ = replaced ? now_.edits : now_.edits + 1;
    curve_ = replaced;
    ++now_.edits;
  }

  /// The curve that was replaced since, where nothing else was edited; none else.
  std::optional<CurvePlace> only_change_since(const Revision& then) const {
    const bool is_known = then.document == now_.document && then.edits >= before_run_;
    return is_known && then.edits < now_.edits ? curve_ : std::nullopt;
  }

 private:
  Revision now_{std::make_shared<const char>('\0'), 0};
  std::optional<CurvePlace> curve_;  ///< of the last run of edits; none: they were others
  std::uint64_t before_run_ = 0;     ///< edits before that run
};

}  // namespace sfumato::capi
