// The work that queries of the meshes of one plant may take: bounds that are counted, not timed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "foundation/limits.hpp"
#include "foundation/result.hpp"

namespace panicle {

// Counts examined triangles in inside tests of meshes. Shared by all meshes of one plant.
class QueryBudget {
 public:
  static constexpr std::uint64_t usual = Limits{}.looks;

  // Entries of the indices of all meshes together: 64 MiB.
  static constexpr std::size_t usual_members = 1 << 22;

  // The entries are divided evenly among `meshes`, at least four.
  explicit QueryBudget(std::uint64_t looks = usual, std::size_t meshes = 4)
      : left_(looks), members_each_(usual_members / std::max<std::size_t>(meshes, 4)) {}

  // The most entries that the index of one mesh may have.
  std::size_t members_each() const { return members_each_; }

  // Takes looks, units of search work, from the budget.
  void spend(std::uint64_t looks) { left_ = looks < left_ ? left_ - looks : 0; }
  bool is_exhausted() const { return left_ == 0; }
  std::uint64_t left() const { return left_; }
  // The error of a plant whose budget is used up. Reason: limit.
  static Diagnostic error();

 private:
  std::uint64_t left_;
  std::size_t members_each_;
};

// The error of a request whose meshes have more triangles than `limits` allow. Reason: limit. None where they have not.
std::optional<Diagnostic> too_many_triangles(std::size_t triangles, const Limits& limits);

}  // namespace panicle
