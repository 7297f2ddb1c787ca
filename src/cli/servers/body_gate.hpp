#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

struct bufferevent;
struct evbuffer;
struct evbuffer_cb_info;
struct event_base;

namespace sfumato::cli {

/// The head of a request: its first line, and the headers that decide whether the body is read. The
/// views point into the parsed text.
struct RequestHead {
  std::string_view method, target, version;
  std::string_view host, origin, if_match;  ///< empty: the header is missing
  std::optional<std::size_t> body_bytes;    ///< no value: Content-Length is missing
};

/// Parses a head up to its blank line. Returns no value if the head is malformed, or if a header of
/// RequestHead appears twice.
std::optional<RequestHead> parse_head(std::string_view text);

/// Returns the length of the head at the beginning of `text`, including its blank line; 0 if the
/// head is incomplete.
std::size_t head_size(std::string_view text);

/// Checks the head of a connection's only request before libevent, which reads the whole body
/// before it calls the server. The gate removes an unwanted body from its request, so that the
/// server answers at once. The gate then reads and drops the rest of that body for a while:
/// otherwise closing the connection could lose the answer. Use it in one thread.
class BodyGate {
 public:
  /// most_head_bytes   libevent handles longer heads
  /// admits            returns whether to read the body after a head
  BodyGate(std::size_t most_head_bytes, std::function<bool(const RequestHead&)> admits);
  ~BodyGate();
  BodyGate(const BodyGate&) = delete;
  BodyGate& operator=(const BodyGate&) = delete;

  /// Returns a checked connection, for evhttp_set_bevcb(). Null: libevent makes an unchecked one.
  bufferevent* connection(event_base* base);

 private:
  static void on_bytes(evbuffer* input, const evbuffer_cb_info* info, void* connection);

  /// Checks the received bytes. Returns whether libevent may read them.
  bool check(evbuffer* input, bufferevent* connection);
  void linger(bufferevent* connection);
  void end(bufferevent* lingering);

  const std::size_t most_head_bytes_;
  const std::function<bool(const RequestHead&)> admits_;
  std::vector<bufferevent*> lingering_;  ///< the oldest first
};

}  // namespace sfumato::cli
