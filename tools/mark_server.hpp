// The page of `adit mark`, for this machine alone.
#pragma once

#include <memory>
#include <string>

#include "mark_file.hpp"

namespace adit::tools {

class MarkServer {
 public:
  /// Listens on 127.0.0.1 and nowhere else. @param file  must outlive the server. @param port  0: any that is free.
  /// @throws io::OutputError when the port is taken.
  MarkServer(MarkFile& file, int port);
  /// Ends it; requests at work are finished.
  ~MarkServer();
  MarkServer(const MarkServer&) = delete;
  MarkServer& operator=(const MarkServer&) = delete;

  /// "http://127.0.0.1:PORT/"
  [[nodiscard]] std::string address() const;
  /// Has the page asked to end?
  [[nodiscard]] bool is_done() const noexcept;

 private:
  struct Pages;
  std::unique_ptr<Pages> pages_;
};

}  // namespace adit::tools
