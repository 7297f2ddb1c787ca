#include "cli/servers/body_gate.hpp"

#include <event2/buffer.h>
#include <event2/bufferevent.h>
#include <event2/event.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <new>
#include <utility>

#include "base/text/ascii.hpp"
#include "options/values.hpp"

namespace sfumato::cli {
namespace {

constexpr std::size_t kMostLingering = 16;
constexpr timeval kLingerPause{2, 0};  ///< a sender is done after this pause

/// The gate of this thread: the only pointer that a callback can carry is the bufferevent.
thread_local BodyGate* gate_of_thread = nullptr;

/// Removes the first line from the text, and returns it without its line break.
std::string_view next_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// Returns whether the line has three words.
bool parse_first_line(std::string_view line, RequestHead& head) {
  const std::size_t first = line.find(' '), last = line.rfind(' ');
  if (first == std::string_view::npos || first == last) return false;
  head.method = line.substr(0, first);
  head.target = line.substr(first + 1, last - first - 1);
  head.version = line.substr(last + 1);
  return head.target.find(' ') == std::string_view::npos;
}

/// Sets a header. Returns false if it is set already, or empty: programs interpret duplicates
/// differently.
bool put_once(std::string_view value, std::string_view& header) {
  if (!header.empty() || value.empty()) return false;
  header = value;
  return true;
}

bool parse_size(std::string_view value, std::optional<std::size_t>& size) {
  if (size) return false;
  size = options::parse_whole(value, 0, SIZE_MAX);
  return size.has_value();
}

bool parse_header(std::string_view line, RequestHead& head) {
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos || is_ascii_blank(line.front())) return false;
  const std::string name = ascii_lower(line.substr(0, colon));
  const std::string_view value = ascii_trimmed(line.substr(colon + 1));
  if (name == "host") return put_once(value, head.host);
  if (name == "origin") return put_once(value, head.origin);
  if (name == "if-match") return put_once(value, head.if_match);
  return name != "content-length" || parse_size(value, head.body_bytes);
}

/// Returns whether libevent may find a body after the head.
bool has_body(std::string_view head) {
  const std::string lower = ascii_lower(head);
  return lower.find("\ncontent-length") != std::string::npos ||
         lower.find("\ntransfer-encoding") != std::string::npos;
}

/// Returns a head that announces no body, with the headers that the answer depends on.
std::string without_body(std::string_view head) {
  std::string result(next_line(head));
  while (!head.empty()) {
    const std::string_view line = next_line(head);
    const std::string name = ascii_lower(line.substr(0, line.find(':')));
    if (name == "host" || name == "origin" || name == "if-match")
      result.append("\r\n").append(line);
  }
  return result + "\r\n\r\n";
}

/// Returns the head without zero bytes, at which libevent would end a line.
std::string without_zeros(std::string_view head) {
  std::string result(head);
  std::erase(result, '\0');
  return result;
}

}  // namespace

std::optional<RequestHead> parse_head(std::string_view text) {
  RequestHead head;
  if (text.find('\0') != std::string_view::npos || !parse_first_line(next_line(text), head))
    return std::nullopt;
  while (!text.empty()) {
    const std::string_view line = next_line(text);
    if (!line.empty() && !parse_header(line, head)) return std::nullopt;
  }
  return head;
}

std::size_t head_size(std::string_view text) {
  const std::size_t bare = text.find("\n\n"), full = text.find("\n\r\n");
  if (bare == std::string_view::npos && full == std::string_view::npos) return 0;
  return bare < full ? bare + 2 : full + 3;
}

BodyGate::BodyGate(std::size_t most_head_bytes, std::function<bool(const RequestHead&)> admits)
    : most_head_bytes_(most_head_bytes), admits_(std::move(admits)) {}

BodyGate::~BodyGate() {
  while (!lingering_.empty()) end(lingering_.back());
}

/// The read watermark keeps all bytes from libevent until the head has been checked.
bufferevent* BodyGate::connection(event_base* base) {
  gate_of_thread = this;
  bufferevent* const made = bufferevent_socket_new(base, -1, 0);
  if (!made) return nullptr;
  bufferevent_setwatermark(made, EV_READ, most_head_bytes_ + 1, 0);
  if (!evbuffer_add_cb(bufferevent_get_input(made), on_bytes, made))
    bufferevent_setwatermark(made, EV_READ, 0, 0);
  return made;
}

void BodyGate::on_bytes(evbuffer* input, const evbuffer_cb_info* info, void* connection) {
  if (info->n_added == 0) return;
  auto* const one = static_cast<bufferevent*>(connection);
  bool goes_on = true;
  try {
    goes_on = gate_of_thread->check(input, one);
  } catch (const std::bad_alloc&) {  // libevent reads the body, and the server refuses it then
  }
  if (!goes_on) return;
  evbuffer_remove_cb(input, on_bytes, connection);
  bufferevent_setwatermark(one, EV_READ, 0, 0);
}

bool BodyGate::check(evbuffer* input, bufferevent* connection) {
  const std::size_t size = std::min(evbuffer_get_length(input), most_head_bytes_ + 1);
  const auto* bytes =
      reinterpret_cast<const char*>(evbuffer_pullup(input, static_cast<ev_ssize_t>(size)));
  if (!bytes) return true;
  const std::string_view text(bytes, size);
  const std::size_t length = head_size(text);
  if (length == 0) return size > most_head_bytes_;
  const std::string_view head = text.substr(0, length);
  if (!has_body(without_zeros(head))) return true;
  const std::optional<RequestHead> parsed = parse_head(head);
  if (parsed && admits_(*parsed)) return true;
  const std::string bare = without_body(without_zeros(head));
  linger(connection);
  evbuffer_remove_cb(input, on_bytes, connection);  // the next calls change the buffer
  evbuffer_drain(input, evbuffer_get_length(input));
  evbuffer_add(input, bare.data(), bare.size());
  return true;
}

/// Keeps the connection open by a second descriptor when libevent closes its own.
void BodyGate::linger(bufferevent* connection) {
  const int copy = fcntl(bufferevent_getfd(connection), F_DUPFD_CLOEXEC, 0);
  if (copy < 0) return;
  bufferevent* const reader =
      bufferevent_socket_new(bufferevent_get_base(connection), copy, BEV_OPT_CLOSE_ON_FREE);
  if (!reader) {
    close(copy);
    return;
  }
  lingering_.push_back(reader);
  const auto forget = [](bufferevent* from, void*) {
    evbuffer* const input = bufferevent_get_input(from);
    evbuffer_drain(input, evbuffer_get_length(input));
  };
  const auto ended = [](bufferevent* from, short, void* gate) {
    static_cast<BodyGate*>(gate)->end(from);
  };
  bufferevent_setcb(reader, forget, nullptr, ended, this);
  bufferevent_set_timeouts(reader, &kLingerPause, nullptr);
  bufferevent_enable(reader, EV_READ);
  if (lingering_.size() > kMostLingering) end(lingering_.front());
}

void BodyGate::end(bufferevent* lingering) {
  std::erase(lingering_, lingering);
  bufferevent_free(lingering);
}

}  // namespace sfumato::cli
