#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "sfumato/base/status.hpp"

struct evhttp_request;

namespace sfumato::cli {

/// HTTP on 127.0.0.1 for a command's own page, in a thread that blocks all signals. Requests whose
/// Host is not this address are answered with 403, so that no other site's page can reach it under
/// its own name, and so are those that a page of another origin makes.
class LocalServer {
 public:
  struct Setup {
    int port = 0;                ///< 0: any free port
    unsigned methods = 0;        ///< of libevent's: EVHTTP_REQ_GET | …
    std::size_t body_bytes = 0;  ///< the longest body; a longer one is answered with 413
    std::string_view policy;     ///< Content-Security-Policy of all answers
    /// In the server's thread.
    std::function<void(evhttp_request*)> answer;
    std::function<void()> rang{};
  };

  LocalServer();
  /// Waits for the answer that is being made; afterwards none is.
  ~LocalServer();
  LocalServer(const LocalServer&) = delete;
  LocalServer& operator=(const LocalServer&) = delete;

  /// Errors: io.
  Status start(Setup setup);
  int port() const;
  /// Has the server's thread call `rang`. Any thread may.
  void ring() const;

 private:
  class Loop;
  std::unique_ptr<Loop> loop_;
};

/// Without the query.
std::string_view path_of(evhttp_request* request);
/// Behind "?"; empty: there is none.
std::string_view query_of(evhttp_request* request);
/// A header of the request; empty: it is not there.
std::string_view header_of(evhttp_request* request, const char* name);

void add_header(evhttp_request* request, const char* name, const std::string& value);
void reply(evhttp_request* request, int code, const char* type, std::string_view body);
/// 404 in words.
void reply_nothing(evhttp_request* request);

}  // namespace sfumato::cli
