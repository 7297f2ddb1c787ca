#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sfumato/base/status.hpp"

namespace sfumato::cli {

/// The state that the page shows.
struct WatchState {
  std::string name;                   ///< name of the drawing
  std::vector<std::uint8_t> picture;  ///< PNG of the last good drawing; empty: none so far
  std::uint64_t picture_version = 0;  ///< version of the picture alone
  std::vector<std::string> messages;  ///< lines
  bool failed = false;                ///< the latest drawing could not be drawn
  double seconds = 0;                 ///< drawing time of the picture
};

/// Serves a page on 127.0.0.1 that shows the newest state. Answers only GET, and only if Host names
/// this address, so that no other site's page can reach it under its own name. Serves no files.
/// Runs its own thread, which blocks all signals.
class WatchServer {
 public:
  /// port   0: any free port. Errors: io.
  static Result<std::unique_ptr<WatchServer>> start(int port);
  ~WatchServer();
  WatchServer(const WatchServer&) = delete;
  WatchServer& operator=(const WatchServer&) = delete;

  int port() const;
  /// Answers all requests that wait for a change.
  void publish(WatchState state);

 private:
  class Loop;
  explicit WatchServer(std::unique_ptr<Loop> loop);

  std::unique_ptr<Loop> loop_;
};

}  // namespace sfumato::cli
