#include "view_server.hpp"

#include <httplib.h>
#include <sys/socket.h>

#include <atomic>
#include <charconv>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <thread>

#include "adit/io/errors.hpp"
#include "pages.hpp"
#include "view_pictures.hpp"

namespace adit::tools {
namespace {

using Json = nlohmann::ordered_json;
using httplib::Request;
using httplib::Response;

constexpr std::size_t kBodyLongest = 1 << 16;  ///< B; a setting is some tens
constexpr int kStreamsMax = 24;                ///< viewers at once; each has a thread while it looks
constexpr int kThreads = kStreamsMax + 16;     ///< the rest of the requests are short
constexpr int kWrite_s = 2;                    ///< who takes nothing for so long is left
constexpr double kWait_s = 0.5;                ///< how soon the end, or a viewer who went, is noticed
constexpr const char* kCookie = "adit_view";

void answer(Response& response, int status, const std::string& text) {
  response.status = status;
  response.set_content(text + "\n", "text/plain; charset=utf-8");
}

bool is_own(const std::string& host) { return host == "localhost" || host == "::1" || host.starts_with("127."); }

std::string new_token() {
  std::random_device chance;
  std::string token;
  for (int i = 0; i < 4; ++i) {
    char digits[9];
    std::snprintf(digits, sizeof digits, "%08x", chance());
    token += digits;
  }
  return token;
}

/// Takes the same time wherever they differ.
bool is_same(const std::string& a, const std::string& b) {
  unsigned difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) difference |= static_cast<unsigned>(a[i] ^ b[i]);
  return difference == 0;
}

std::int64_t number_in(const Request& request, const char* name) {
  const std::string text = request.get_param_value(name);
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? number : 0;
}

}  // namespace

struct ViewServer::Pages {
  Pages(LiveView& view, const ViewAddress& where) : live(&view), address(where), pictures(view) {
    if (!is_own(address.host)) token = new_token();
  }

  /// "127.0.0.1:8080", as browsers name it in Host and Origin.
  [[nodiscard]] bool is_our_name(std::string_view name) const {
    const std::string ending = std::string(":").append(std::to_string(port));
    if (!name.ends_with(ending)) return false;
    name.remove_suffix(ending.size());
    // Behind a token any name will do: a page of somebody else's has no cookie for it.
    return !token.empty() || name == address.host || name == "localhost" || name == "127.0.0.1" || name == "[::1]";
  }
  [[nodiscard]] bool is_ours(const Request& request) const {
    if (request.get_header_value_count("Host") != 1 || !is_our_name(request.get_header_value("Host"))) return false;
    if (!request.has_header("Origin")) return true;
    return request.get_header_value("Origin") == std::string("http://").append(request.get_header_value("Host"));
  }
  [[nodiscard]] bool has_token(const Request& request) const {
    if (token.empty() || is_same(request.get_param_value("token"), token)) return true;
    const std::string cookies = request.get_header_value("Cookie");
    const std::string name = std::string(kCookie).append("=");
    const std::size_t at = cookies.find(name);
    return at != std::string::npos && is_same(cookies.substr(at + name.size(), token.size()), token);
  }

  void note_stream(std::int64_t number, bool begins) {
    const std::scoped_lock lock(streaming_mutex);
    if (begins)
      streaming.insert(number);
    else if (const auto at = streaming.find(number); at != streaming.end())
      streaming.erase(at);
  }
  [[nodiscard]] bool is_streaming(std::int64_t number) {
    const std::scoped_lock lock(streaming_mutex);
    return streaming.contains(number);
  }

  void stream(const Request& request, Response& response) {
    if (++streams > kStreamsMax) {
      --streams;
      return answer(response, 503, std::string("as many look on as can: ").append(std::to_string(kStreamsMax)));
    }
    const PictureKind kind =
        request.get_param_value("picture") == "depth" ? PictureKind::kDepth : PictureKind::kOverlay;
    pictures.watch(kind, 1);
    const std::int64_t number = number_in(request, "stream");
    note_stream(number, true);
    auto last = std::make_shared<std::int64_t>(0);
    auto first = std::make_shared<bool>(true);
    response.set_content_provider(
        "multipart/x-mixed-replace; boundary=frame",
        [this, kind, last, first](std::size_t, httplib::DataSink& sink) {
          if (live->has_ended() || !sink.is_writable()) return false;
          // Always the newest: who is slow misses frames, and nobody waits for him.
          const auto jpeg = pictures.after(kind, *last, kWait_s);
          if (!jpeg) return true;
          // The next part's head goes with it, so it cannot tell its length: browsers show a part when they see that
          // the next one begins, and of a source that stands still there is no next one.
          const std::string head = "--frame\r\nContent-Type: image/jpeg\r\n\r\n", tail = "\r\n" + head;
          const bool begun = *first ? sink.write(head.data(), head.size()) : true;
          *first = false;
          return begun && sink.write(jpeg->data(), jpeg->size()) && sink.write(tail.data(), tail.size());
        },
        [this, kind, number](bool) {
          note_stream(number, false);
          pictures.watch(kind, -1);
          --streams;
        });
  }

