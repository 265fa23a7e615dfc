// Compiled grammars kept between growths, by handle: a drag sends the same text a hundred times.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "lsystem/lsystem.hpp"

namespace panicle {

class Programs {
 public:
  static constexpr std::size_t most = 64;

  // A handle that was never given before, never 0; 0 where `most` are kept already.
  std::uint32_t keep(std::shared_ptr<const lsystem::Program> program) {
    if (kept_.size() >= most) return 0;
    kept_.push_back({++last_, std::move(program)});
    return last_;
  }
  // Null where nothing is kept by that handle.
  std::shared_ptr<const lsystem::Program> find(std::uint32_t handle) const {
    for (const Kept& kept : kept_)
      if (kept.handle == handle) return kept.program;
    return nullptr;
  }
  void forget(std::uint32_t handle) {
    for (Kept& kept : kept_) {
      if (kept.handle != handle) continue;
      std::swap(kept, kept_.back());
      return kept_.pop_back();
    }
  }

 private:
  struct Kept {
    std::uint32_t handle;
    std::shared_ptr<const lsystem::Program> program;
  };
  std::vector<Kept> kept_;
  std::uint32_t last_ = 0;
};

}  // namespace panicle
