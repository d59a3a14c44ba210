// Structs of the C interface cross versions: each side knows a part of the other's, and says how much.
#pragma once

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>

namespace adit::c_interface {

/// What the caller gave, with zeros for what it does not know of. @throws std::invalid_argument
template <class Struct>
Struct read_sized(const Struct* given, const char* name) {
  if (given == nullptr) throw std::invalid_argument(std::string(name) + " is a null pointer");
  if (given->struct_size <= sizeof(std::size_t))
    throw std::invalid_argument(std::string(name).append(".struct_size is not set; begin with ADIT_INIT"));
  Struct known{};
  std::memcpy(&known, given, std::min(given->struct_size, sizeof(Struct)));
  known.struct_size = sizeof(Struct);
  return known;
}

/// Gives the caller the part it knows of, and zeros where it knows more. @throws std::invalid_argument
template <class Struct>
void write_sized(const Struct& answer, Struct* wanted, const char* name) {
  if (wanted == nullptr) throw std::invalid_argument(std::string(name) + " is a null pointer");
  const std::size_t size = wanted->struct_size;
  if (size <= sizeof(std::size_t))
    throw std::invalid_argument(std::string(name).append(".struct_size is not set; begin with ADIT_INIT"));
  std::memcpy(static_cast<void*>(wanted), &answer, std::min(size, sizeof(Struct)));
  if (size > sizeof(Struct)) std::memset(reinterpret_cast<char*>(wanted) + sizeof(Struct), 0, size - sizeof(Struct));
  wanted->struct_size = size;
}

}  // namespace adit::c_interface
