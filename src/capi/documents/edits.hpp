#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

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

/// One edit of a curve; indices are those at its time.
struct Edit {
  enum class Kind : std::uint8_t { replaced, inserted, removed };

  Kind kind;
  CurvePlace place;

  friend bool operator==(const Edit&, const Edit&) = default;
};

/// What an edit does, where it is one of a curve.
std::optional<Edit> edit_of(const Change& change);

/// The edits of one document: what has changed since an earlier state is found without comparing
/// documents. The last few hundred are known.
class Edits {
 public:
  const Revision& now() const { return now_; }

  /// Notes an edit; none: one that is not of a curve.
  void note(std::optional<Edit> edit);

  /// The edits since a state, in their order; none where they are not known. A run of replacements
  /// of one curve counts once.
  std::optional<std::vector<Edit>> since(const Revision& then) const;

  /// The curve that was replaced since, where nothing else was edited; none else.
  std::optional<CurvePlace> only_change_since(const Revision& then) const;

 private:
  struct Noted {
    Edit edit;
    std::uint64_t last;  ///< edits of the document up to this one, or to the last of its run
  };

  Revision now_{std::make_shared<const char>('\0'), 0};
  std::deque<Noted> noted_;
  std::uint64_t before_ = 0;  ///< edits before the first that is noted
};

/// The changes that bring a document, which was as it is before `edits`, to what `now` is after
/// them; none where they are not those alone.
std::optional<std::vector<Change>> changes_of(const std::vector<Edit>& edits, const Document& now);

}  // namespace sfumato::capi
