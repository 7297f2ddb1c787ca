#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace sfumato::test {

/// A command that prints the address of its page on 127.0.0.1 as its first line, and runs until it
/// is ended.
class ServedCommand {
 public:
  /// Starts the program with its arguments, and waits for the address.
  explicit ServedCommand(std::vector<std::string> words);
  ~ServedCommand();
  ServedCommand(const ServedCommand&) = delete;
  ServedCommand& operator=(const ServedCommand&) = delete;

  /// Ends it by a signal. Returns its exit code, or 128 and the number.
  int stop(int signal_number);

  pid_t id() const { return id_; }
  int port() const { return port_; }
  const std::string& address() const { return address_; }
  /// "127.0.0.1:PORT"
  std::string host() const;

  /// Returns the answer to these bytes, until the connection closes.
  std::string ask(const std::string& request) const;
  /// The same where each piece of so many bytes comes by itself.
  std::string ask_in_pieces(const std::string& request, std::size_t piece) const;
  std::string get(const std::string& path, std::string host = {}) const;

 private:
  pid_t id_ = 0;
  int port_ = 0;
  std::string address_;
};

/// Returns the part of an answer after the headers.
std::string body_of(const std::string& answer);

}  // namespace sfumato::test
