#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <string>

#include "allocation/failing_allocator.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato::test {

/// Which allocations of an operation are refused, one in each run.
struct Sampling {
  std::size_t every = 1;         ///< every so many
  Executor* executor = nullptr;  ///< with an executor, blocks that its threads keep are not counted
  /// Another allowed code, for a library that hides the reason.
  StatusCode also = StatusCode::out_of_memory;
};

/// Runs make(context), which returns a Result, with its k-th allocation refused, for one k after
/// another until it needs no more than k allocations: once with only that allocation refused, once
/// with all from there on. Each time it must return `out_of_memory`, or succeed with the usual
/// digest(*result), a string. It must leave no memory and no charges behind, and the same call in
/// the same Context must then work.
template <class Make, class Digest>
void expect_every_refusal_is_survived(const std::string& name, const Make& make,
                                      const Digest& digest, const Sampling& sampling = {}) {
  Context plain{.executor = sampling.executor};
  std::string expected;
  for (int i = 0; i < 2; ++i) {  // the first run also makes objects that are made only once
    const auto result = make(plain);
    ASSERT_TRUE(result.ok()) << name << ": " << to_string(result.status());
    expected = digest(*result);
  }
  std::size_t refused = 0;
  for (const Refusal refusal : {Refusal::one, Refusal::all_from}) {
    bool was_refused = true;
    for (std::size_t k = 0; was_refused; k += sampling.every) {
      const std::string what = name + ", allocation " + std::to_string(k) +
                               (refusal == Refusal::one ? " alone" : " and all after it");
      const std::ptrdiff_t live = live_allocations();
      Context context{.executor = sampling.executor};
      {
        std::optional<decltype(make(plain))> result;
        {
          const RefusedAllocations refused_allocations(k, refusal);
          result.emplace(make(context));
          was_refused = RefusedAllocations::requests() > k;
        }
        if (result->ok()) {
          ASSERT_TRUE(digest(**result) == expected) << what << ": a wrong success";
        } else {
          ASSERT_TRUE(was_refused) << what << ": " << to_string(result->status());
          const StatusCode code = result->status().code;
          ASSERT_TRUE(code == StatusCode::out_of_memory || code == sampling.also)
              << what << ": " << to_string(result->status());
          ++refused;
        }
      }
      ASSERT_EQ(context.budget.used(), 0u) << what;
      if (sampling.executor == nullptr) {
        ASSERT_EQ(live_allocations(), live) << what << ": a leak";
      }
      const auto again = make(context);
      ASSERT_TRUE(again.ok()) << what << ", then: " << to_string(again.status());
      ASSERT_TRUE(digest(*again) == expected) << what << ", then other bytes";
    }
  }
  ASSERT_GT(refused, 0u) << name << ": nothing was refused";
  testing::Test::RecordProperty(name, std::to_string(refused));
}

}  // namespace sfumato::test
