// The work and memory that one request may use, and has used so far.
#pragma once

#include <cstdint>

namespace panicle {

// Counts units of work and bytes, so that the same request ends the same way everywhere. All that one request does is
// counted here: deriving, interpreting, answering, filling polygons, making meshes. A unit of work takes about 20 ns
// natively: a production applied, 32 operations of an expression, 32 words written.
//
// A caller that limits the time of a request passes a clock as well. Its time is divided as the work is: a share that
// ends at three quarters of the work ends at three quarters of the time, too. A request that ends within its time is
// not changed by the clock.
class WorkBudget {
 public:
  // Returns the share of the time limit that has passed: 0 where there is no limit, 1 or more when the time is over.
  using TimePassed = double (*)();
  // Units of work between two looks at the clock: about a millisecond.
  static constexpr std::uint64_t look_interval = 1 << 16;

  WorkBudget(std::uint64_t work, std::uint64_t bytes, TimePassed time_passed = nullptr)
      : total_(work), work_(work), bytes_(bytes), time_passed_(time_passed) {
    look_again();
  }
  WorkBudget(const WorkBudget&) = delete;

  // Takes units of work. False: they are used up, or the time is. Units are counted beyond the end as well.
  bool spend(std::uint64_t units) {
    spent_ += units;
    if (spent_ >= next_look_) look_at_clock();
    return spent_ <= work_ && !time_is_over_;
  }
  std::uint64_t spent() const { return spent_; }
  std::uint64_t left() const { return spent_ < work_ ? work_ - spent_ : 0; }

  // Looks at the clock, for work that is counted elsewhere. True: the time is over, and no more work can be spent.
  bool look_at_clock() {
    if (time_passed_ == nullptr) return false;
    next_look_ = spent_ + look_interval;
    time_is_over_ = time_passed_() * static_cast<double>(total_) >= static_cast<double>(work_);
    time_has_ended_work_ |= time_is_over_;
    return time_is_over_;
  }
  // Whether the time of this share is over.
  bool time_is_over() const { return time_is_over_; }
  // Whether the time of any share was over before its work was.
  bool time_has_ended_work() const { return time_has_ended_work_; }
  // The function that reports whether the time is over; may be null.
  TimePassed clock() const { return time_passed_; }

  // Takes bytes of memory for results. False: fewer are left; none are taken.
  bool hold(std::uint64_t bytes) {
    if (bytes > bytes_ - held_) return false;
    held_ += bytes;
    return true;
  }
  // The bytes held so far, and their limit.
  std::uint64_t held() const { return held_; }
  std::uint64_t bytes() const { return bytes_; }

  // While it lives, only so much of the remaining work can be spent: the rest is reserved for later stages, such as
  // drawing the string derived so far.
  class Share {
   public:
    // Limits the work to `work` units more until the share ends.
    Share(WorkBudget& budget, std::uint64_t work) : budget_(budget), whole_(budget.work_) {
      budget.work_ = budget.spent_ + (work < budget.left() ? work : budget.left());
      budget.look_again();
    }
    ~Share() {
      // Refused work has not been done. Where the time ended, the work of its share is lost.
      if (budget_.spent_ > budget_.work_ || budget_.time_is_over_) budget_.spent_ = budget_.work_;
      budget_.work_ = whole_;
      budget_.look_again();
    }
    Share(const Share&) = delete;

   private:
    WorkBudget& budget_;
    std::uint64_t whole_;
  };

 private:
  // Prepares for another end of the work.
  void look_again() {
    time_is_over_ = false;
    next_look_ = time_passed_ == nullptr ? ~std::uint64_t{0} : spent_;
  }

  std::uint64_t total_, work_, bytes_;
  TimePassed time_passed_;
  std::uint64_t spent_ = 0, held_ = 0;
  std::uint64_t next_look_ = 0;
  bool time_is_over_ = false, time_has_ended_work_ = false;
};

}  // namespace panicle
