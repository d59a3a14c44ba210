#include "pages.hpp"

namespace adit::tools {

std::string filled_page(std::string_view page, const std::vector<std::pair<std::string_view, std::string>>& parts) {
  std::string text;
  while (true) {
    std::size_t at = std::string_view::npos;
    const std::pair<std::string_view, std::string>* next = nullptr;
    for (const auto& part : parts)
      if (const std::size_t here = page.find(part.first); here < at) {
        at = here;
        next = &part;
      }
    text += page.substr(0, at);
    if (next == nullptr) return text;
    text += next->second;
    page.remove_prefix(at + next->first.size());
  }
}

std::string joined(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) text += part;
  return text;
}

std::string html_of(std::string_view text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      case '\'':
        html += "&#39;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

}  // namespace adit::tools
