# cmake -DIN=file.jpg -DOUT=file.cpp -P embed.cmake: the bytes of data/tunnel.jpg as C++.
file(READ ${IN} bytes HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
string(REGEX REPLACE "(0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,)" "\\1\n" bytes
       "${bytes}")
file(WRITE ${OUT} "// Made by tools/embed.cmake from ${IN}.
#include \"drawn_frame.hpp\"
namespace adit::tools {
namespace {
constexpr std::uint8_t kBytes[] = {
${bytes}};
}
std::span<const std::uint8_t> drawn_frame() { return kBytes; }
}  // namespace adit::tools
")
