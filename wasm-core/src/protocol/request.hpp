// A request to a model: named arrays and texts, read by name. Everything is validated: a block of another type or size
// than its reader expects, or that no reader uses, is an error.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "foliage/flat_leaf.hpp"
#include "foundation/container.hpp"
#include "foundation/limits.hpp"
#include "foundation/result.hpp"
#include "protocol/cache.hpp"
#include "protocol/compiled_texts.hpp"

namespace panicle {

// Blocks that every model has (common_request.hpp reads them): `model` (text), `seed` (uint32), `outputs` (text: words
// out of meshes, measures, sky, mesh_fingerprint), `parameters` (float32, in the order of the model's table; NaN or
// missing: the default), and where a grammar is wanted `grammar` (text) or, in its place, `program` (uint32: the handle
// of a compiled one) and `steps`.
class Request {
 public:
  static constexpr std::uint32_t most_numbers = 100'000;  // of one block

  // All must outlive the request. `texts` may be null where no handles are known, `cache` where nothing is cached.
  Request(std::span<const ColumnView> blocks, const CompiledTexts* texts, CacheSlot* cache = nullptr);

  // The values of a block, rows one after the other; empty, zero or `otherwise` where it is absent.
  std::string_view text(std::string_view name);
  // The same; a request without the block has an error.
  std::string_view required_text(std::string_view name);
  std::span<const float> floats(std::string_view name);
  std::span<const std::int32_t> integers(std::string_view name);
  std::span<const std::uint32_t> words(std::string_view name);
  std::uint32_t word(std::string_view name, std::uint32_t otherwise = 0);
  std::int32_t integer(std::string_view name, std::int32_t otherwise = 0);
  bool has(std::string_view name) const;
  // Blocks: `leaf.points`, `leaf.between`, `leaf.uvs`, `leaf.petiole` (float32), `leaf.triangles` (uint32); not
  // checked.
  FlatLeaf flat_leaf();

  // Whether `outputs` names this one.
  bool wants(std::string_view output);
  // The compiled text whose handle the block `program` holds; null where the request has no such block.
  CompiledText compiled_text();
  // The model's cache between growths; null where nothing is cached.
  CacheSlot* cache() { return cache_; }
  // The first error in the blocks read so far; reason none where there is none.
  const Diagnostic& first_trouble() const { return trouble_; }
  // Call it once everything has been read: returns that error, or one for a block that the model has not read.
  Diagnostic trouble() const;

 private:
  const ColumnView* find(std::string_view name, Element element, std::uint32_t most);

  std::span<const ColumnView> blocks_;
  const CompiledTexts* texts_;
  CacheSlot* cache_;
  std::vector<bool> read_;
  Diagnostic trouble_;
};

}  // namespace panicle
