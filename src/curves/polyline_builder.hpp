#pragma once

#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "curves/flatten.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::curves {

/// Appends vertices to a FlatCurves, within the limit of segments and the memory budget.
class PolylineBuilder {
 public:
  explicit PolylineBuilder(Context& context) : context_(context), poll_(context) {}

  /// Returns the status. After limit or cancelled nothing more is appended.
  const Status& status() const { return status_; }
  Context& context() const { return context_; }

  void begin_curve();
  void push(Vec2 point, double parameter);
  /// Sets the bow of the segment that the last vertex begins. Call it for all segments or none.
  void set_bow(const ChordBow& bow);
  void end_last_curve();

  const FlatCurves& flat() const { return flat_; }
  /// Returns the result, which is no longer charged. Call it once, last.
  FlatCurves take() { return std::move(flat_); }

 private:
  void make_room();

  Context& context_;
  RarePoll<1024> poll_;
  Status status_;
  TableMemory memory_{"flattening"};
  FlatCurves flat_;
};

}  // namespace sfumato::curves
