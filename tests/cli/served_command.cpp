#include "cli/served_command.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <thread>

namespace sfumato::test {
namespace {

/// Only a failing test waits this long; a busy machine needs less.
constexpr int kMostSeconds = 500;

/// Sends as much as the other side reads; it may stop early.
void send_all(int fd, const std::string& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t count = send(fd, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (count <= 0) return;
    sent += static_cast<std::size_t>(count);
  }
}

}  // namespace

ServedCommand::ServedCommand(std::vector<std::string> words) {
  int ends[2];
  EXPECT_EQ(pipe(ends), 0);
  id_ = fork();
  if (id_ == 0) {
    dup2(ends[1], STDOUT_FILENO);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  close(ends[1]);
  char c = 0;
  while (read(ends[0], &c, 1) == 1 && c != '\n') address_ += c;
  close(ends[0]);
  port_ = std::atoi(address_.substr(address_.rfind(':') + 1).c_str());
}

ServedCommand::~ServedCommand() {
  if (id_ > 0) stop(SIGKILL);
}

int ServedCommand::stop(int signal_number) {
  kill(id_, signal_number);
  int status = 0;
  waitpid(id_, &status, 0);
  id_ = 0;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string ServedCommand::host() const {
  return "127.0.0.1:" + std::to_string(port_);
}

std::string ServedCommand::ask(const std::string& request) const {
  return ask_in_pieces(request, request.size());
}

std::string ServedCommand::ask_in_pieces(const std::string& request, std::size_t piece) const {
  const int fd = socket(AF_INET, SOCK_STREAM, 0);
  timeval most{kMostSeconds, 0};
  setsockopt(fd, SOL_SOCKET, SO_RCVTIMEO, &most, sizeof(most));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port_));
  inet_pton(AF_INET, "127.0.0.1", &address.sin_addr);
  std::string answer;
  if (connect(fd, reinterpret_cast<sockaddr*>(&address), sizeof(address)) == 0) {
    for (std::size_t i = 0; i < request.size(); i += piece) {
      if (i > 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
      send_all(fd, request.substr(i, piece));
    }
    char bytes[4096];
    for (ssize_t count = 0; (count = recv(fd, bytes, sizeof(bytes), 0)) > 0;) {
      answer.append(bytes, static_cast<std::size_t>(count));
    }
  }
  close(fd);
  return answer;
}

std::string ServedCommand::get(const std::string& path, std::string host) const {
  if (host.empty()) host = this->host();
  return ask("GET " + path + " HTTP/1.1\r\nHost: " + host + "\r\nConnection: close\r\n\r\n");
}

std::string body_of(const std::string& answer) {
  const std::size_t body = answer.find("\r\n\r\n");
  return body == std::string::npos ? std::string() : answer.substr(body + 4);
}

}  // namespace sfumato::test
