// The plan of a natural bunch before it grows: lengths fitted to the outline, and the number of berries that fill it.
#pragma once

#include <vector>

#include "lsystem/lsystem.hpp"
#include "models/bunch/paper/envelope.hpp"
#include "models/bunch/plan.hpp"
#include "models/bunch/values.hpp"

namespace panicle::bunch {

// Constants of the text that the plan needs to place the same rachis as the text. Defaults are L-system 4's, and apply
// where a text has no such constant.
struct TextConstants {
  float tip_spacing = 0.6f;   // `near`: spacing of the rachis's nodes at its tip, over the spacing above
  float tip_share = 0.4f;     // `tip`: share of the rachis over which they draw together
  float turn = 137.5f;        // `turn`: from one axis to the next, round the rachis; degrees
  float yaw = 60;             // `alpha_y`: of axes, twigs and pedicels; degrees, to either side
  float lateral = 0.6f;       // `lateral`: an axis of second order and a stride, over the rest of its parent
  float flowers_per_end = 3;  // on an end structure; counted when it is drawn
  float wider = 1;            // nodes' distances over the usual ones; above 1 where those draw too many flowers
  bool operator==(const TextConstants&) const = default;
};

// The constants of `text`; `flowers_per_end` and `wider` as in `before`.
TextConstants constants_of(const lsystem::BoundProgram& text, const TextConstants& before);

// The plan of a bunch: millimetres and degrees. Everything but the number of axes changes smoothly with the profile; a
// new axis begins with length 0.
struct NaturalPlan {
  Plan plan;  // the paper's counts, for display
  Envelope envelope;
  float length = 0;                // of the rachis
  float spacing = 0;               // between its nodes
  float first_order_spacing = 0;   // between the nodes of a first-order axis
  float second_order_spacing = 0;  // between those of a second-order axis
  float twig = 0, pedicel_length = 0;
  float rachis_width = 0, pedicel_width = 0;
  std::vector<float> arm = {};     // length of each first-order axis from the top; below 0 a raceme's single pedicel
  std::vector<float> way = {};     // its azimuth round the rachis, degrees
  std::vector<float> aim = {};     // its angle to the rachis
  std::vector<float> node = {};    // number of its first node among the nodes of all axes, from 1
  std::vector<float> beyond = {};  // of each node: how far beyond its twig an axis of second order may go
  float berries = 0;  // how many there are to be: as requested, or enough to fill the outline to the requested density
  float berry = 0;    // volume of one
  float room = 0;     // upper bound of the number of berries: somewhat more than the outline's volume
  bool overfull = false;  // whether the density would require more berries than allowed
};

// Plans a bunch from its outline and parameters: first the sizes of its parts, then how many berries are wanted and
// have room, then the nodes, set closer step by step until there are enough flowers for the berries. `start`: the
// azimuth of the first axis if all sides were alike; degrees.
NaturalPlan make_natural_plan(const Profile& profile, const Values& values, float max_berries,
                              const TextConstants& text = {}, float start = 0);

// The share of the outline's volume that berries of a density (OIV 204, 1 … 9) usually take; the start value of
// fill_for.
float fill_of(float density);

// The inputs of L-system 4, in the paper's unit; the paper's own texts find theirs too, from `plan`. `arm`, `way`,
// `aim` and `node` repeat their last value beyond the plan's axes, and `beyond` continues with 0, for texts with more
// nodes than the plan.
lsystem::Inputs inputs_for(const NaturalPlan& plan, const Profile& profile, const Values& values);

}  // namespace panicle::bunch
