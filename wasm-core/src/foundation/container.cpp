#include "foundation/container.hpp"

#include <cstdlib>
#include <cstring>
#include <utility>

#include "foundation/messages.generated.hpp"

namespace panicle {
namespace {

constexpr std::uint32_t magic = 0x4c434e50;  // "PNCL"
constexpr std::uint32_t layout = 3;
constexpr std::uint32_t header_words = 4, entry_words = 6;
constexpr std::uint32_t max_columns = 4096;
constexpr std::uint64_t max_bytes = 0x7fffffff;

// A number of bytes, rounded up to whole words of four.
constexpr std::uint64_t padded(std::uint64_t bytes) { return (bytes + 3) & ~std::uint64_t{3}; }

// The word at `index` words from the start of the bytes.
std::uint32_t word(const std::uint8_t* bytes, std::size_t index) {
  std::uint32_t value;
  std::memcpy(&value, bytes + index * 4, 4);
  return value;
}

// Reads one entry of the directory; false if its name or data lie outside the bytes.
bool read_entry(std::span<const std::uint8_t> bytes, std::size_t entry, ColumnView& column) {
  const std::size_t row = header_words + entry * entry_words;
  const std::uint64_t name = word(bytes.data(), row), letters = word(bytes.data(), row + 1);
  const std::uint32_t element = word(bytes.data(), row + 2);
  const std::uint64_t data = word(bytes.data(), row + 5);
  if (element > static_cast<std::uint32_t>(Element::float32)) return false;
  column.element = static_cast<Element>(element);
  column.width = word(bytes.data(), row + 3);
  column.rows = word(bytes.data(), row + 4);
  if (column.width == 0 || column.width > 64) return false;
  if (name + letters > bytes.size() || data % 4 != 0 || data + column.bytes() > bytes.size()) return false;
  column.name = {reinterpret_cast<const char*>(bytes.data() + name), static_cast<std::size_t>(letters)};
  column.data = bytes.data() + data;
  return true;
}

}  // namespace

// Reads the directory of a container: a header, entries of the columns, then names and data. The views refer to the
// bytes.
Result<std::vector<ColumnView>> read_container(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < header_words * 4 || reinterpret_cast<std::uintptr_t>(bytes.data()) % 4 != 0)
    return bad_request(message(messages::foundation::request_shorter_than_header));
  if (word(bytes.data(), 0) != magic) return bad_request(message(messages::foundation::request_without_magic_number));
  if (word(bytes.data(), 1) != layout) return bad_request(message(messages::foundation::request_of_other_version));
  const std::uint64_t count = word(bytes.data(), 2);
  if (count > max_columns || word(bytes.data(), 3) != bytes.size() ||
      (header_words + count * entry_words) * 4 > bytes.size())
    return bad_request(message(messages::foundation::request_length_differs));
  std::vector<ColumnView> columns(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (!read_entry(bytes, i, columns[i]))
      return bad_request(message(messages::foundation::request_directory_out_of_range));
  return columns;
}

// Adds a column whose data remain where they are until `write`.
void ContainerWriter::add(Raw, std::string name, Element element, std::uint32_t width, std::size_t rows,
                          const std::uint8_t* data) {
  entries_.push_back({std::move(name), element, width, static_cast<std::uint32_t>(rows), data, {}});
}

// Writes the container into memory that the caller frees; null if it would be too large. Columns of `large` bytes and
// more are not copied: their offset leads to the original, modulo 2^32.
std::uint8_t* ContainerWriter::write(std::uint64_t large) const {
  const auto size = [](const Entry& entry) {
    return std::uint64_t{entry.rows} * entry.width * bytes_of(entry.element);
  };
  const auto inside = [&](const Entry& entry) { return entry.own || size(entry) < large; };
  std::uint64_t whole = (header_words + entry_words * entries_.size()) * 4;
  for (const Entry& entry : entries_) whole += padded(entry.name.size()) + (inside(entry) ? padded(size(entry)) : 0);
  if (whole > max_bytes) return nullptr;
  auto* const block = static_cast<std::uint8_t*>(std::malloc(static_cast<std::size_t>(whole)));
  if (block == nullptr) return nullptr;

  std::uint64_t at = (header_words + entry_words * entries_.size()) * 4;
  // Copies bytes to the next free place, and pads to a word with zeros.
  const auto place = [&](const void* bytes, std::uint64_t length) {
    const auto begin = static_cast<std::uint32_t>(at);
    if (length > 0) std::memcpy(block + at, bytes, static_cast<std::size_t>(length));
    std::memset(block + at + length, 0, static_cast<std::size_t>(padded(length) - length));
    at += padded(length);
    return begin;
  };
  const std::uint32_t header[header_words] = {magic, layout, static_cast<std::uint32_t>(entries_.size()),
                                              static_cast<std::uint32_t>(whole)};
  std::memcpy(block, header, sizeof header);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry& entry = entries_[i];
    const std::uint32_t name = place(entry.name.data(), entry.name.size());
    const std::uint32_t data = inside(entry) ? place(entry.own ? entry.own->data() : entry.data, size(entry))
                                             : static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(entry.data) -
                                                                          reinterpret_cast<std::uintptr_t>(block));
    const std::uint32_t row[entry_words] = {name,
                                            static_cast<std::uint32_t>(entry.name.size()),
                                            static_cast<std::uint32_t>(entry.element),
                                            entry.width,
                                            entry.rows,
                                            data};
    std::memcpy(block + (header_words + i * entry_words) * 4, row, sizeof row);
  }
  return block;
}

// The number of bytes of a container; 0 for null.
std::uint32_t container_bytes(const std::uint8_t* block) { return block ? word(block, 3) : 0; }

}  // namespace panicle