  void take_settings(const Request& request, Response& response) {
    const Json json = Json::parse(request.body, nullptr, false);
    if (!json.is_object() || json.size() != 1 || !json.begin().value().is_string())
      return answer(response, 400, "one setting is wanted: {\"section.name\": \"value\"}");
    const std::string fault = live->change(json.begin().key() + "=" + json.begin().value().get<std::string>());
    fault.empty() ? answer(response, 200, "taken") : answer(response, 400, fault);
  }

  void route() {
    server.set_payload_max_length(kBodyLongest);
    server.set_keep_alive_timeout(1);  // s; the end waits for it
    server.set_write_timeout(kWrite_s);
    server.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    server.set_pre_routing_handler([this](const Request& request, Response& response) {
      response.set_header("Cache-Control", "no-store");
      response.set_header("X-Content-Type-Options", "nosniff");
      response.set_header("Referrer-Policy", "no-referrer");
      response.set_header("Content-Security-Policy",
                          "default-src 'none'; img-src 'self' data: blob:; connect-src 'self'; style-src "
                          "'unsafe-inline'; script-src 'unsafe-inline'; frame-ancestors 'none'");
      if (!is_ours(request)) {
        answer(response, 403, "this page is known by the address that adit printed, and by no other name");
      } else if (!has_token(request)) {
        answer(response, 401, "this page needs its token: open the whole address that adit printed");
      } else {
        return httplib::Server::HandlerResponse::Unhandled;
      }
      return httplib::Server::HandlerResponse::Handled;
    });
    server.Get("/", [this](const Request&, Response& response) {
      if (!token.empty())
        response.set_header("Set-Cookie",
                            std::string(kCookie).append("=").append(token) + "; HttpOnly; SameSite=Strict; Path=/");
      response.set_content(filled_page(view_page(), {{"@UPLOT_CSS@", std::string(uplot_css())},
                                                     {"@UPLOT_JS@", std::string(uplot_js())},
                                                     {"@CSS@", std::string(look_css())},
                                                     {"@JS@", joined({view_js(), view_gauges_js(), view_plan_js(),
                                                                      view_settings_js(), view_look_js()})}}),
                           "text/html; charset=utf-8");
    });
    server.Get("/stream.mjpg", [this](const Request& q, Response& r) { stream(q, r); });
    server.Get("/state", [this](const Request& request, Response& response) {
      // A page cannot see that its picture's stream was given up: it is told here.
      response.set_header("Adit-Streaming", is_streaming(number_in(request, "stream")) ? "1" : "0");
      response.set_content(live->state_json(number_in(request, "after")), "application/json");
    });
    server.Get("/plan.png", [this](const Request&, Response& response) {
      live->plan().png.empty() ? answer(response, 404, "no plan of this world")
                               : response.set_content(live->plan().png, "image/png");
    });
    server.Get("/settings", [this](const Request&, Response& response) {
      response.set_content(live->settings_json(), "application/json");
    });
    server.Get("/settings.yaml", [this](const Request&, Response& response) {
      response.set_header("Content-Disposition", "attachment; filename=\"adit.yaml\"");
      response.set_content(live->settings_yaml(), "application/yaml");
    });
    server.Post("/settings", [this](const Request& q, Response& r) { take_settings(q, r); });
  }

  LiveView* live;
  ViewAddress address;
  std::string token;  ///< "" where none is needed
  ViewPictures pictures;
  std::atomic<int> streams = 0;
  std::mutex streaming_mutex;
  std::multiset<std::int64_t> streaming;  ///< numbers that the pages gave their streams
  httplib::Server server;
  int port = 0;
  std::thread thread;
};

ViewServer::ViewServer(LiveView& live, const ViewAddress& address) : pages_(std::make_unique<Pages>(live, address)) {
  pages_->route();
  // Not the library's SO_REUSEPORT, which would let two servers share a port in silence; but who ends adit and starts
  // it again need not wait for the kernel to forget the old connections.
  pages_->server.set_socket_options([](socket_t socket) {
    const int yes = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  pages_->port = address.port > 0 ? address.port : pages_->server.bind_to_any_port(address.host.c_str());
  const bool bound =
      address.port > 0 ? pages_->server.bind_to_port(address.host.c_str(), address.port) : pages_->port > 0;
  if (!bound) {
    live.end();  // the pictures' thread waits for it
    std::string place = address.host;
    if (address.port > 0) place.append(":").append(std::to_string(address.port));
    throw io::OutputError("--listen " + place +
                          ": cannot listen there; is it an address of this machine, and the port free?");
  }
  pages_->thread = std::thread([this] { pages_->server.listen_after_bind(); });
  while (!pages_->server.is_running()) std::this_thread::yield();
}

ViewServer::~ViewServer() {
  pages_->live->end();
  pages_->server.stop();
  pages_->thread.join();
}

std::string ViewServer::address() const {
  const bool is_ipv6 = pages_->address.host.find(':') != std::string::npos;
  std::string text = "http://";
  if (is_ipv6) text.append("[");
  text.append(pages_->address.host).append(is_ipv6 ? "]" : "");
  text.append(":").append(std::to_string(pages_->port)).append("/");
  if (!pages_->token.empty()) text.append("?token=").append(pages_->token);
  return text;
}

}  // namespace adit::tools
