// Compiled texts cached between growths, by handle: a drag sends the same text a hundred times.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace panicle {

// A text in the form its model grows from. Only the model that compiled it knows the type.
using CompiledText = std::shared_ptr<const void>;

class CompiledTexts {
 public:
  static constexpr std::size_t most = 64;

  // Returns a new handle, never 0; 0 where `most` texts are stored already.
  std::uint32_t add(CompiledText text) {
    if (entries_.size() >= most) return 0;
    entries_.push_back({++last_handle_, std::move(text)});
    return last_handle_;
  }
  // Null where no text has that handle.
  CompiledText find(std::uint32_t handle) const {
    for (const Entry& entry : entries_)
      if (entry.handle == handle) return entry.text;
    return nullptr;
  }
  // Removes the text of a handle, if there is one.
  void remove(std::uint32_t handle) {
    for (Entry& entry : entries_) {
      if (entry.handle != handle) continue;
      std::swap(entry, entries_.back());
      return entries_.pop_back();
    }
  }

 private:
  struct Entry {
    std::uint32_t handle;
    CompiledText text;
  };
  std::vector<Entry> entries_;
  std::uint32_t last_handle_ = 0;
};

}  // namespace panicle
