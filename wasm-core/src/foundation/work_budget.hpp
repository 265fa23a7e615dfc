// What one request may take, and what it has taken so far.
#pragma once

#include <cstdint>

namespace panicle {

// Counts units of work and bytes, never times, so that the same request ends the same way everywhere. All that one
// request does is counted here: deriving, interpreting, answering, filling polygons, making meshes. A unit of work
// takes about 20 ns natively: a production applied, 32 operations of an expression, 32 words written.
class WorkBudget {
 public:
  WorkBudget(std::uint64_t work, std::uint64_t bytes) : work_(work), bytes_(bytes) {}
  WorkBudget(const WorkBudget&) = delete;

  // Takes units of work. False: they are used up. Units are counted beyond the end as well.
  bool spend(std::uint64_t units) {
    spent_ += units;
    return spent_ <= work_;
  }
  std::uint64_t spent() const { return spent_; }
  std::uint64_t left() const { return spent_ < work_ ? work_ - spent_ : 0; }

  // Takes bytes of what is made. False: there are not as many; none are taken.
  bool hold(std::uint64_t bytes) {
    if (bytes > bytes_ - held_) return false;
    held_ += bytes;
    return true;
  }
  std::uint64_t held() const { return held_; }
  std::uint64_t bytes() const { return bytes_; }

  // While it lives, only so much of the work that is left can be spent: the rest is kept for what follows, such as
  // drawing what has been derived until then.
  class Share {
   public:
    Share(WorkBudget& budget, std::uint64_t work) : budget_(budget), whole_(budget.work_) {
      budget.work_ = budget.spent_ + (work < budget.left() ? work : budget.left());
    }
    ~Share() {
      if (budget_.spent_ > budget_.work_) budget_.spent_ = budget_.work_;  // what was refused has not been done
      budget_.work_ = whole_;
    }
    Share(const Share&) = delete;

   private:
    WorkBudget& budget_;
    std::uint64_t whole_;
  };

 private:
  std::uint64_t work_, bytes_;
  std::uint64_t spent_ = 0, held_ = 0;
};

}  // namespace panicle
