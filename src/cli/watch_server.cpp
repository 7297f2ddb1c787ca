#include "cli/watch_server.hpp"

#include <event2/buffer.h>
#include <event2/event.h>
#include <event2/http.h>
#include <event2/keyvalq_struct.h>
#include <event2/listener.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <mutex>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "base/json.hpp"
#include "cli/watch_page.hpp"

namespace sfumato::cli {
namespace {

constexpr const char* kAddress = "127.0.0.1";
constexpr int kIdleSeconds = 60;          ///< a connection that says nothing ends
constexpr std::size_t kMostWaiting = 64;  ///< more are answered at once
constexpr int kHeaderBytes = 16 * 1024;

/// Nothing from elsewhere, no code but the page's own file, in no other site's frame.
constexpr const char* kPolicy =
    "default-src 'none'; img-src 'self' data:; script-src 'self'; style-src 'self'; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

struct FreeEvents {
  void operator()(event_base* base) const { event_base_free(base); }
  void operator()(event* one) const { event_free(one); }
  void operator()(evhttp* server) const { evhttp_free(server); }
};

void add_headers(evhttp_request* request, const char* type) {
  evkeyvalq* headers = evhttp_request_get_output_headers(request);
  evhttp_add_header(headers, "Content-Type", type);
  evhttp_add_header(headers, "Content-Security-Policy", kPolicy);
  evhttp_add_header(headers, "X-Content-Type-Options", "nosniff");
  evhttp_add_header(headers, "Cross-Origin-Resource-Policy", "same-origin");
  evhttp_add_header(headers, "Referrer-Policy", "no-referrer");
  evhttp_add_header(headers, "Cache-Control", "no-store");
}

void reply(evhttp_request* request, int code, const char* type, std::string_view body) {
  add_headers(request, type);
  evbuffer_add(evhttp_request_get_output_buffer(request), body.data(), body.size());
  evhttp_send_reply(request, code, nullptr, nullptr);
}

/// A number that no other run of the command has: a page may outlive the one that it came from.
std::uint64_t number_of_run() {
  const auto time = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::milliseconds>(time).count());
}

/// The number after "?after="; 0 where there is none.
std::uint64_t version_asked(evhttp_request* request) {
  const char* query = evhttp_uri_get_query(evhttp_request_get_evhttp_uri(request));
  std::string_view text = query ? query : "";
  constexpr std::string_view kName = "after=";
  if (!text.starts_with(kName)) return 0;
  text.remove_prefix(kName.size());
  std::uint64_t version = 0;
  std::from_chars(text.data(), text.data() + text.size(), version);
  return version;
}

}  // namespace

class WatchServer::Loop {
 public:
  ~Loop();
  Status start(int port);
  int port() const { return port_; }
  void publish(WatchState state);

 private:
  static void on_request(evhttp_request* request, void* self) {
    static_cast<Loop*>(self)->answer(request);
  }
  static void on_closed(evhttp_connection* connection, void* self) {
    static_cast<Loop*>(self)->forget(connection);
  }
  static void on_wake(evutil_socket_t, short, void* self) { static_cast<Loop*>(self)->wake(); }

  Status bind(int port);
  bool is_for_us(evhttp_request* request) const;
  void answer(evhttp_request* request);
  void answer_state(evhttp_request* request);
  void forget(evhttp_connection* connection);
  void wake();
  void ring(char what) const;
  std::string state_json();

  std::unique_ptr<event_base, FreeEvents> base_;
  std::unique_ptr<evhttp, FreeEvents> server_;
  std::unique_ptr<event, FreeEvents> wake_event_;
  std::array<int, 2> pipe_{-1, -1};
  int port_ = 0;
  std::vector<evhttp_request*> waiting_;  ///< of the loop's thread
  std::mutex mutex_;
  WatchState state_;
  const std::uint64_t run_ = number_of_run();
  std::uint64_t version_ = 0;  ///< of the state; counts from run_, 0: nothing was published
  std::thread thread_;
};

Status WatchServer::Loop::bind(int port) {
  evhttp_bound_socket* bound =
      evhttp_bind_socket_with_handle(server_.get(), kAddress, static_cast<std::uint16_t>(port));
  sockaddr_in address{};
  socklen_t length = sizeof(address);
  if (!bound || getsockname(evhttp_bound_socket_get_fd(bound),
                            reinterpret_cast<sockaddr*>(&address), &length) != 0) {
    return make_error(StatusCode::io, "port " + std::to_string(port) +
                                          " of 127.0.0.1 cannot be had; expected another --port");
  }
  port_ = ntohs(address.sin_port);
  return ok_status();
}

