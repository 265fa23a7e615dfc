// Computes the numbers of a flower's volumes, record by record: with the same code when it grows and when it is placed
// anew.
#pragma once

#include <vector>

#include "models/flower/derivation.hpp"

namespace panicle::flower {

class Numbers {
 public:
  Numbers(const Program& program, FlowerEvaluation& evaluation);

  // Computes a record's values from those of earlier records. `order`: of the face that it grows on, for volumes
  // without a number of sides. First volumes of modules must come in the order of instances; their record gives the
  // call's settings. False: the evaluation's error.
  bool work_out(const Record& record, const std::vector<Record>& records, const std::vector<Instance>& instances,
                const std::vector<VolumeValues>& known, float order, VolumeValues& values);
  // The growth and the production that have a number.
  const GrowAction& growth(std::uint32_t number) const { return *growths_[number]; }
  const Production& production(std::uint32_t number) const { return *productions_[number]; }
  // Makes an instance's variables current.
  bool enter(const std::vector<Instance>& instances, std::uint32_t instance);

 private:
  // Evaluates a call's blocks for the volume that it grows from.
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
