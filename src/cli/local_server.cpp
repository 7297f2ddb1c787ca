#include "cli/local_server.hpp"

#include <event2/buffer.h>
#include <event2/event.h>
#include <event2/http.h>
#include <event2/keyvalq_struct.h>
#include <event2/listener.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <new>
#include <system_error>
#include <thread>
#include <utility>

namespace sfumato::cli {
namespace {

constexpr const char* kAddress = "127.0.0.1";
constexpr int kIdleSeconds = 60;  ///< a connection that says nothing ends
constexpr int kHeaderBytes = 16 * 1024;
constexpr char kRing = 'r', kQuit = 'q';

struct FreeEvents {
  void operator()(event_base* base) const { event_base_free(base); }
  void operator()(event* one) const { event_free(one); }
  void operator()(evhttp* server) const { evhttp_free(server); }
};

Status no_server() {
  return make_error(StatusCode::io, "the page's server cannot be started");
}

}  // namespace

class LocalServer::Loop {
 public:
  explicit Loop(Setup setup) : setup_(std::move(setup)) {}
  ~Loop();
  Status start();
  int port() const { return port_; }
  void ring(char what) const;

 private:
  static void on_request(evhttp_request* request, void* self) {
    static_cast<Loop*>(self)->answer(request);
  }
  static void on_ring(evutil_socket_t, short, void* self) { static_cast<Loop*>(self)->rang(); }

  Status bind();
  Status start_thread();
  bool is_for_us(evhttp_request* request) const;
  void answer(evhttp_request* request);
  void rang();

  const Setup setup_;
  std::unique_ptr<event_base, FreeEvents> base_;
  std::unique_ptr<evhttp, FreeEvents> server_;
  std::unique_ptr<event, FreeEvents> ring_event_;
  std::array<int, 2> pipe_{-1, -1};
  int port_ = 0;
  std::thread thread_;
};

Status LocalServer::Loop::bind() {
  evhttp_bound_socket* bound = evhttp_bind_socket_with_handle(
      server_.get(), kAddress, static_cast<std::uint16_t>(setup_.port));
  sockaddr_in address{};
  socklen_t length = sizeof(address);
  if (!bound || getsockname(evhttp_bound_socket_get_fd(bound),
                            reinterpret_cast<sockaddr*>(&address), &length) != 0) {
    return make_error(StatusCode::io, "port " + std::to_string(setup_.port) +
                                          " of 127.0.0.1 cannot be had; expected another --port");
  }
  port_ = ntohs(address.sin_port);
  return ok_status();
}

Status LocalServer::Loop::start() {
  base_.reset(event_base_new());
  if (base_) server_.reset(evhttp_new(base_.get()));
  if (!server_ || pipe2(pipe_.data(), O_CLOEXEC | O_NONBLOCK) != 0) return no_server();
  evhttp_set_allowed_methods(server_.get(), static_cast<std::uint16_t>(setup_.methods));
  evhttp_set_max_headers_size(server_.get(), kHeaderBytes);
  evhttp_set_max_body_size(server_.get(), static_cast<ev_ssize_t>(setup_.body_bytes));
  evhttp_set_timeout(server_.get(), kIdleSeconds);
  evhttp_set_gencb(server_.get(), on_request, this);
  if (Status status = bind(); !status) return status;
  ring_event_.reset(event_new(base_.get(), pipe_[0], EV_READ | EV_PERSIST, on_ring, this));
  if (!ring_event_ || event_add(ring_event_.get(), nullptr) != 0) return no_server();
  return start_thread();
}

/// Signals are the main thread's: it ends what it waits for.
Status LocalServer::Loop::start_thread() {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  Status status = ok_status();
  try {
    thread_ = std::thread([this] { event_base_dispatch(base_.get()); });
  } catch (const std::system_error&) {
    status = make_error(StatusCode::io, "the page's server gets no thread");
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return status;
}

LocalServer::Loop::~Loop() {
  if (thread_.joinable()) {
    ring(kQuit);
    thread_.join();
  }
  ring_event_.reset();
  server_.reset();
  base_.reset();
  for (const int end : pipe_) {
    if (end >= 0) close(end);
  }
}

void LocalServer::Loop::ring(char what) const {
  while (write(pipe_[1], &what, 1) < 0 && errno == EINTR) {
  }
}

void LocalServer::Loop::rang() {
  std::array<char, 64> rings{};
  const ssize_t count = read(pipe_[0], rings.data(), rings.size());
  for (ssize_t i = 0; i < count; ++i) {
    if (rings[static_cast<std::size_t>(i)] == kQuit) event_base_loopbreak(base_.get());
  }
  if (setup_.rang) setup_.rang();
}

bool LocalServer::Loop::is_for_us(evhttp_request* request) const {
  const std::string port = ':' + std::to_string(port_);
  const std::string_view host = header_of(request, "Host"), origin = header_of(request, "Origin");
  if (host != kAddress + port && host != "localhost" + port) return false;
  return origin.empty() || origin == "http://" + std::string(host);
}

void LocalServer::Loop::answer(evhttp_request* request) {
  add_header(request, "Content-Security-Policy", std::string(setup_.policy));
  if (!is_for_us(request)) {
    return reply(request, 403, "text/plain", "expected the address that was printed\n");
  }
  try {
    setup_.answer(request);
  } catch (const std::bad_alloc&) {  // libevent's frames let no exception through
    evhttp_send_error(request, HTTP_INTERNAL, nullptr);
  }
}

LocalServer::LocalServer() = default;
LocalServer::~LocalServer() = default;

Status LocalServer::start(Setup setup) {
  loop_ = std::make_unique<Loop>(std::move(setup));
  return loop_->start();
}

int LocalServer::port() const {
  return loop_->port();
}

void LocalServer::ring() const {
  loop_->ring(kRing);
}

std::string_view path_of(evhttp_request* request) {
  const char* path = evhttp_uri_get_path(evhttp_request_get_evhttp_uri(request));
  return path ? path : "";
}

std::string_view query_of(evhttp_request* request) {
  const char* query = evhttp_uri_get_query(evhttp_request_get_evhttp_uri(request));
  return query ? query : "";
}

std::string_view header_of(evhttp_request* request, const char* name) {
  const char* value = evhttp_find_header(evhttp_request_get_input_headers(request), name);
  return value ? value : "";
}

void add_header(evhttp_request* request, const char* name, const std::string& value) {
  evhttp_add_header(evhttp_request_get_output_headers(request), name, value.c_str());
}

void reply(evhttp_request* request, int code, const char* type, std::string_view body) {
  add_header(request, "Content-Type", type);
  add_header(request, "X-Content-Type-Options", "nosniff");
  add_header(request, "Cross-Origin-Resource-Policy", "same-origin");
  add_header(request, "Referrer-Policy", "no-referrer");
  add_header(request, "Cache-Control", "no-store");
  evbuffer_add(evhttp_request_get_output_buffer(request), body.data(), body.size());
  evhttp_send_reply(request, code, nullptr, nullptr);
}

void reply_nothing(evhttp_request* request) {
  reply(request, HTTP_NOTFOUND, "text/plain", "there is nothing of this name\n");
}

}  // namespace sfumato::cli
