#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <future>
#include <nlohmann/json.hpp>
#include <thread>

#include "program.hpp"
#include "scratch_folder.hpp"

namespace {

using namespace adit::testing;
using nlohmann::json;

sockaddr_in loopback(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

/// A port that was free a moment ago.
int free_port() {
  const int s = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address = loopback(0);
  socklen_t size = sizeof address;
  EXPECT_EQ(::bind(s, reinterpret_cast<sockaddr*>(&address), size), 0);
  EXPECT_EQ(::getsockname(s, reinterpret_cast<sockaddr*>(&address), &size), 0);
  ::close(s);
  return ntohs(address.sin_port);
}

struct Reply {
  int status = 0;
  std::string head, body;
};

/// One request, as a browser or somebody else might send it.
Reply ask(int port, const std::string& request_line, const std::string& headers, const std::string& body = "") {
  const int s = ::socket(AF_INET, SOCK_STREAM, 0);
  const sockaddr_in address = loopback(port);
  Reply reply;
  if (::connect(s, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) {
    const std::string text = request_line + " HTTP/1.1\r\n" + headers +
                             "Connection: close\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
    EXPECT_EQ(::send(s, text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
    std::string all;
    char part[4096];
    for (ssize_t got = 0; (got = ::recv(s, part, sizeof part, 0)) > 0;) all.append(part, static_cast<std::size_t>(got));
    const std::size_t end = all.find("\r\n\r\n");
    if (all.size() > 12 && end != std::string::npos) {
      reply = {std::stoi(all.substr(9, 3)), all.substr(0, end), all.substr(end + 4)};
    }
  }
  ::close(s);
  return reply;
}

/// `adit mark` at work; it is told to end by a signal, as by Ctrl-C.
class Marking {
 public:
  Marking(const ScratchFolder& folder, std::vector<std::string> arguments) : stop_(folder / "stop") {
    arguments.insert(arguments.begin(), "mark");
    arguments.insert(arguments.end(), {"--port", std::to_string(port)});
    std::filesystem::remove(stop_);
    outcome_ = std::async(std::launch::async,
                          [this, arguments] { return run_adit(arguments, {.signal = SIGINT, .signal_when = stop_}); });
    for (int i = 0; i < 3000 && get("/").status == 0; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  ~Marking() {
    if (outcome_.valid()) end();
  }
  [[nodiscard]] std::string host() const { return "Host: 127.0.0.1:" + std::to_string(port) + "\r\n"; }
  [[nodiscard]] Reply get(const std::string& path) const { return ask(port, "GET " + path, host()); }
  [[nodiscard]] Reply post(const std::string& path, const std::string& body) const {
    return ask(port, "POST " + path, host(), body);
  }
  Outcome end() {
    write_text(stop_, "");
    return outcome_.get();
  }

  int port = free_port();

 private:
  std::filesystem::path stop_;
  std::future<Outcome> outcome_;
};

bool is_built() { return run_adit({"mark", "--help"}).exit_code == 0; }

TEST(Mark, MarksGoToTheFileAndEvalTakesIt) {
  if (!is_built()) GTEST_SKIP() << "built without cpp-httplib";
  const ScratchFolder folder;
  const std::string set = make_passages(folder / "drift", 3);
  const auto file = folder / "drift/openings.json";
  Marking marking(folder, {set});
  EXPECT_EQ(marking.get("/").status, 200);
  EXPECT_EQ(json::parse(marking.get("/state").body)["frames"].size(), 3u);
  EXPECT_TRUE(marking.get("/image/1").body.starts_with("\x89PNG"));
  EXPECT_EQ(marking.post("/marks/0", R"({"openings": [[60, 70, 140, 150]], "place": "north"})").status, 200);
  EXPECT_EQ(json::parse(read_text(file))["openings"].size(), 1u) << "on the disk after each change";
  EXPECT_EQ(marking.post("/marks/1", R"({"openings": [[[68, 70], [148, 70], [148, 150]], [1, 2, 3, 4]]})").status, 200);
  EXPECT_EQ(marking.post("/marks/2", R"({"openings": "none"})").status, 200);
  EXPECT_EQ(marking.post("/marks/2", R"({"openings": null})").status, 200);
  EXPECT_EQ(marking.post("/marks/2", R"({"openings": "none", "place": ""})").status, 200);
  const Outcome outcome = marking.end();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "http://127.0.0.1:" + std::to_string(marking.port) + "/\n");
  EXPECT_NE(outcome.err.find("3 of 3 images are marked: " + file.string()), std::string::npos) << outcome.err;
  const json marks = json::parse(read_text(file));
  EXPECT_EQ(marks["size"], json({320, 240}));
  EXPECT_EQ(marks["openings"]["frame0.png"], json::parse("[[60, 70, 140, 150]]"));
  EXPECT_EQ(marks["openings"]["frame1.png"][0].size(), 3u);
  EXPECT_EQ(marks["openings"]["frame2.png"], "none");
  EXPECT_EQ(marks["places"], json({{"frame0.png", "north"}}));
  const Outcome eval = run_adit({"eval", set, "--quiet"});
  EXPECT_NE(eval.out.find("drift: 3 frames of 2 places, 2 with an opening, 1 without"), std::string::npos)
      << eval.out << eval.err;
}

TEST(Mark, KeepsWhatIsInTheFileAlready) {
  if (!is_built()) GTEST_SKIP() << "built without cpp-httplib";
  const ScratchFolder folder;
  const std::string image = make_passage(folder / "a.png");
  const std::string before = R"({"by": "me", "size": [640, 480], "openings": {"b.png": [[1, 2, 3, 4]]}})";
  const auto file = write_text(folder / "marks.json", before);
  Marking marking(folder, {image, "--out", file.string()});
  for (const char* refused : {"", "[]", "{}", R"({"openings": 3})", R"({"openings": [[1, 2, 3]]})",
                              R"({"openings": [[1, 2, 3, 1e9]]})", R"({"openings": [[[1, 2], [3, 4]]]})",
                              R"({"openings": [], "place": ""})", R"({"openings": "none", "place": 3})"})
    EXPECT_EQ(marking.post("/marks/0", refused).status, 400) << refused;
  EXPECT_EQ(marking.post("/marks/1", R"({"openings": "none"})").status, 404);
  EXPECT_EQ(read_text(file), before);
  EXPECT_EQ(marking.post("/marks/0", R"({"openings": "none"})").status, 200);
  marking.end();
  const json marks = json::parse(read_text(file));
  EXPECT_EQ(marks["by"], "me");
  EXPECT_EQ(marks["openings"].size(), 2u);
  EXPECT_FALSE(marks.contains("size")) << "this image is of another size";
}

TEST(Mark, AnswersOnlyThisMachine) {
  if (!is_built()) GTEST_SKIP() << "built without cpp-httplib";
  const ScratchFolder folder;
  const std::string image = make_passage(folder / "a.png");
  Marking marking(folder, {image});
  const std::string port = std::to_string(marking.port);
  EXPECT_EQ(ask(marking.port, "GET /", "Host: localhost:" + port + "\r\n").status, 200);
  for (const std::string& headers :
       {std::string("Host: example.org\r\n"), "Host: example.org:" + port + "\r\n",
        "Host: 127.0.0.1.example.org:" + port + "\r\n", std::string(),
        "Host: 127.0.0.1:" + port + "\r\nHost: example.org\r\n", marking.host() + "Origin: http://example.org\r\n",
        marking.host() + "Origin: null\r\n"})
    for (const char* line : {"GET /", "GET /state", "GET /image/0", "POST /marks/0", "POST /end"})
      EXPECT_EQ(ask(marking.port, line, headers, "{\"openings\": \"none\"}").status, 403) << headers << line;
  EXPECT_FALSE(std::filesystem::exists(folder / "openings.json"));
  for (const char* path : {"/image/1", "/image/-1", "/image/99999999999999999999", "/../a.png", "/a.png"})
    EXPECT_EQ(marking.get(path).status, 404) << path;
  EXPECT_EQ(ask(marking.port, "POST /marks/0", marking.host() + "Origin: http://127.0.0.1:" + port + "\r\n",
                "{\"openings\": \"none\"}")
                .status,
            200);
  // Taken by us: no other address of this machine answers, and no second server gets the port.
  const Outcome second = run_adit({"mark", image, "--port", port});
  EXPECT_EQ(second.exit_code, 6);
  EXPECT_NE(second.err.find("this port is taken"), std::string::npos) << second.err;
}

TEST(Mark, PageEndsIt) {
  if (!is_built()) GTEST_SKIP() << "built without cpp-httplib";
  const ScratchFolder folder;
  Marking marking(folder, {make_passage(folder / "a.png")});
  EXPECT_EQ(marking.post("/end", "").status, 200);
  for (int i = 0; i < 3000 && marking.get("/").status != 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(marking.get("/").status, 0);
  EXPECT_EQ(marking.end().exit_code, 0);
}

TEST(Mark, FaultsAreOneLine) {
  if (!is_built()) GTEST_SKIP() << "built without cpp-httplib";
  const ScratchFolder folder;
  const std::string image = make_passage(folder / "a.png");
  const std::string broken = write_text(folder / "broken.json", "{\"openings\": [").string();
  const struct {
    std::vector<std::string> arguments;
    int exit_code;
    std::string says;
  } faults[] = {
      {{}, 2, "images"},
      {{image, "--port", "70000"}, 2, "--port"},
      {{(folder / "none.png").string()}, 4, "no such file"},
      {{make_clip(folder / "c.avi", 3)}, 4, "c.avi: a video"},
      {{image, "--out", broken}, 4, "broken.json"},
      {{image, "--out", (folder / "nosuch/m.json").string()}, 6, "nosuch"},
      {{truncate_copy(image, folder / "cut.png", 0.5).string()}, 4, "cut.png: "},
      {{image, "--out", image}, 2, "(IMAGES)"},
  };
  for (const auto& fault : faults) {
    std::vector<std::string> arguments{"mark"};
    arguments.insert(arguments.end(), fault.arguments.begin(), fault.arguments.end());
    const Outcome outcome = run_adit(arguments);
    EXPECT_EQ(outcome.exit_code, fault.exit_code) << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find(fault.says), std::string::npos) << outcome.err;
  }
}

}  // namespace
