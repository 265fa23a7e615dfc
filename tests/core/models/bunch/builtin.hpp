// The bunch's grammars by the number of their L-system.
#pragma once

#include <string_view>

#include "models/bunch/grammars.hpp"

namespace panicle::bunch {

inline std::string_view builtin_grammar(int number) {
  const std::string_view texts[] = {grammars::grape_bunch_1, grammars::grape_bunch_2, grammars::grape_bunch_3,
                                    grammars::grape_bunch_4};
  return texts[number - 1];
}

}  // namespace panicle::bunch