Status WatchServer::Loop::start(int port) {
  base_.reset(event_base_new());
  if (base_) server_.reset(evhttp_new(base_.get()));
  if (!server_ || pipe2(pipe_.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
    return make_error(StatusCode::io, "the page's server cannot be started");
  }
  evhttp_set_allowed_methods(server_.get(), EVHTTP_REQ_GET | EVHTTP_REQ_HEAD);
  evhttp_set_max_headers_size(server_.get(), kHeaderBytes);
  evhttp_set_max_body_size(server_.get(), 0);
  evhttp_set_timeout(server_.get(), kIdleSeconds);
  evhttp_set_gencb(server_.get(), on_request, this);
  if (Status status = bind(port); !status) return status;
  wake_event_.reset(event_new(base_.get(), pipe_[0], EV_READ | EV_PERSIST, on_wake, this));
  if (!wake_event_ || event_add(wake_event_.get(), nullptr) != 0) {
    return make_error(StatusCode::io, "the page's server cannot be started");
  }
  // Signals are the main thread's: it ends what it waits for.
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  try {
    thread_ = std::thread([this] { event_base_dispatch(base_.get()); });
  } catch (const std::system_error&) {
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    return make_error(StatusCode::io, "the page's server gets no thread");
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return ok_status();
}

WatchServer::Loop::~Loop() {
  if (thread_.joinable()) {
    ring('q');
    thread_.join();
  }
  wake_event_.reset();
  server_.reset();
  base_.reset();
  for (const int end : pipe_) {
    if (end >= 0) close(end);
  }
}

void WatchServer::Loop::ring(char what) const {
  while (write(pipe_[1], &what, 1) < 0 && errno == EINTR) {
  }
}

void WatchServer::Loop::publish(WatchState state) {
  {
    const std::scoped_lock lock(mutex_);
    state_ = std::move(state);
    version_ = std::max(version_, run_) + 1;
  }
  ring('p');
}

/// In the loop's thread: something was published, or it is to end.
void WatchServer::Loop::wake() {
  std::array<char, 64> rings{};
  const ssize_t count = read(pipe_[0], rings.data(), rings.size());
  for (ssize_t i = 0; i < count; ++i) {
    if (rings[static_cast<std::size_t>(i)] == 'q') event_base_loopbreak(base_.get());
  }
  const std::string json = state_json();
  for (evhttp_request* request : std::exchange(waiting_, {})) {
    if (evhttp_connection* connection = evhttp_request_get_connection(request)) {
      evhttp_connection_set_closecb(connection, nullptr, nullptr);
    }
    reply(request, HTTP_OK, "application/json", json);
  }
}

bool WatchServer::Loop::is_for_us(evhttp_request* request) const {
  const char* host = evhttp_find_header(evhttp_request_get_input_headers(request), "Host");
  const std::string port = ':' + std::to_string(port_);
  return host && (host == kAddress + port || host == "localhost" + port);
}

void WatchServer::Loop::answer(evhttp_request* request) {
  if (!is_for_us(request)) {
    return reply(request, 403, "text/plain", "expected the address that was printed\n");
  }
  const char* raw = evhttp_uri_get_path(evhttp_request_get_evhttp_uri(request));
  const std::string_view path = raw ? raw : "";
  if (path == "/" || path.empty()) {
    return reply(request, HTTP_OK, "text/html; charset=utf-8", watch_page::kHtml);
  }
  if (path == "/watch.css") return reply(request, HTTP_OK, "text/css", watch_page::kStyle);
  if (path == "/watch.js") return reply(request, HTTP_OK, "text/javascript", watch_page::kScript);
  if (path == "/state") return answer_state(request);
  const std::scoped_lock lock(mutex_);
  if (path == "/picture.png" && !state_.picture.empty()) {
    const auto* bytes = reinterpret_cast<const char*>(state_.picture.data());
    return reply(request, HTTP_OK, "image/png", {bytes, state_.picture.size()});
  }
  reply(request, HTTP_NOTFOUND, "text/plain", "there is nothing of this name\n");
}

/// At once where it is newer than what the page has, else as soon as it is.
void WatchServer::Loop::answer_state(evhttp_request* request) {
  const std::uint64_t known = version_asked(request);
  bool is_new = false;
  {
    const std::scoped_lock lock(mutex_);
    is_new = version_ != known;
  }
  if (is_new || waiting_.size() >= kMostWaiting) {
    return reply(request, HTTP_OK, "application/json", state_json());
  }
  evhttp_connection_set_closecb(evhttp_request_get_connection(request), on_closed, this);
  waiting_.push_back(request);
}

void WatchServer::Loop::forget(evhttp_connection* connection) {
  std::erase_if(waiting_, [connection](evhttp_request* request) {
    return evhttp_request_get_connection(request) == connection;
  });
}

std::string WatchServer::Loop::state_json() {
  const std::scoped_lock lock(mutex_);
  JsonWriter json;
  json.begin_object().member("run", run_).member("version", version_).member("name", state_.name);
  json.member("picture", state_.picture.empty() ? 0 : state_.picture_version);
  json.key("failed").truth(state_.failed).member("seconds", state_.seconds);
  json.key("messages").begin_array();
  for (const std::string& message : state_.messages) json.value(message);
  json.end_array().end_object();
  return json.text();
}

Result<std::unique_ptr<WatchServer>> WatchServer::start(int port) {
  auto loop = std::make_unique<Loop>();
  if (Status status = loop->start(port); !status) return status;
  return std::unique_ptr<WatchServer>(new WatchServer(std::move(loop)));
}

WatchServer::WatchServer(std::unique_ptr<Loop> loop) : loop_(std::move(loop)) {}
WatchServer::~WatchServer() = default;

int WatchServer::port() const {
  return loop_->port();
}

void WatchServer::publish(WatchState state) {
  loop_->publish(std::move(state));
}

}  // namespace sfumato::cli
