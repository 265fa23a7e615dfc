#include "models/bunch/remarks.hpp"

#include <algorithm>

#include "models/bunch/messages.generated.hpp"

namespace panicle::bunch {

// Adds notes about the text, such as parameters that it does not use. `procedure`: the parameters of another one are
// not noted; nor are those in `besides`.
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

// Adds notes about a drawing without internodes, with loose balls, or without flowers.
void remark_drawn(const Drawn& drawn, std::vector<std::string>& notes) {
  if (drawn.internodes == 0) notes.push_back(message(messages::bunch::nothing_drawn));
  if (drawn.loose_balls > 0) notes.push_back(message(messages::bunch::spheres_without_line, drawn.loose_balls));
  if (drawn.internodes > 0 && drawn.balls == 0 && !drawn.refused) notes.push_back(message(messages::bunch::no_flowers));
}

}  // namespace panicle::bunch
