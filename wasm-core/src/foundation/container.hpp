// Named arrays in one block of bytes: the format of requests and responses at the boundary (exports/panicle.h).
//
// Little-endian 32-bit words; everything begins at a word:
//   0  magic 0x4c434e50 ("PNCL")
//   1  version of this layout: 3
//   2  N, number of columns
//   3  bytes of the whole block
//   4… N × 6 words, the directory: where the name begins and its bytes; the element (below); elements to a row; rows;
//      where the data begins. Places count from the block's first byte. A text has rows of one byte of UTF-8.
//   …  names and data
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "foundation/result.hpp"

namespace panicle {

enum class Element : std::uint32_t { text = 0, uint8 = 1, int32 = 2, uint32 = 3, float32 = 4 };

// The bytes of one element.
constexpr std::uint32_t bytes_of(Element element) {
  return element == Element::text || element == Element::uint8 ? 1 : 4;
}

// The kind of element for a C++ type.
template <class Value>
constexpr Element element_of() {
  if constexpr (std::is_same_v<Value, std::uint8_t>) return Element::uint8;
  if constexpr (std::is_same_v<Value, std::int32_t>) return Element::int32;
  if constexpr (std::is_same_v<Value, std::uint32_t>) return Element::uint32;
  if constexpr (std::is_same_v<Value, float>) return Element::float32;
  if constexpr (std::is_same_v<Value, char>) return Element::text;
}

// A view of a named array.
struct ColumnView {
  std::string_view name;
  Element element = Element::uint8;
  std::uint32_t width = 1;  // elements to a row
  std::uint32_t rows = 0;
  const std::uint8_t* data = nullptr;

  // The bytes of all rows.
  std::uint64_t bytes() const { return std::uint64_t{rows} * width * bytes_of(element); }
  // The elements; empty for another element type.
  template <class Value>
  std::span<const Value> as() const {
    if (element != element_of<Value>()) return {};
    return {reinterpret_cast<const Value*>(data), std::size_t{rows} * width};
  }
  // The column as text.
  std::string_view text() const {
    const std::span<const char> letters = as<char>();
    return {letters.data(), letters.size()};
  }
};

// Reads a block, which must begin at a word and outlive the views that are returned. No byte outside the block is read,
// for any content. Errors: bad_request.
Result<std::vector<ColumnView>> read_container(std::span<const std::uint8_t> bytes);

// Collects columns and writes them into one block. `add` refers to the caller's values until `write`; `copy` and names
// are stored by the writer.
class ContainerWriter {
 public:
  template <class Value>
  void add(std::string name, std::span<const Value> values, std::uint32_t width = 1) {
    add({}, std::move(name), element_of<Value>(), width, values.size() / width,
        reinterpret_cast<const std::uint8_t*>(values.data()));
  }
  template <class Value>
  void add(std::string name, const std::vector<Value>& values, std::uint32_t width = 1) {
    add(std::move(name), std::span<const Value>(values), width);
  }
  void add(std::string name, std::string_view text) {
    add(std::move(name), std::span<const char>(text.data(), text.size()));
  }
  void add(std::string name, const ColumnView& column) {
    add({}, std::move(name), column.element, column.width, column.rows, column.data);
  }

  // Adds a column that the writer copies, and that is always written into the block.
  template <class Value>
  void copy(std::string name, std::span<const Value> values, std::uint32_t width = 1) {
    add(std::move(name), values, width);
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(values.data());
    entries_.back().own.emplace(bytes, bytes + values.size_bytes());
  }
  template <class Value>
  void copy(std::string name, const std::vector<Value>& values, std::uint32_t width = 1) {
    copy(std::move(name), std::span<const Value>(values), width);
  }
  void copy(std::string name, std::string_view text) {
    copy(std::move(name), std::span<const char>(text.data(), text.size()));
  }

  // The block, from malloc: free it with std::free. Null when memory is out or the block would pass 2 GiB.
  std::uint8_t* write() const { return write(no_limit); }

  // The same, but added columns of `large` bytes or more are not copied: the directory has their addresses relative to
  // the block's first byte, modulo 2^32 (the range of a 32-bit memory). They must outlive the block.
  std::uint8_t* write(std::uint64_t large) const;

 private:
  static constexpr std::uint64_t no_limit = ~std::uint64_t{0};
  struct Raw {};
  struct Entry {
    std::string name;
    Element element;
    std::uint32_t width, rows;
    const std::uint8_t* data;
    std::optional<std::vector<std::uint8_t>> own;  // of a copy: its bytes
  };
  void add(Raw, std::string name, Element element, std::uint32_t width, std::size_t rows, const std::uint8_t* data);

  std::vector<Entry> entries_;
};

// Bytes of a block that `write` made.
std::uint32_t container_bytes(const std::uint8_t* block);

}  // namespace panicle
