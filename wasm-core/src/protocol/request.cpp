#include "protocol/request.hpp"

namespace panicle {
namespace {

Diagnostic refused(std::string why) { return {Reason::bad_request, std::move(why), 0, 0}; }

std::string quoted(std::string_view name) { return "“" + std::string(name.substr(0, 40)) + "”"; }

template <class Value>
Value first(std::span<const Value> values, Value otherwise) {
  return values.empty() ? otherwise : values[0];
}

}  // namespace

Request::Request(std::span<const ColumnView> blocks, const CompiledTexts* texts, CacheSlot* cache)
    : blocks_(blocks), texts_(texts), cache_(cache), read_(blocks.size()) {}

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
    trouble_ = refused("The request's block " + quoted(name) +
                       (found->element == element ? " has more values than are allowed." : " is of another kind."));
  return fits ? found : nullptr;
}

std::string_view Request::text(std::string_view name) {
  const ColumnView* block = find(name, Element::text, 16 * 1024 * 1024);
  return block ? block->text() : std::string_view();
}

std::span<const float> Request::floats(std::string_view name) {
  const ColumnView* block = find(name, Element::float32, most_numbers);
  return block ? block->as<float>() : std::span<const float>();
}

std::span<const std::int32_t> Request::integers(std::string_view name) {
  const ColumnView* block = find(name, Element::int32, most_numbers);
  return block ? block->as<std::int32_t>() : std::span<const std::int32_t>();
}

std::span<const std::uint32_t> Request::words(std::string_view name) {
  const ColumnView* block = find(name, Element::uint32, most_numbers);
  return block ? block->as<std::uint32_t>() : std::span<const std::uint32_t>();
}

std::uint32_t Request::word(std::string_view name, std::uint32_t otherwise) { return first(words(name), otherwise); }

std::int32_t Request::integer(std::string_view name, std::int32_t otherwise) {
  return first(integers(name), otherwise);
}

FlatLeaf Request::flat_leaf() {
  return {floats("leaf.points"), floats("leaf.between"), floats("leaf.uvs"), words("leaf.triangles"),
          floats("leaf.petiole")};
}

bool Request::has(std::string_view name) const {
  for (const ColumnView& block : blocks_)
    if (block.name == name) return true;
  return false;
}

bool Request::wants(std::string_view output) {
  std::string_view words = text("outputs");
  while (!words.empty()) {
    const std::size_t end = words.find(' ');
    if (words.substr(0, end) == output) return true;
    words = end == std::string_view::npos ? std::string_view() : words.substr(end + 1);
  }
  return false;
}

CompiledText Request::compiled_text() {
  const std::span<const std::uint32_t> handle = words("program");
  if (handle.empty()) return nullptr;
  CompiledText text = texts_ ? texts_->find(handle[0]) : nullptr;
  if (!text && trouble_.reason == Reason::none)
    trouble_ = refused("The request names a compiled grammar that is not kept; send its text.");
  return text;
}

Diagnostic Request::trouble() const {
  if (trouble_.reason != Reason::none) return trouble_;
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    if (!read_[i])
      return refused("The request has a block " + quoted(blocks_[i].name) + " that its model does not know.");
  return {};
}

}  // namespace panicle
