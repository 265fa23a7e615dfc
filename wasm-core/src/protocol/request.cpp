#include "protocol/request.hpp"

#include "protocol/messages.generated.hpp"

namespace panicle {
namespace {

// A block's name as messages show it.
std::string_view shortened(std::string_view name) { return name.substr(0, 40); }

// The first of the values, or `otherwise` if there is none.
template <class Value>
Value first_or(std::span<const Value> values, Value otherwise) {
  return values.empty() ? otherwise : values[0];
}

}  // namespace

// A request with its blocks; `texts` and `cache` may be null.
Request::Request(std::span<const ColumnView> blocks, const CompiledTexts* texts, CacheSlot* cache)
    : blocks_(blocks), texts_(texts), cache_(cache), read_(blocks.size()) {}

// Finds the last block of that name and marks all of them as read. Null where there is none, and where it has another
// type or more than `most` numbers, which is an error.
const ColumnView* Request::find(std::string_view name, Element element, std::uint32_t most) {
  const ColumnView* found = nullptr;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (blocks_[i].name != name) continue;
    read_[i] = true;
    found = &blocks_[i];
  }
  if (found == nullptr) return nullptr;
  const bool fits = found->element == element && found->width >= 1 && found->rows <= most / found->width;
  if (!fits && trouble_.reason == Reason::none)
    trouble_ = bad_request(message(
        found->element == element ? messages::protocol::block_too_long : messages::protocol::block_of_other_type,
        shortened(name)));
  return fits ? found : nullptr;
}

// The text of a block; empty if there is none.
std::string_view Request::text(std::string_view name) {
  const ColumnView* block = find(name, Element::text, 16 * 1024 * 1024);
  return block ? block->text() : std::string_view();
}

// The same, but a missing block is an error.
std::string_view Request::required_text(std::string_view name) {
  if (!has(name) && trouble_.reason == Reason::none)
    trouble_ = bad_request(message(messages::protocol::block_missing, shortened(name)));
  return text(name);
}

// The numbers of a block; none if there is no such block. They refer to the request's bytes.
std::span<const float> Request::floats(std::string_view name) {
  const ColumnView* block = find(name, Element::float32, most_numbers);
  return block ? block->as<float>() : std::span<const float>();
}

// The same for integers.
std::span<const std::int32_t> Request::integers(std::string_view name) {
  const ColumnView* block = find(name, Element::int32, most_numbers);
  return block ? block->as<std::int32_t>() : std::span<const std::int32_t>();
}

// The same for integers without sign.
std::span<const std::uint32_t> Request::words(std::string_view name) {
  const ColumnView* block = find(name, Element::uint32, most_numbers);
  return block ? block->as<std::uint32_t>() : std::span<const std::uint32_t>();
}

// The only number of a block, or `otherwise`.
std::uint32_t Request::word(std::string_view name, std::uint32_t otherwise) { return first_or(words(name), otherwise); }

// The same for an integer.
std::int32_t Request::integer(std::string_view name, std::int32_t otherwise) {
  return first_or(integers(name), otherwise);
}

// The outline of a leaf, from five blocks.
FlatLeaf Request::flat_leaf() {
  return {floats("leaf.points"), floats("leaf.between"), floats("leaf.uvs"), words("leaf.triangles"),
          floats("leaf.petiole")};
}

// Whether a block of that name exists.
bool Request::has(std::string_view name) const {
  for (const ColumnView& block : blocks_)
    if (block.name == name) return true;
  return false;
}

// Whether the request's `outputs`, words with spaces between, name this one.
bool Request::wants(std::string_view output) {
  std::string_view words = text("outputs");
  while (!words.empty()) {
    const std::size_t end = words.find(' ');
    if (words.substr(0, end) == output) return true;
    words = end == std::string_view::npos ? std::string_view() : words.substr(end + 1);
  }
  return false;
}

// The compiled text that the request names by its handle; null, and perhaps an error, if there is none.
CompiledText Request::compiled_text() {
  const std::span<const std::uint32_t> handle = words("program");
  if (handle.empty()) return nullptr;
  CompiledText text = texts_ ? texts_->find(handle[0]) : nullptr;
  if (!text && trouble_.reason == Reason::none) trouble_ = bad_request(message(messages::protocol::program_not_stored));
  return text;
}

// The first error of reading so far, or the error for a block that nothing has read.
Diagnostic Request::trouble() const {
  if (trouble_.reason != Reason::none) return trouble_;
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    if (!read_[i]) return bad_request(message(messages::protocol::block_unknown, shortened(blocks_[i].name)));
  return {};
}

}  // namespace panicle
