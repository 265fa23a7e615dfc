// The bunch's grammars, compiled in without their comments: wasm-core/grammars/bunch. The paper's first two are for
// those who ask for them; a module that nobody asks holds none of what it does not use.
#pragma once

#include <string_view>

namespace panicle::bunch::grammars {

extern const std::string_view grape_bunch_1;  // L-system 1: in the plane
extern const std::string_view grape_bunch_2;  // L-system 2: open, in the plane
extern const std::string_view grape_bunch_3;  // L-system 3: the paper's procedure
extern const std::string_view grape_bunch_4;  // the natural procedure's

}  // namespace panicle::bunch::grammars
