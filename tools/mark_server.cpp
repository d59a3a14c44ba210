#include "mark_server.hpp"

#include <httplib.h>

#include <atomic>
#include <charconv>
#include <mutex>
#include <opencv2/imgcodecs.hpp>
#include <thread>

#include "adit/io/draw.hpp"
#include "adit/io/errors.hpp"
#include "adit/io/image_file.hpp"
#include "pages.hpp"

namespace adit::tools {
namespace {

using Json = nlohmann::ordered_json;
using httplib::Request;
using httplib::Response;

constexpr const char* kHost = "127.0.0.1";
constexpr std::size_t kBodyLongest = 1 << 20;  ///< B; marks of a frame are some hundred
constexpr int kPngLevel = 1;                   ///< it goes over the loopback: time counts, not size

void answer(Response& response, int status, const std::string& text) {
  response.status = status;
  response.set_content(text + "\n", "text/plain; charset=utf-8");
}

}  // namespace

struct MarkServer::Pages {
  explicit Pages(MarkFile& marks) : file(&marks) {}

  /// Pages of other sites may not reach this one, neither under a name of theirs that points here (Host) nor by a form
  /// or script of theirs (Origin).
  [[nodiscard]] bool is_ours(const Request& request) const {
    const std::string port_text = std::to_string(port);
    const auto ours = [&port_text](std::string_view host) {
      return host == std::string(kHost) + ":" + port_text || host == "localhost:" + port_text;
    };
    if (request.get_header_value_count("Host") != 1 || !ours(request.get_header_value("Host"))) return false;
    if (!request.has_header("Origin")) return true;
    const std::string origin = request.get_header_value("Origin");
    return origin.starts_with("http://") && ours(std::string_view(origin).substr(7));
  }

  [[nodiscard]] std::optional<std::size_t> number_in(const Request& request) const {
    const std::string text = request.matches[1];
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number >= file->size()) return std::nullopt;
    return number;
  }

  void send_image(const Request& request, Response& response) const {
    const auto number = number_in(request);
    if (!number) return answer(response, 404, "no such image");
    try {
      // Decoded here, since browsers turn pictures as EXIF says, and adit does not.
      std::vector<unsigned char> png;
      cv::imencode(".png", io::bgr_of(io::read_image(file->image(*number))), png,
                   {cv::IMWRITE_PNG_COMPRESSION, kPngLevel});
      response.set_content(std::string(png.begin(), png.end()), "image/png");
    } catch (const io::InputError& e) {
      answer(response, 422, e.what());
    }
  }

  void take_marks(const Request& request, Response& response) {
    const auto number = number_in(request);
    if (!number) return answer(response, 404, "no such image");
    const Json marks = Json::parse(request.body, nullptr, false);
    try {
      const cv::Mat pixels = io::read_image(file->image(*number));
      const std::scoped_lock lock(mutex);
      const std::string fault = file->take(*number, marks, pixels.cols, pixels.rows);
      fault.empty() ? answer(response, 200, "saved") : answer(response, 400, fault);
    } catch (const io::InputError& e) {
      answer(response, 422, e.what());
    } catch (const io::OutputError& e) {
      answer(response, 500, e.what());
    }
  }

  void send_state(const Request&, Response& response) {
    const std::scoped_lock lock(mutex);
    const Json state{{"file", file->path().string()}, {"frames", file->state()}};
    response.set_content(state.dump(-1, ' ', false, Json::error_handler_t::replace), "application/json");
  }

  void route() {
    server.set_payload_max_length(kBodyLongest);
    server.set_keep_alive_timeout(1);  // s; the end waits for it
    server.set_pre_routing_handler([this](const Request& request, Response& response) {
      response.set_header("Cache-Control", "no-store");
      response.set_header("X-Content-Type-Options", "nosniff");
      response.set_header("Content-Security-Policy",
                          "default-src 'none'; img-src 'self' data:; connect-src 'self'; style-src 'unsafe-inline'; "
                          "script-src 'unsafe-inline'; frame-ancestors 'none'");
      if (is_ours(request)) return httplib::Server::HandlerResponse::Unhandled;
      answer(response, 403, "this page is for the machine it runs on");
      return httplib::Server::HandlerResponse::Handled;
    });
    server.Get("/", [](const Request&, Response& response) {
      response.set_content(std::string(mark_page()), "text/html; charset=utf-8");
    });
    server.Get("/state", [this](const Request& q, Response& r) { send_state(q, r); });
    server.Get(R"(/image/(\d{1,9}))", [this](const Request& q, Response& r) { send_image(q, r); });
    server.Post(R"(/marks/(\d{1,9}))", [this](const Request& q, Response& r) { take_marks(q, r); });
    server.Post("/end", [this](const Request&, Response& response) {
      answer(response, 200, "ended");
      done = true;
    });
  }

  MarkFile* file;
  std::mutex mutex;  ///< of the file: the server answers several requests at once
  httplib::Server server;
  int port = 0;
  std::atomic<bool> done = false;
  std::thread thread;
};

MarkServer::MarkServer(MarkFile& file, int port) : pages_(std::make_unique<Pages>(file)) {
  pages_->route();
  // Without the library's SO_REUSEPORT, which would let two servers share a port in silence.
  pages_->server.set_socket_options([](socket_t) {});
  pages_->port = port > 0 ? port : pages_->server.bind_to_any_port(kHost);
  const bool bound = port > 0 ? pages_->server.bind_to_port(kHost, port) : pages_->port > 0;
  if (!bound) throw io::OutputError("--port " + std::to_string(port) + ": this port is taken; choose another, or none");
  pages_->thread = std::thread([this] { pages_->server.listen_after_bind(); });
  while (!pages_->server.is_running()) std::this_thread::yield();
}

MarkServer::~MarkServer() {
  pages_->server.stop();
  pages_->thread.join();
}

std::string MarkServer::address() const {
  return std::string("http://").append(kHost).append(":").append(std::to_string(pages_->port)).append("/");
}

bool MarkServer::is_done() const noexcept { return pages_->done; }

}  // namespace adit::tools
