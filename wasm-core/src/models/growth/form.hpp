// The shape of a population: which way each of its shoots goes and how far (Kim, Kim and Cho 2013, section 3.1 and
// figure 2; what print leaves open is told in docs/models/growth/growth.md). Metres, +Y up.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "models/growth/population.hpp"
#include "models/growth/surroundings.hpp"

namespace panicle::growth {

struct FormHabit {
  float shoot = 0.9f;  // metres of a branch's first internode, in a volume 10 m high
  float order_ratio = 0.78f, age_ratio = 0.93f;
  float bole = 0.16f;                         // share of the height without branches
  float leader = 0.97f;                       // share of the height that the trunk reaches
  float trunk_angle = 60, branch_angle = 45;  // degrees between a branch and what bears it
  float turn = 137.5f;                        // degrees from one branch to the next
  float inertia = 1, space = 0.7f, crook = 0.08f;
  float hang = 0;    // gravitropism of branches of branches, besides the text's
  float reach = 0;   // how far lengths of the trunk's branches are those that come to the volume's edge, 0 … 1
  float whorl = 0;   // how near to its end an internode bears its branches, 0 … 1
  float flat = 0;    // how level branches of branches leave, 0 … 1
  float cordon = 0;  // metres, where a trunk is bent level, along a wire; 0: not trained
  std::uint64_t seed = 1;
};

// A shoot: internodes between nodes, the first of which is where it begins.
struct Way {
  std::uint32_t first = 0;  // its first node, in Form::nodes
  std::uint32_t count = 0;  // internodes, one more node
  std::uint16_t from = 0;   // the step that lays the first of them
  // On its parent: which of that one's internodes, and how far along it.
  std::uint32_t internode = 0;
  float along = 0;
};

// Whole, as after all steps: an earlier age is a part of it, since an internode that has been laid stays as it is.
struct Form {
  std::vector<Way> ways;  // one a shoot
  std::vector<glm::vec3> nodes;
};

Form form_of(const Population& population, const FormHabit& habit, const Surroundings& about = {});

}  // namespace panicle::growth
