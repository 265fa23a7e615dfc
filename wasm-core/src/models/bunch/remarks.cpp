#include "models/bunch/remarks.hpp"

#include <algorithm>

namespace panicle::bunch {

void remark_text(const lsystem::BoundProgram& text, const Values& values, std::string_view procedure,
                 std::span<const Parameter> besides, std::vector<std::string>& notes) {
  std::vector<lsystem::Inputs::Scalar> used;
  for (const ParameterInfo* info : values.defining()) {
    const auto key = static_cast<Parameter>(info - parameter_table.data());
    if (!info->where.empty() && info->where != procedure) continue;
    if (std::find(besides.begin(), besides.end(), key) != besides.end()) continue;
    used.push_back({std::string(info->define), 0});
  }
  for (const lsystem::Remark& remark : lsystem::remarks(lsystem::program_of(text), used))
    notes.push_back(lsystem::to_text(remark));
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
