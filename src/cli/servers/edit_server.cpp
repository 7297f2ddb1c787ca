#include "cli/servers/edit_server.hpp"

#include <event2/buffer.h>
#include <event2/http.h>
#include <sys/random.h>

#include <array>
#include <cstdlib>
#include <optional>
#include <span>
#include <utility>

#include "base/text/ascii.hpp"
#include "base/try.hpp"
#include "cli/files/folder_loader.hpp"
#include "cli/servers/edited_file.hpp"
#include "cli/servers/local_server.hpp"
#include "codecs/file_kind.hpp"
#include "options/values.hpp"

namespace sfumato::cli {
namespace {

constexpr int kSeeOther = 303, kPreconditionFailed = 412, kPreconditionRequired = 428;
constexpr int kNoContent = 204;

/// The page has its own policy; this header adds what a <meta> cannot express.
constexpr std::string_view kEditPolicy =
    "frame-ancestors 'none'; base-uri 'none'; form-action 'none'";

/// Returns 128 random bits as hexadecimal digits; empty if the system has none.
std::string random_word() {
  std::array<unsigned char, 16> bits{};
  if (getrandom(bits.data(), bits.size(), 0) != static_cast<ssize_t>(bits.size())) return {};
  std::string word;
  for (const unsigned char byte : bits) {
    for (const int digit : {byte >> 4, byte & 15}) word += kHexDigits[digit];
  }
  return word;
}

/// Returns whether two words are equal. The time does not depend on where they differ.
bool is_same_word(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned char difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
  return difference == 0;
}

/// Returns the media type of a texture; null if the bytes are not a texture.
const char* media_type(std::span<const std::uint8_t> bytes) {
  const codecs::FileKind kind = codecs::file_kind(codecs::text_view(bytes));
  if (kind == codecs::FileKind::png) return "image/png";
  return kind == codecs::FileKind::jpeg ? "image/jpeg" : nullptr;
}

std::string tag_of(std::uint64_t version) {
  return '"' + std::to_string(version) + '"';
}

/// Returns the version in a tag; 0, which no file has, if the tag is not one of ours.
std::uint64_t version_of(std::string_view tag) {
  if (tag.size() < 3 || tag.front() != '"' || tag.back() != '"') return 0;
  return options::parse_whole(tag.substr(1, tag.size() - 2), 0, UINT64_MAX).value_or(0);
}

/// What If-Match asks for; empty: that the file be replaced whatever it holds.
std::optional<std::uint64_t> expected_version(std::string_view match) {
  return match == "*" ? std::nullopt : std::optional(version_of(match));
}

std::string decoded(std::string_view query) {
  std::size_t size = 0;
  const std::unique_ptr<char, decltype(&std::free)> text(
      evhttp_uridecode(std::string(query).c_str(), 0, &size), &std::free);
  return text ? std::string(text.get(), size) : std::string();
}

/// Returns the page with the drawing's name in it, so that the page knows its file. The name is
/// percent-coded, because the page has one byte per character.
std::string with_name(std::string page, const std::string& name) {
  constexpr std::string_view kHead = "<head>";
  const std::size_t head = page.find(kHead);
  if (head == std::string::npos) return page;
  const std::unique_ptr<char, decltype(&std::free)> coded(evhttp_encode_uri(name.c_str()),
                                                          &std::free);
  return page.insert(head + kHead.size(), "<meta name=\"sfumato-file\" content=\"" +
                                              std::string(coded ? coded.get() : "") + "\">");
}

}  // namespace

class EditServer::Answers {
 public:
  Answers(const EditArguments& arguments, Context& context, std::string page)
      : context_(context),
        file_(context, arguments.input),
        loader_(arguments, context),
        page_(with_name(std::move(page), file_.name())) {}

  Status start(int port);
  std::string address_of(const std::string& word) const;
  const std::string& secret() const { return secret_; }
  const std::string& pass() const { return pass_; }

 private:
  bool admits(const RequestHead& head) const;
  void answer(evhttp_request* request);
  void answer_below(evhttp_request* request, std::string_view name);
  bool is_pass(std::string_view word);
  void give_drawing(evhttp_request* request);
  void take_drawing(evhttp_request* request);
  void give_texture(evhttp_request* request);

