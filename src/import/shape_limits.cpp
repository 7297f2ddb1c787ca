#include "import/shape_limits.hpp"

#include <string>
#include <string_view>

#include "base/limit_error.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg_import {

namespace {

constexpr std::string_view kCrossesTooOften = "it crosses itself too often";

Status over(const Context& context, std::size_t Limits::*limit, std::string_view fault,
            std::string_view what) {
  return make_limit_error(limit, std::string(fault) + ": more than the limit of " +
                                     limit_text(context.limits, limit, what));
}

}  // namespace

Status too_long(const Context& context) {
  return over(context, &Limits::chords, "its outline is too long", "chords");
}

Status has_too_many_crossings(const Context& context) {
  return over(context, &Limits::chords, kCrossesTooOften, "chords");
}

Status has_too_many_pairs(const Context& context) {
  return over(context, &Limits::chord_pairs, kCrossesTooOften, "pairs of chords");
}

}  // namespace sfumato::svg_import
