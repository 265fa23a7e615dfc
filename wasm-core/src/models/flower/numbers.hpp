// The numbers of the volumes of one flower, record by record: the same code when it grows and when it is placed anew.
#pragma once

#include <vector>

#include "models/flower/derivation.hpp"

namespace panicle::flower {

class Numbers {
 public:
  Numbers(const Program& program, FlowerEvaluation& evaluation);

  // A record's values, where those of the records before it are known. `order`: of the face that it stands on, for
  // volumes that do not say. What a module begins with comes in the order of instances, and tells what its own was
  // called with. False: the evaluation's trouble.
  bool work_out(const Record& record, const std::vector<Record>& records, const std::vector<Instance>& instances,
                const std::vector<VolumeValues>& known, float order, VolumeValues& values);
  const GrowAction& growth(std::uint32_t number) const { return *growths_[number]; }
  const Production& production(std::uint32_t number) const { return *productions_[number]; }
  // The instance whose variables are in force.
  bool enter(const std::vector<Instance>& instances, std::uint32_t instance);

 private:
  // What a call works out of what it stands on.
  bool enter_call(const Record& record, const std::vector<Record>& records, const std::vector<Instance>& instances,
                     const VolumeValues& before);
  bool of_label(const Record& record, VolumeValues& values);

  const Program& program_;
  FlowerEvaluation& evaluation_;
  std::vector<const GrowAction*> growths_;
  std::vector<const Production*> productions_;
  std::vector<GivenVariables> given_;  // by instance
  std::uint32_t entered_ = invalid;
};

}  // namespace panicle::flower
