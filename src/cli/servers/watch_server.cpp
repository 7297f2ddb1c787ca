#include "cli/servers/watch_server.hpp"

#include <event2/http.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <mutex>
#include <string_view>
#include <utility>

#include "base/text/json.hpp"
#include "base/try.hpp"
#include "cli/embedded.hpp"
#include "cli/servers/local_server.hpp"

namespace sfumato::cli {
namespace {

constexpr std::size_t kMostWaiting = 64;  ///< further requests get an immediate answer

/// Allows nothing from elsewhere, no code except the page's own file, and no frame of another site.
constexpr const char* kWatchPolicy =
    "default-src 'none'; img-src 'self' data:; script-src 'self'; style-src 'self'; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// Returns a number that no other run of the command has: a page may outlive the run that it came
/// from.
std::uint64_t number_of_run() {
  const auto time = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::milliseconds>(time).count());
}

/// Returns the number after "?after="; 0 if there is none.
std::uint64_t version_asked(evhttp_request* request) {
  std::string_view text = query_of(request);
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
  Status start(int port);
  int port() const { return server_.port(); }
  void publish(WatchState state);

 private:
  static void on_closed(evhttp_connection* connection, void* self) {
    static_cast<Loop*>(self)->forget(connection);
  }

  void answer(evhttp_request* request);
  void answer_state(evhttp_request* request);
  void forget(evhttp_connection* connection);
  void answer_all();
  std::string state_json();

  std::vector<evhttp_request*> waiting_;  ///< of the server's thread
  std::mutex mutex_;
  WatchState state_;
  const std::uint64_t run_ = number_of_run();
  std::uint64_t version_ = 0;  ///< of the state; counts from run_, 0: nothing was published
  LocalServer server_;         ///< ends before what it answers with
};

Status WatchServer::Loop::start(int port) {
  return server_.start({.port = port,
                        .methods = EVHTTP_REQ_GET | EVHTTP_REQ_HEAD,
                        .policy = kWatchPolicy,
                        .answer = [this](evhttp_request* request) { answer(request); },
                        .rang = [this] { answer_all(); }});
}

void WatchServer::Loop::publish(WatchState state) {
  {
    const std::scoped_lock lock(mutex_);
    state_ = std::move(state);
    version_ = std::max(version_, run_) + 1;
  }
  server_.ring();
}

/// Called when something was published, or the server ends.
void WatchServer::Loop::answer_all() {
  const std::string json = state_json();
  for (evhttp_request* request : std::exchange(waiting_, {})) {
    if (evhttp_connection* connection = evhttp_request_get_connection(request)) {
      evhttp_connection_set_closecb(connection, nullptr, nullptr);
    }
    reply(request, HTTP_OK, "application/json", json);
  }
}

void WatchServer::Loop::answer(evhttp_request* request) {
  const std::string_view path = path_of(request);
  if (path == "/" || path.empty()) {
    return reply(request, HTTP_OK, "text/html; charset=utf-8", embedded_file("watch.html"));
  }
  if (path == "/watch.css") return reply(request, HTTP_OK, "text/css", embedded_file("watch.css"));
  if (path == "/watch.js")
    return reply(request, HTTP_OK, "text/javascript", embedded_file("watch.js"));
  if (path == "/state") return answer_state(request);
  const std::scoped_lock lock(mutex_);
  if (path == "/picture.png" && !state_.picture.empty()) {
    const auto* bytes = reinterpret_cast<const char*>(state_.picture.data());
    return reply(request, HTTP_OK, "image/png", {bytes, state_.picture.size()});
  }
  reply_nothing(request);
}

/// Answers at once if the state is newer than the page's, else as soon as it is.
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
  json.array("messages", state_.messages).end_object();
  return json.text();
}

Result<std::unique_ptr<WatchServer>> WatchServer::start(int port) {
  auto loop = std::make_unique<Loop>();
  SFUMATO_TRY(loop->start(port));
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
