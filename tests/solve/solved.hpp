#pragma once

#include <gtest/gtest.h>

#include <utility>

#include "sfumato/solve/solution.hpp"

namespace sfumato::test {

/// Returns a Solution of a document, not solved yet.
inline Solution solution_of(Context& context, Document document) {
  Result<Solution> solution = Solution::create(context, std::move(document));
  EXPECT_TRUE(solution.ok()) << to_string(solution.status());
  return std::move(*solution);
}

/// Returns a solved Solution whose delta was taken.
inline Solution solved(Context& context, Document document, const DiffuseOptions& options = {}) {
  Solution solution = solution_of(context, std::move(document));
  const Status status = solution.solve(context, options);
  EXPECT_TRUE(status.ok()) << to_string(status);
  solution.take_delta();
  return solution;
}

/// Returns a solved Solution that reserves the data for drags.
inline Solution expecting_drags(Context& context, Document document) {
  Solution solution = solution_of(context, std::move(document));
  solution.expect_drags();
  const Status status = solution.solve(context, {});
  EXPECT_TRUE(status.ok()) << to_string(status);
  return solution;
}

}  // namespace sfumato::test
