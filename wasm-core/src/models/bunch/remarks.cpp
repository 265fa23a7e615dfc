#include "models/bunch/remarks.hpp"

#include <algorithm>

namespace panicle::bunch {

void remark_unknown(const lsystem::Bound& text, const Values& values, std::string_view procedure,
                    std::vector<std::string>& notes) {
  const std::span<const lsystem::Definition> known = lsystem::definitions(text);
  for (const ParameterInfo* info : values.defining()) {
    if (!info->where.empty() && info->where != procedure) continue;
    if (std::any_of(known.begin(), known.end(), [info](const auto& one) { return one.name == info->define; })) continue;
    notes.push_back("The grammar has no #define " + std::string(info->define) + ", so its parameter changes nothing.");
  }
}

void remark_drawn(const Drawn& drawn, std::vector<std::string>& notes) {
  if (drawn.internodes == 0) notes.push_back("The grammar drew nothing.");
  if (drawn.loose_balls == 1)
    notes.push_back("One sphere of the grammar hangs on no line and was left out; draw an F before it.");
  if (drawn.loose_balls > 1)
    notes.push_back(std::to_string(drawn.loose_balls) +
                    " spheres of the grammar hang on no line and were left out; draw an F before each.");
  if (drawn.internodes > 0 && drawn.balls == 0 && !drawn.refused)
    notes.push_back("The grammar bears no flowers, for it draws no sphere (S) on any line.");
}

}  // namespace panicle::bunch
