#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sfumato/base/status.hpp"

namespace sfumato::cli {

/// What the page shows.
struct WatchState {
  std::string name;                   ///< of the drawing
  std::vector<std::uint8_t> picture;  ///< PNG, the last good one; empty: none so far
  std::uint64_t picture_version = 0;  ///< of the picture alone
  std::vector<std::string> messages;  ///< lines
  bool failed = false;                ///< the newest drawing could not be drawn
  double seconds = 0;                 ///< that the picture took
};

/// A page on 127.0.0.1 that shows the newest state. Answers GET only, and only where Host names
/// this address, so that no other site's page reaches it by a name of its own; serves no files.
/// Runs a thread of its own, which blocks all signals.
class WatchServer {
 public:
  /// port   0: any that is free. Errors: io.
  static Result<std::unique_ptr<WatchServer>> start(int port);
  ~WatchServer();
  WatchServer(const WatchServer&) = delete;
  WatchServer& operator=(const WatchServer&) = delete;

  int port() const;
  /// Answers all that wait for a change.
  void publish(WatchState state);

 private:
  class Loop;
  explicit WatchServer(std::unique_ptr<Loop> loop);

  std::unique_ptr<Loop> loop_;
};

}  // namespace sfumato::cli
