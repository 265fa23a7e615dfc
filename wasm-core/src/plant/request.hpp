// What a model is asked: named arrays and texts, read by name. Nothing is believed: a block of another kind or size
// than its reader expects, or that no reader asks for, is an error in words.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "foundation/container.hpp"
#include "foundation/limits.hpp"
#include "foundation/result.hpp"
#include "lsystem/lsystem.hpp"
#include "plant/flat_leaf.hpp"
#include "plant/kept.hpp"
#include "plant/programs.hpp"

namespace panicle {

// Blocks that every model has: `model` (text), `seed` (uint32), `outputs` (text: words out of meshes, measures, sky,
// mesh_fingerprint), `parameters` (float32, in the order of the model's table; NaN or missing: the default), and where
// a grammar is wanted `grammar` (text) or, in its place, `program` (uint32: the handle of a compiled one) and `steps`.
class Request {
 public:
  static constexpr std::uint32_t most_numbers = 100'000;  // of one block

  // All must outlive the request. `programs` may be null where no handles are known, `kept` where nothing is kept.
  Request(std::span<const ColumnView> blocks, const Programs* programs, Keeping* kept = nullptr);

  // The notation of grammars that do not say theirs, and whether their modules keep lineages.
  void read_grammars_as(lsystem::Notation notation, lsystem::Lineages lineages) {
    notation_ = notation;
    lineages_ = lineages;
  }

  // What a block holds, rows of whatever width one after the other; nothing, zero or `otherwise` where it is absent.
  std::string_view text(std::string_view name);
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
  // The compiled grammar whose handle the block `program` holds; null where there is none.
  std::shared_ptr<const lsystem::Program> kept_program();
  // That one, or what `grammar` compiles to. Errors: those of lsystem::compile; bad_request where the
  // request has neither.
  Result<std::shared_ptr<const lsystem::Program>> program(const Limits& limits);
  // Where its model keeps what it likes between growths; null where it cannot.
  Keeping* kept() { return kept_; }
  // Once everything has been read: the first thing that was wrong, or a block that nobody has asked for.
  Diagnostic trouble() const;

 private:
  const ColumnView* find(std::string_view name, Element element, std::uint32_t most);

  std::span<const ColumnView> blocks_;
  const Programs* programs_;
  Keeping* kept_;
  lsystem::Notation notation_ = lsystem::Notation::huang;
  lsystem::Lineages lineages_ = lsystem::Lineages::always;
  std::vector<bool> read_;
  Diagnostic trouble_;
};

}  // namespace panicle
