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

}  // namespace adit::tools
