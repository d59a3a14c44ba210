// The page of `adit view` and `adit fly --view`, over HTTP.
#pragma once

#include <memory>
#include <string>

#include "live_view.hpp"

namespace adit::tools {

struct ViewAddress {
  std::string host = "127.0.0.1";  ///< to listen on
  int port = 0;                    ///< 0: any that is free
};

class ViewServer {
 public:
  /// Listens. On an address that is not this machine's own (127.0.0.0/8, ::1, localhost), every request needs a token.
  /// @param live  must outlive the server. @throws io::OutputError when it cannot listen there.
  ViewServer(LiveView& live, const ViewAddress& address);
  /// Ends the view and the server; viewers who do not read are left after kWrite_s at the most.
  ~ViewServer();
  ViewServer(const ViewServer&) = delete;
  ViewServer& operator=(const ViewServer&) = delete;

  /// What to open in a browser: with the token, if one is needed.
  [[nodiscard]] std::string address() const;

 private:
  struct Pages;
  std::unique_ptr<Pages> pages_;
};

}  // namespace adit::tools
