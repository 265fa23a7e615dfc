// Compiled grammars kept between growths, by handle: a drag sends the same text a hundred times.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <utility>

#include "lsystem/lsystem.hpp"

namespace panicle {

class Programs {
 public:
  static constexpr std::size_t most = 64;

  // A handle that was never given before, never 0; 0 where `most` are kept already.
  std::uint32_t keep(std::shared_ptr<const lsystem::Program> program) {
    if (kept_.size() >= most) return 0;
    kept_.emplace(++last_, std::move(program));
    return last_;
  }
  // Null where nothing is kept by that handle.
  std::shared_ptr<const lsystem::Program> find(std::uint32_t handle) const {
    const auto found = kept_.find(handle);
    return found == kept_.end() ? nullptr : found->second;
  }
  void forget(std::uint32_t handle) { kept_.erase(handle); }

 private:
  std::map<std::uint32_t, std::shared_ptr<const lsystem::Program>> kept_;
  std::uint32_t last_ = 0;
};

}  // namespace panicle
