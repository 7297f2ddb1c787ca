#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "cli/servers/body_gate.hpp"
#include "sfumato/base/status.hpp"

struct evhttp_request;

namespace sfumato::cli {

/// Serves HTTP on 127.0.0.1 for a command's own page, in a thread that blocks all signals. Requests
/// whose Host is not this address get the answer 403, so that no other site's page can reach the
/// server under its own name. Requests from a page of another origin get the same answer. A
/// connection has one request.
class LocalServer {
 public:
  struct Setup {
    int port = 0;                ///< 0: any free port
    unsigned methods = 0;        ///< methods as libevent's flags: EVHTTP_REQ_GET | …
    std::size_t body_bytes = 0;  ///< the longest body; a longer one is answered with 413
    std::string_view policy;     ///< Content-Security-Policy of all answers
    /// Called in the server's thread.
    std::function<void(evhttp_request*)> answer;
    /// Called in the server's thread. Returns whether to read the body after this head of a request
    /// to this address; otherwise the request is answered without it. Empty: no body is read.
    std::function<bool(const RequestHead&)> admits{};
    std::function<void()> rang{};
  };

  LocalServer();
  /// Waits for the current answer. Afterwards the server makes no other.
  ~LocalServer();
  LocalServer(const LocalServer&) = delete;
  LocalServer& operator=(const LocalServer&) = delete;

  /// Errors: io.
  Status start(Setup setup);
  int port() const;
  /// Makes the server's thread call `rang`. Any thread may call this.
  void ring() const;

 private:
  class Loop;
  std::unique_ptr<Loop> loop_;
};

/// Returns the path without the query.
std::string_view path_of(evhttp_request* request);
/// Returns the text after "?"; empty if there is none.
std::string_view query_of(evhttp_request* request);
/// Returns a header of the request; empty if it is missing.
std::string_view header_of(evhttp_request* request, const char* name);

void add_header(evhttp_request* request, const char* name, const std::string& value);
void reply(evhttp_request* request, int code, const char* type, std::string_view body);
/// Answers 404 with a text.
void reply_nothing(evhttp_request* request);

}  // namespace sfumato::cli
