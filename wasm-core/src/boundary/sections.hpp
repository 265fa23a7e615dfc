// A grown bunch, or the reason why there is none, as the flat sections of panicle.h.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "models/bunch/grown.hpp"
#include "foundation/result.hpp"
#include "boundary/panicle.h"

namespace panicle::boundary {

// Owns what it shows: either the grown bunch's own arrays or a packed copy.
class Sections {
 public:
  explicit Sections(const Diagnostic& diagnostic);
  explicit Sections(bunch::Grown grown);
  Sections(const Sections&) = delete;
  Sections& operator=(const Sections&) = delete;

  // Empty for a section that is not there.
  std::span<const std::uint8_t> section(std::uint32_t id) const;

 private:
  void pack_plan(std::uint32_t id, const bunch::Plan& plan);
  void pack_skeleton();
  void pack_natural();
  void pack_meshes();
  void show_mesh(std::uint32_t first, const Mesh& mesh);
  void pack(std::uint32_t id, std::vector<std::uint32_t> words);
  template <class Value>
  void show(std::uint32_t id, const std::vector<Value>& values);

  bunch::Grown grown_;
  std::string text_;
  std::array<std::vector<std::uint32_t>, PANICLE_SECTION_COUNT> packed_;
  std::array<std::span<const std::uint8_t>, PANICLE_SECTION_COUNT> sections_ = {};
};

}  // namespace panicle::boundary
