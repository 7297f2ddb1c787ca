#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace sfumato::test {

/// A command that prints the address of its page on 127.0.0.1 as its first line, and runs until it
/// is ended.
class ServedCommand {
 public:
  /// The program and its arguments. Waits for the address.
  explicit ServedCommand(std::vector<std::string> words);
  ~ServedCommand();
  ServedCommand(const ServedCommand&) = delete;
  ServedCommand& operator=(const ServedCommand&) = delete;

  /// Ends it by a signal; its exit code, or 128 and the number.
  int stop(int signal_number);

  pid_t id() const { return id_; }
  int port() const { return port_; }
  const std::string& address() const { return address_; }
  /// "127.0.0.1:PORT"
  std::string host() const;

  /// What it answers to these bytes, until it closes the connection.
  std::string ask(const std::string& request) const;
  std::string get(const std::string& path, std::string host = {}) const;

 private:
  pid_t id_ = 0;
  int port_ = 0;
  std::string address_;
};

/// What follows the headers of an answer.
std::string body_of(const std::string& answer);

}  // namespace sfumato::test
