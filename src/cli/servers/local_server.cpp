#include "cli/servers/local_server.hpp"

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

#include "base/try.hpp"

namespace sfumato::cli {
namespace {

constexpr const char* kAddress = "127.0.0.1";
constexpr int kHttpPort = 80;
constexpr int kIdleSeconds = 60;  ///< a connection that sends nothing ends
constexpr int kHeaderBytes = 16 * 1024;
constexpr char kRing = 'r', kQuit = 'q';
/// Descriptors reserved for the command's own files, so that connections cannot use them up.
constexpr int kSpareDescriptors = 8;
constexpr timeval kPause{0, 100'000};  ///< pause before a full server checks for descriptors again

struct FreeEvents {
  void operator()(event_base* base) const { event_base_free(base); }
  void operator()(event* one) const { event_free(one); }
  void operator()(evhttp* server) const { evhttp_free(server); }
};

/// Returns whether the process can open kSpareDescriptors more descriptors. `open_one`: any open
/// descriptor.
bool has_spare_descriptors(int open_one) {
  std::array<int, kSpareDescriptors> copies{};
  for (int& copy : copies) copy = fcntl(open_one, F_DUPFD_CLOEXEC, 0);
  for (const int copy : copies) {
    if (copy >= 0) close(copy);
  }
  return copies.back() >= 0;
}

void pause(evconnlistener* listener);

/// Accepts connections while the process has descriptors to spare.
void accept_more(evconnlistener* listener) {
  if (!has_spare_descriptors(evconnlistener_get_fd(listener))) return pause(listener);
  evconnlistener_enable(listener);
}

/// Accepts no connection for a moment. Connections that send nothing end and free descriptors.
void pause(evconnlistener* listener) {
  const auto resume = [](evutil_socket_t, short, void* paused) {
    accept_more(static_cast<evconnlistener*>(paused));
  };
  evconnlistener_disable(listener);
  const bool is_set = event_base_once(evconnlistener_get_base(listener), -1, EV_TIMEOUT, resume,
                                      listener, &kPause) == 0;
  if (!is_set) evconnlistener_enable(listener);
}

Status no_server() {
  return make_error(StatusCode::io, "the page's server cannot be started");
}

}  // namespace

class LocalServer::Loop {
 public:
  explicit Loop(Setup setup)
      : setup_(std::move(setup)),
        gate_(std::make_unique<BodyGate>(
            kHeaderBytes, [this](const RequestHead& head) { return admits(head); })) {}
  ~Loop();
  Status start();
  int port() const { return port_; }
  void ring(char what) const;

 private:
  static void on_request(evhttp_request* request, void* self) {
    static_cast<Loop*>(self)->answer(request);
  }
  static bufferevent* on_connection(event_base* base, void* self) {
    accept_more(static_cast<Loop*>(self)->listener_);
    return static_cast<Loop*>(self)->gate_->connection(base);
  }
  static void on_ring(evutil_socket_t, short, void* self) { static_cast<Loop*>(self)->rang(); }

  Status bind();
  Status start_thread();
  bool is_for_us(std::string_view host, std::string_view origin) const;
  bool admits(const RequestHead& head) const;
  void answer(evhttp_request* request);
  void rang();

  const Setup setup_;
  std::unique_ptr<event_base, FreeEvents> base_;
  std::unique_ptr<BodyGate> gate_;
  std::unique_ptr<evhttp, FreeEvents> server_;
  evconnlistener* listener_ = nullptr;
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
    return make_error(StatusCode::io,
                      "port " + std::to_string(setup_.port) +
                          " of 127.0.0.1 is not available; choose another with --port");
  }
  port_ = ntohs(address.sin_port);
  listener_ = evhttp_bound_socket_get_listener(bound);
  evconnlistener_set_error_cb(listener_, [](evconnlistener* full, void*) { pause(full); });
  evhttp_set_bevcb(server_.get(), on_connection, this);
  return ok_status();
}

Status LocalServer::Loop::start() {
  event_set_log_callback([](int, const char*) {});  // it would write to standard error
  base_.reset(event_base_new());
  if (base_) server_.reset(evhttp_new(base_.get()));
  if (!server_ || pipe2(pipe_.data(), O_CLOEXEC | O_NONBLOCK) != 0) return no_server();
  evhttp_set_allowed_methods(server_.get(), static_cast<std::uint16_t>(setup_.methods));
  evhttp_set_max_headers_size(server_.get(), kHeaderBytes);
  evhttp_set_max_body_size(server_.get(), static_cast<ev_ssize_t>(setup_.body_bytes));
  evhttp_set_timeout(server_.get(), kIdleSeconds);
  evhttp_set_gencb(server_.get(), on_request, this);
  SFUMATO_TRY(bind());
  ring_event_.reset(event_new(base_.get(), pipe_[0], EV_READ | EV_PERSIST, on_ring, this));
  if (!ring_event_ || event_add(ring_event_.get(), nullptr) != 0) return no_server();
  return start_thread();
}

/// The main thread handles the signals and ends the server.
Status LocalServer::Loop::start_thread() {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  Status status = ok_status();
  try {
    thread_ = std::thread([this] { event_base_dispatch(base_.get()); });
  } catch (const std::system_error&) {
    status = make_error(StatusCode::io, "the page's server cannot start a thread");
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
  gate_.reset();
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

bool LocalServer::Loop::is_for_us(std::string_view host, std::string_view origin) const {
  const auto names_us = [&](const std::string& name) {
    // Browsers leave out the port that HTTP has by default.
    return host == name + ':' + std::to_string(port_) || (port_ == kHttpPort && host == name);
  };
  if (!names_us(kAddress) && !names_us("localhost")) return false;
  return origin.empty() || origin == "http://" + std::string(host);
}

/// Admits a body that is too long: libevent answers with 413 and does not read it.
bool LocalServer::Loop::admits(const RequestHead& head) const {
  return is_for_us(head.host, head.origin) && setup_.admits && setup_.admits(head);
}

void LocalServer::Loop::answer(evhttp_request* request) {
  add_header(request, "Connection", "close");  // the gate looks at one head of a connection
  add_header(request, "Content-Security-Policy", std::string(setup_.policy));
  if (!is_for_us(header_of(request, "Host"), header_of(request, "Origin"))) {
    return reply(request, 403, "text/plain", "use the address that was printed\n");
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
