# cmake -DIN=page.html -DNAME=function -DOUT=file.cpp -P embed_page.cmake: a page for people as C++.
file(READ ${IN} text)
file(WRITE ${OUT} "// Made by tools/embed_page.cmake from ${IN}.
#include \"pages.hpp\"
namespace adit::tools {
std::string_view ${NAME}() {
  return R\"adit(${text})adit\";
}
}  // namespace adit::tools
")
