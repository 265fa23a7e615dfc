// The bunch's grammars, compiled in without their comments: wasm-core/grammars/bunch. L-systems 1 and 2 are used only
// by requests that name them; a WebAssembly module that does not reference them does not contain them.
#pragma once

#include <string_view>

namespace panicle::bunch::grammars {

extern const std::string_view grape_bunch_1;  // L-system 1: in the plane
extern const std::string_view grape_bunch_2;  // L-system 2: open, in the plane
extern const std::string_view grape_bunch_3;  // L-system 3: the paper's procedure
extern const std::string_view grape_bunch_4;  // the natural procedure's

}  // namespace panicle::bunch::grammars
