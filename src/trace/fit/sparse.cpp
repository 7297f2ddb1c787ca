#include "trace/fit/sparse.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "base/lanes.hpp"
#include "base/limit_error.hpp"
#include "base/parallel.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"

namespace sfumato::tracing {
namespace {

/// Rows that one task computes.
constexpr std::size_t kRowsPerTask = 128;
/// Rows that one task transposes at least. It has a number for each column, so that with as many
/// rows as columns these take no more than the matrix.
constexpr std::size_t kLeastSliceRows = 8192;

/// Lists of entries of consecutive rows, each made by one task.
struct RowBlock {
  std::vector<std::uint32_t> count;  ///< per row
  std::vector<std::uint32_t> column;
  std::vector<float> value;
  TableMemory memory{"the equations of a fit"};
  std::size_t bytes = 0;  ///< that are charged
};

Status join(Context& context, std::vector<RowBlock>& blocks, SparseMatrix& out) {
  std::size_t rows = 0, entries = 0;
  for (const RowBlock& block : blocks) {
    rows += block.count.size();
    entries += block.column.size();
  }
  if (entries > std::numeric_limits<std::uint32_t>::max()) {
    return make_limit_error("memory", "too many entries in the equations of a fit");
  }
  SFUMATO_TRY(out.memory.reserve(context, out.begin, rows + 1));
  SFUMATO_TRY(out.memory.resize(context, out.column, entries));
  SFUMATO_TRY(out.memory.resize(context, out.value, entries));
  for (const RowBlock& block : blocks) {
    for (const std::uint32_t count : block.count) out.begin.push_back(out.begin.back() + count);
  }
  return parallel_for(context, blocks.size(), 1, [&](std::size_t i, std::size_t end) {
    for (; i < end; ++i) {
      const auto at = static_cast<std::ptrdiff_t>(out.begin[i * kRowsPerTask]);
      std::ranges::copy(blocks[i].column, out.column.begin() + at);
      std::ranges::copy(blocks[i].value, out.value.begin() + at);
      blocks[i] = {};
    }
  });
}

/// Joins the two halves of a symmetric matrix, both with the diagonal.
Result<SparseMatrix> with_lower_half(Context& context, const SparseMatrix& upper,
                                     const SparseMatrix& lower) {
  SparseMatrix out;
  out.column_count = upper.column_count;
  const std::size_t rows = upper.row_count();
  const std::size_t entries = 2 * upper.column.size();  // the diagonal is counted twice
  SFUMATO_TRY(out.memory.reserve(context, out.begin, rows + 1));
  SFUMATO_TRY(out.memory.reserve(context, out.column, entries));
  SFUMATO_TRY(out.memory.reserve(context, out.value, entries));
  const auto append = [&](const SparseMatrix& half, std::uint32_t row, bool has_diagonal) {
    for (std::uint32_t k = half.begin[row]; k < half.begin[row + 1]; ++k) {
      if (half.column[k] == row && !has_diagonal) continue;
      out.column.push_back(half.column[k]);
      out.value.push_back(half.value[k]);
    }
  };
  for (std::uint32_t row = 0; row < rows; ++row) {
    if (context.cancelled()) return context.cancel_status();
    append(lower, row, false);
    append(upper, row, true);
    out.begin.push_back(static_cast<std::uint32_t>(out.column.size()));
  }
  return out;
}

}  // namespace

std::uint32_t RowSummer::list(std::vector<std::uint32_t>& column, std::vector<float>& value) {
  const std::size_t before = column.size();
  for (std::size_t word = 0; word < is_met_.size(); ++word) {
    for (std::uint64_t bits = std::exchange(is_met_[word], 0); bits != 0; bits &= bits - 1) {
      const std::size_t at = 64 * word + static_cast<std::size_t>(std::countr_zero(bits));
      column.push_back(static_cast<std::uint32_t>(at));
      value.push_back(std::exchange(sum_[at], 0.0f));
    }
  }
  return static_cast<std::uint32_t>(column.size() - before);
}

Result<SparseMatrix> try_build_rows(Context& context, std::size_t row_count,
                                    std::uint32_t column_count,
                                    FunctionRef<Status(std::size_t, RowSummer&)> fill) {
  SparseMatrix out;
  out.column_count = column_count;
  std::vector<RowBlock> blocks((row_count + kRowsPerTask - 1) / kRowsPerTask);
  const auto fill_block = [&](std::size_t i, std::size_t end) -> Status {
    RowSummer sum(column_count);
    RowBlock& block = blocks[i / kRowsPerTask];
    for (; i < end; ++i) {
      if (context.cancelled()) return context.cancel_status();
      SFUMATO_TRY(fill(i, sum));
      block.count.push_back(sum.list(block.column, block.value));
    }
    return block.memory.settle(context, capacity_bytes(block.count, block.column, block.value),
                               block.bytes);
  };
  SFUMATO_TRY(try_parallel_for(context, row_count, kRowsPerTask, fill_block));
  SFUMATO_TRY(join(context, blocks, out));
  return out;
}

Result<SparseMatrix> build_rows(Context& context, std::size_t row_count, std::uint32_t column_count,
                                FunctionRef<void(std::size_t, RowSummer&)> fill) {
  return try_build_rows(context, row_count, column_count, [&](std::size_t row, RowSummer& sum) {
    fill(row, sum);
    return ok_status();
  });
}

Result<SparseMatrix> transposed(Context& context, const SparseMatrix& matrix) {
  SparseMatrix out;
  out.column_count = matrix.row_count();
  const std::size_t rows = matrix.row_count(), columns = matrix.column_count;
  const std::size_t slice_rows = std::max(kLeastSliceRows, columns);
  const std::size_t slices = std::max<std::size_t>((rows + slice_rows - 1) / slice_rows, 1);
  std::vector<std::uint32_t> next;  // per slice and column: where its next entry goes
  TableMemory memory("the equations of a fit");
  SFUMATO_TRY(memory.resize(context, next, slices * columns));
  SFUMATO_TRY(out.memory.resize(context, out.begin, columns + 1));
  SFUMATO_TRY(out.memory.resize(context, out.column, matrix.column.size()));
  SFUMATO_TRY(out.memory.resize(context, out.value, matrix.column.size()));
  const auto for_each_slice = [&](auto&& visit) {
    return try_parallel_for(context, rows, slice_rows, [&](std::size_t row, std::size_t end) {
      std::uint32_t* const of_slice = next.data() + row / slice_rows * columns;
      for (; row < end; ++row) {
        if (context.cancelled()) return context.cancel_status();
        for (std::uint32_t k = matrix.begin[row]; k < matrix.begin[row + 1]; ++k) {
          visit(of_slice[matrix.column[k]], static_cast<std::uint32_t>(row), matrix.value[k]);
        }
      }
      return ok_status();
    });
  };
  SFUMATO_TRY(for_each_slice([](std::uint32_t& count, std::uint32_t, float) { ++count; }));
  std::uint32_t sum = 0;
  RarePoll<4096> poll(context);
  for (std::size_t column = 0; column < columns; ++column) {
    if (poll.cancelled()) return context.cancel_status();
    for (std::size_t slice = 0; slice < slices; ++slice) {
      sum += std::exchange(next[slice * columns + column], sum);
    }
    out.begin[column + 1] = sum;
  }
  SFUMATO_TRY(for_each_slice([&](std::uint32_t& at, std::uint32_t row, float value) {
    out.column[at] = row;
    out.value[at++] = value;
  }));
  return out;
}

Result<SparseMatrix> normal_matrix(Context& context, const SparseMatrix& matrix,
                                   const SparseMatrix& transpose, std::span<const float> weight) {
  const auto sum_upper_half = [&](std::size_t i, RowSummer& sum) {
    // A stop that every pixel sees has a long row.
    RarePoll<1024> poll(context);
    for (std::uint32_t k = transpose.begin[i]; k < transpose.begin[i + 1]; ++k) {
      if (poll.cancelled()) return context.cancel_status();
      const std::uint32_t row = transpose.column[k];
      const float factor = transpose.value[k] * (weight.empty() ? 1.0f : weight[row]);
      const auto columns = matrix.column.begin();
      const auto end = columns + matrix.begin[row + 1];
      auto at = std::lower_bound(columns + matrix.begin[row], end, static_cast<std::uint32_t>(i));
      for (; at != end; ++at)
        sum.add(*at, factor * matrix.value[static_cast<std::size_t>(at - columns)]);
    }
    return ok_status();
  };
  SFUMATO_TRY_ASSIGN(auto&& upper, try_build_rows(context, matrix.column_count, matrix.column_count,
                                                  sum_upper_half));
  SFUMATO_TRY_ASSIGN(const SparseMatrix& lower, transposed(context, upper));
  return with_lower_half(context, upper, lower);
}

Result<SparseMatrix> product(Context& context, const SparseMatrix& a, const SparseMatrix& b) {
  return build_rows(context, a.row_count(), b.column_count, [&](std::size_t i, RowSummer& sum) {
    for (std::uint32_t k = a.begin[i]; k < a.begin[i + 1]; ++k) {
      const std::uint32_t row = a.column[k];
      for (std::uint32_t e = b.begin[row]; e < b.begin[row + 1]; ++e) {
        sum.add(b.column[e], a.value[k] * b.value[e]);
      }
    }
  });
}

Result<SparseMatrix> sum_of(Context& context, const SparseMatrix& a, const SparseMatrix& b) {
  return build_rows(context, a.row_count(), a.column_count, [&](std::size_t i, RowSummer& sum) {
    for (const SparseMatrix* matrix : {&a, &b}) {
      for (std::uint32_t k = matrix->begin[i]; k < matrix->begin[i + 1]; ++k) {
        sum.add(matrix->column[k], matrix->value[k]);
      }
    }
  });
}

Status multiply(Context& context, const SparseMatrix& matrix, std::span<const FourFloats> x,
                std::span<FourFloats> out) {
  return parallel_for(
      context, matrix.row_count(), 4 * kRowsPerTask, [&](std::size_t i, std::size_t end) {
        for (; i < end; ++i) {
          Lanes<4> sum = 0.0f;
          for (std::uint32_t k = matrix.begin[i]; k < matrix.begin[i + 1]; ++k) {
            sum = sum + matrix.value[k] * Lanes<4>::load(x[matrix.column[k]].data());
          }
          sum.store(out[i].data());
        }
      });
}

}  // namespace sfumato::tracing
