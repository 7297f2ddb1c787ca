#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::tracing {

/// A sparse matrix by rows: row i has the entries begin[i] to begin[i + 1], columns ascending.
struct SparseMatrix {
  std::uint32_t column_count = 0;
  std::vector<std::uint32_t> begin{0};
  std::vector<std::uint32_t> column;
  std::vector<float> value;
  TableMemory memory{"the equations of a fit"};

  std::uint32_t row_count() const { return static_cast<std::uint32_t>(begin.size() - 1); }
};

/// Numbers of up to four channels, which are solved for side by side.
using FourFloats = std::array<float, 4>;

/// Sums one row of a matrix in full; its entries are listed afterwards.
class RowSummer {
 public:
  explicit RowSummer(std::uint32_t column_count)
      : sum_(column_count), is_met_((column_count + 63) / 64) {}

  void add(std::uint32_t column, float value) {
    sum_[column] += value;
    is_met_[column / 64] |= std::uint64_t{1} << column % 64;
  }

  /// Appends the row to lists of columns, ascending, and values, and begins another. Returns the
  /// number of its entries.
  std::uint32_t list(std::vector<std::uint32_t>& column, std::vector<float>& value);

 private:
  std::vector<float> sum_;
  std::vector<std::uint64_t> is_met_;  ///< one bit to a column
};

/// Errors of all: limit (memory), cancelled. All run on the pool, with the same bits for any number
/// of threads.

/// A matrix whose row i is what fill(i, sum) adds to `sum`.
Result<SparseMatrix> build_rows(Context& context, std::size_t row_count, std::uint32_t column_count,
                                FunctionRef<void(std::size_t row, RowSummer& sum)> fill);

/// Returns the same, with a fill that polls within long rows and may fail.
Result<SparseMatrix> try_build_rows(Context& context, std::size_t row_count,
                                    std::uint32_t column_count,
                                    FunctionRef<Status(std::size_t row, RowSummer& sum)> fill);

Result<SparseMatrix> transposed(Context& context, const SparseMatrix& matrix);

/// AᵀWA, both halves of it.
/// transpose   Aᵀ
/// weight      the diagonal of W, per row of A; empty: 1
Result<SparseMatrix> normal_matrix(Context& context, const SparseMatrix& matrix,
                                   const SparseMatrix& transpose, std::span<const float> weight);

/// Returns a B.
Result<SparseMatrix> product(Context& context, const SparseMatrix& a, const SparseMatrix& b);

/// Returns a + B, of one size.
Result<SparseMatrix> sum_of(Context& context, const SparseMatrix& a, const SparseMatrix& b);

/// out = A x, for four channels.
Status multiply(Context& context, const SparseMatrix& matrix, std::span<const FourFloats> x,
                std::span<FourFloats> out);

}  // namespace sfumato::tracing
