#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "sfumato/document/change.hpp"

namespace sfumato::capi {

/// The indices of a curve.
struct CurvePlace {
  std::uint32_t layer = 0;
  std::uint32_t curve = 0;

  friend bool operator==(const CurvePlace&, const CurvePlace&) = default;
};

/// Some curves of a layer.
struct LayerCurves {
  std::uint32_t layer = 0;
  std::vector<std::uint32_t> curves{};  ///< ascending, at least one

  friend bool operator==(const LayerCurves&, const LayerCurves&) = default;
};

/// A state of a document.
struct Revision {
  std::shared_ptr<const char> document;  ///< identifies the document; not read
  std::uint64_t edits = 0;               ///< number of edits so far

  friend bool operator==(const Revision&, const Revision&) = default;
};

/// One edit of a curve. Its indices are those at the time of the edit.
struct Edit {
  enum class Kind : std::uint8_t { replaced, inserted, removed };

  Kind kind;
  CurvePlace place;

  friend bool operator==(const Edit&, const Edit&) = default;
};

/// Returns the edit that a change makes; none if it does not edit a curve.
std::optional<Edit> edit_of(const Change& change);

/// The last few hundred edits of one document. They show which curves changed since an earlier
/// state, without a comparison of documents.
class Edits {
 public:
  const Revision& now() const { return now_; }

  /// Notes an edit; none: an edit of anything other than a curve.
  void note(std::optional<Edit> edit);

  /// Returns the edits since a state, in their order; none if they are unknown. A run of
  /// replacements of one curve counts once.
  std::optional<std::vector<Edit>> since(const Revision& then) const;

  /// Returns the curves that were replaced since, if all are in one layer and nothing else was
  /// edited; none otherwise.
  std::optional<LayerCurves> only_changes_since(const Revision& then) const;

 private:
  struct Noted {
    Edit edit;
    std::uint64_t last;  ///< number of edits up to this one, or to the last of its run
  };

  Revision now_{std::make_shared<const char>('\0'), 0};
  std::deque<Noted> noted_;
  std::uint64_t before_ = 0;  ///< number of edits before the first noted one
};

/// Returns the changes that turn the document before `edits` into `now`, the document after them.
/// Returns none if an inserted curve may be one that was removed: compare the documents then.
std::optional<std::vector<Change>> changes_of(const std::vector<Edit>& edits, const Document& now);

}  // namespace sfumato::capi