  Context& context_;
  EditedFile file_;
  FolderLoader loader_;
  const std::string page_;
  const std::string secret_ = random_word(), pass_ = random_word();
  bool is_pass_used_ = false;
  LocalServer server_;  ///< ends before what it answers with
};

Status EditServer::Answers::start(int port) {
  if (secret_.empty() || pass_.empty()) {
    return make_error(StatusCode::io, "the system has no random numbers for a secret address");
  }
  return server_.start({.port = port,
                        .methods = EVHTTP_REQ_GET | EVHTTP_REQ_PUT,
                        .body_bytes = context_.limits.input_bytes,
                        .policy = kEditPolicy,
                        .answer = [this](evhttp_request* request) { answer(request); },
                        .admits = [this](const RequestHead& head) { return admits(head); }});
}

std::string EditServer::Answers::address_of(const std::string& word) const {
  return "http://127.0.0.1:" + std::to_string(server_.port()) + '/' + word + '/';
}

bool EditServer::Answers::is_pass(std::string_view word) {
  if (is_pass_used_ || !is_same_word(word, pass_)) return false;
  return is_pass_used_ = true;
}

/// Returns whether to read the body: false if take_drawing() would refuse the request by its head.
bool EditServer::Answers::admits(const RequestHead& head) const {
  constexpr std::string_view kName = "/drawing";
  if (head.method != "PUT" || !head.target.starts_with('/')) return false;
  const std::string_view path = head.target.substr(1, head.target.find('?') - 1);
  return path.ends_with(kName) &&
         is_same_word(path.substr(0, path.size() - kName.size()), secret_) &&
         !head.if_match.empty() && file_.may_save(expected_version(head.if_match));
}

void EditServer::Answers::answer(evhttp_request* request) {
  std::string_view path = path_of(request);
  if (path.starts_with('/')) path.remove_prefix(1);
  const std::size_t slash = path.find('/');
  const std::string_view word = path.substr(0, slash);
  if (slash == std::string_view::npos) return reply_nothing(request);
  const std::string_view name = path.substr(slash + 1);
  if (is_same_word(word, secret_)) return answer_below(request, name);
  if (name.empty() && evhttp_request_get_command(request) == EVHTTP_REQ_GET && is_pass(word)) {
    add_header(request, "Location", '/' + secret_ + '/');
    return reply(request, kSeeOther, "text/plain", "");
  }
  reply_nothing(request);
}

void EditServer::Answers::answer_below(evhttp_request* request, std::string_view name) {
  const bool gets = evhttp_request_get_command(request) == EVHTTP_REQ_GET;
  if (name == "drawing") return gets ? give_drawing(request) : take_drawing(request);
  if (!gets) return reply_nothing(request);
  if (name.empty()) return reply(request, HTTP_OK, "text/html; charset=windows-1252", page_);
  if (name == "file") return give_texture(request);
  reply_nothing(request);
}

/// The media type is plain bytes: a browser that shows an SVG directly would run its scripts, which
/// could read our secret.
void EditServer::Answers::give_drawing(evhttp_request* request) {
  const Result<EditedFile::Content> content = file_.read();
  if (!content) return reply(request, HTTP_INTERNAL, "text/plain", content.status().message);
  add_header(request, "ETag", tag_of(content->version));
  reply(request, HTTP_OK, "application/octet-stream", content->bytes);
}

void EditServer::Answers::take_drawing(evhttp_request* request) {
  const std::string_view match = header_of(request, "If-Match");
  if (match.empty()) {
    return reply(request, kPreconditionRequired, "text/plain",
                 "the request needs the header If-Match");
  }
  const auto changed = [&] {
    reply(request, kPreconditionFailed, "text/plain", "the file has changed on the disk");
  };
  const std::optional<std::uint64_t> expected = expected_version(match);
  if (!file_.may_save(expected)) return changed();
  evbuffer* body = evhttp_request_get_input_buffer(request);
  const std::size_t size = evbuffer_get_length(body);
  if (size == 0)
    return reply(request, HTTP_BADREQUEST, "text/plain", "the request needs a drawing as its body");
  const std::uint8_t* bytes = evbuffer_pullup(body, -1);
  if (!bytes) return reply(request, HTTP_INTERNAL, "text/plain", "out of memory");
  const auto saved = file_.save(expected, {bytes, size});
  if (!saved) return reply(request, HTTP_INTERNAL, "text/plain", saved.status().message);
  if (!*saved) return changed();
  add_header(request, "ETag", tag_of(**saved));
  reply(request, kNoContent, "text/plain", "");
}

/// Only pictures are served: other files beside the drawing stay private.
void EditServer::Answers::give_texture(evhttp_request* request) {
  const auto bytes = loader_.load(decoded(query_of(request)));
  const char* type = bytes ? media_type(*bytes) : nullptr;
  if (!type) return reply_nothing(request);
  reply(request, HTTP_OK, type, {reinterpret_cast<const char*>(bytes->data()), bytes->size()});
}

Result<std::unique_ptr<EditServer>> EditServer::start(const EditArguments& arguments,
                                                      Context& context, std::string page) {
  auto answers = std::make_unique<Answers>(arguments, context, std::move(page));
  SFUMATO_TRY(answers->start(arguments.port));
  return std::unique_ptr<EditServer>(new EditServer(std::move(answers)));
}

EditServer::EditServer(std::unique_ptr<Answers> answers) : answers_(std::move(answers)) {}
EditServer::~EditServer() = default;

std::string EditServer::address() const {
  return answers_->address_of(answers_->secret());
}

std::string EditServer::address_for_once() const {
  return answers_->address_of(answers_->pass());
}

}  // namespace sfumato::cli
